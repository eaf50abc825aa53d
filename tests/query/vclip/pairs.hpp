// Pairs of convex polyhedra in special positions: that share a corner, an edge or a face, an ulp apart, one within the
// other, of scales 2^60 apart, with corners in their straight edges and flat faces.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "figure/basic/shape_cases.hpp"
#include "plumb/figure.hpp"
#include "query/body/pair_shapes.hpp"

namespace plumb::clip_cases {

using shape_cases::Material;

struct Pair {
  ConvexPolyhedron3 a, b;
  std::string name;
};

/// With all that lies in its faces and edges as corners of them.
inline ConvexPolyhedron3 solid_of(const std::vector<Point3>& points, bool boundary, bool triangles) {
  const Hull3 hull = convex_hull(points, {.triangulate = triangles, .all_boundary_points = boundary});
  PolygonMesh mesh{{}, {}, hull.first};
  std::vector<std::uint32_t> number(points.size(), 0);
  for (const std::uint32_t v : hull.corners) {
    if (number[v] == 0) {
      mesh.vertices.push_back(points[v]);
      number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
    }
    mesh.corners.push_back(number[v] - 1);
  }
  return convex_polyhedron(std::move(mesh));
}

inline std::vector<Point3> box_points(Entropy& e) {
  const double x = 2 * static_cast<double>(e.within(3)), y = 2 * static_cast<double>(e.within(3)),
               z = 2 * static_cast<double>(e.within(3));
  const double w = 2 + 2 * static_cast<double>(e.below(2)), h = 2 + 2 * static_cast<double>(e.below(2)),
               d = 2 + 2 * static_cast<double>(e.below(2));
  std::vector<Point3> points;
  for (const double i : {0.0, w / 2, w}) {
    for (const double j : {0.0, h / 2, h}) {
      for (const double k : {0.0, d / 2, d}) points.push_back({x + i, y + j, z + k});
    }
  }
  return points;
}

inline double unit(Entropy& e) { return static_cast<double>(e.bits(53)) * 0x1p-53; }

inline Point3 scaled(const Point3& p, double by) { return {p.x * by, p.y * by, p.z * by}; }

inline std::vector<Point3> some_points(Entropy& e, std::size_t n) {
  std::vector<Point3> points(n);
  const bool whole = e.coin();
  for (Point3& p : points) {
    const auto number = [&] { return whole ? static_cast<double>(e.within(4)) : 2 * unit(e) - 1; };
    p = {number(), number(), number()};
  }
  for (const double s : {-1.0, 1.0})
    points.push_back({s / 2, 0, 0}), points.push_back({0, s / 2, 0}), points.push_back({0, 0, s / 2});
  return points;
}

/// Moved by the difference of two points, so that these are one.
inline void move(std::vector<Point3>& points, const Point3& from, const Point3& to) {
  for (Point3& p : points) p = {p.x + (to.x - from.x), p.y + (to.y - from.y), p.z + (to.z - from.z)};
}

inline Pair pair_of(std::uint64_t start, std::uint64_t index) {
  Entropy e(start, index);
  const std::string name = "pair " + std::to_string(start) + ":" + std::to_string(index);
  const auto solid = [&](const std::vector<Point3>& points) {
    const bool boundary = e.coin();
    return solid_of(points, boundary, e.coin());
  };
  const std::size_t n = 2 + e.below(10);
  std::vector<Point3> p = e.coin() ? some_points(e, n) : box_points(e),
                      q = e.coin() ? some_points(e, n) : box_points(e);
  switch (e.below(8)) {
    case 0:
      move(q, q[e.below(q.size())], p[e.below(p.size())]);
      break;
    case 1: {  // mirrored at a coordinate's greatest value: it shares what is there, or is an ulp away
      const double most = std::ranges::max_element(p, {}, &Point3::x)->x, by = e.coin() ? 0 : most + 1;
      const double gap = std::nextafter(most, most + by) - most;
      q = p;
      for (Point3& r : q) r.x = 2 * most - r.x + gap;
      break;
    }
    case 2: {  // far smaller
      const double by = std::ldexp(1.0, -static_cast<int>(e.below(61)));
      for (Point3& r : q) r = scaled(r, by);
      if (e.coin()) move(q, q[e.below(q.size())], p[e.below(p.size())]);
      break;
    }
    case 3:
      move(q, {0, 0, 0}, {8 * (unit(e) - 0.5), 3, 1});
      break;
    case 4:
      move(q, {0, 0, 0}, {static_cast<double>(e.within(6)), static_cast<double>(e.within(6)), 4});
      break;
    case 5:
      move(q, {0, 0, 0}, {20, static_cast<double>(e.within(3)), 1});
      break;
    case 6: {  // an ulp from a shared corner
      const Point3 at = p[e.below(p.size())];
      move(q, q[e.below(q.size())],
           {std::nextafter(at.x, 100.0), at.y, std::nextafter(at.z, e.coin() ? 100.0 : -100.0)});
      break;
    }
    default:
      break;
  }
  if (convex_hull(q).dimension < 3)
    return pair_of(start + 1000, index);  // too small to be told apart where it was moved to
  return {solid(p), solid(q), name};
}

}  // namespace plumb::clip_cases

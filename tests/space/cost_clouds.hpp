// What are questions asked of where their costs are counted?  Points of ordinary exponents, and points whose exponents
// span all that doubles have, with the figures made of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "plumb/degenerate.hpp"
#include "plumb/plumb.hpp"

namespace plumb::cost {

/// Two sets of points, and what is made of them before counting.
struct Cloud {
  std::vector<Point3> a, b;
  std::vector<Point2> flat;
  ConvexPolyhedron3 p, q;
  TriangleMesh mesh, other;
  std::vector<Aabb3> boxes;
  std::vector<Triangle3> triangles;
};

enum class Exponents { ordinary, of_points, of_coordinates };

inline TriangleMesh strip_of(const std::vector<Point3>& points) {
  TriangleMesh mesh{points, {}};
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

inline Cloud cloud(Exponents exponents, std::size_t size, std::uint64_t index) {
  Entropy entropy(501, index);
  const auto any_exponent = [&] { return static_cast<int>(entropy.below(1429)) - 801; };
  const auto set = [&] {
    std::vector<Point3> points(size);
    for (Point3& p : points) {
      const int common = exponents == Exponents::of_points ? any_exponent() : 0;
      const auto number = [&] {
        return std::ldexp(signed_unit_coordinate(entropy),
                          exponents == Exponents::of_coordinates ? any_exponent() : common);
      };
      p = {number(), number(), number()};
    }
    return points;
  };
  Cloud c{set(), set(), {}, {}, {}, {}, {}, {}, {}};
  for (const Point3& p : c.a) c.flat.push_back({p.x, p.y});
  c.p = convex_polyhedron(convex_hull(c.a), c.a);
  c.q = convex_polyhedron(convex_hull(c.b), c.b);
  c.mesh = strip_of(c.a), c.other = strip_of(c.b);
  for (std::size_t i = 0; i < size; ++i) c.boxes.push_back(fit_aabb(Segment3{c.a[i], c.a[(i + 1) % size]}));
  for (const auto& [i, j, k] : c.mesh.triangles) c.triangles.push_back({c.a[i], c.a[j], c.a[k]});
  return c;
}

inline std::vector<Halfspace3> halfspaces(const std::vector<Point3>& points) {
  std::vector<Halfspace3> all;
  for (const Point3& p : points) all.push_back({{p.x, p.y, p.z}, std::fabs(p.x)});
  return all;
}
inline std::vector<Halfspace2> halfplanes(const std::vector<Point3>& points) {
  std::vector<Halfspace2> all;
  for (const Point3& p : points) all.push_back({{p.x, p.y}, std::fabs(p.z)});
  return all;
}
inline std::vector<Sphere3> balls(const std::vector<Point3>& points) {
  std::vector<Sphere3> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back({points[i], std::fabs(points[(i + 1) % points.size()].y)});
  return all;
}
inline Vector3 vector(const Point3& p) { return {p.x, p.y, p.z}; }
inline Triangle3 triangle(const std::vector<Point3>& p, std::size_t i = 0) { return {p[i], p[i + 1], p[i + 2]}; }
inline Tetrahedron3 tetrahedron(const std::vector<Point3>& p) { return {p[0], p[1], p[2], p[3]}; }
inline Obb3 box(const std::vector<Point3>& p) { return {p[0], {vector(p[1]), vector(p[2]), vector(p[3])}, {1, 1, 1}}; }
inline Ellipsoid3 ellipsoid(const std::vector<Point3>& p) {
  return {p[0], {vector(p[1]), vector(p[2]), vector(p[3])}, {1, 1, 1}};
}
inline Cone3 cone(const std::vector<Point3>& p) { return {p[0], p[1], std::fabs(p[2].x)}; }
inline Capsule3 capsule(const std::vector<Point3>& p) { return {p[0], p[1], std::fabs(p[2].x)}; }
/// Not orthonormal, and as wide as the points are.
inline Pose pose(const std::vector<Point3>& p) { return {{vector(p[4]), vector(p[5]), vector(p[6])}, vector(p[7])}; }
/// A closed chain in the plane, which may cross itself.
inline Polygon2 chain(const Cloud& c) { return {c.flat}; }

/// No more than nine, so that what grows is the index alone.
inline std::span<const Point3> asked_points(const Cloud& c) { return std::span(c.b).first(9); }

}  // namespace plumb::cost

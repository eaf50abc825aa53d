// What is the least translation that parts two bodies?  Brute force from the definition, in integers: of all planes
// through three points of the difference those that have the whole of it on one side.
//
// Laws: written from the header's laws, independent of the search.  It asks every triple of differences of corners.
// Cost: some ms for bodies of four corners, a tenth of a second for two boxes.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "plumb/query/penetration/penetration.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/nearest_pair.hpp"

namespace plumb::penetration_oracle {

using query::Exact3, query::FlatSet;
using query::operator+, query::operator-, query::operator*;
using query::cross, query::dot;

/// Corners and a radius, from the shapes' own definitions.
struct Round {
  std::vector<Exact3> corners;
  mpq_class radius = 0;
};
inline Exact3 exact(const Point3& p) { return {p.x, p.y, p.z}; }
template <class Points>
Round hull_of(const Points& points) {
  Round r;
  for (const Point3& p : points) r.corners.push_back(exact(p));
  return r;
}
inline Round round_of(const VertexHull3& s) { return hull_of(s.vertices); }
template <Figure Shape>
Round round_of(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Polygon3>) {
    return hull_of(s.vertices);
  } else if constexpr (std::is_same_v<Shape, Quadrilateral3>) {
    return hull_of(std::array{s.a, s.b, s.c, s.d});
  } else if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
    return hull_of(s.mesh.vertices);
  } else {
    return {query::core_of(query::view_of(s)).points, query::radius_of(query::view_of(s))};
  }
}
/// Of poses that are permutations times a power of two, where the body is round.
template <class Shape>
Round round_of(const Posed<Shape>& s) {
  const query::ExactMap map = query::exact_map(&s.pose);
  Round r = round_of(s.shape);
  for (Exact3& p : r.corners) p = query::image(map, p);
  if (r.radius != 0) r.radius *= std::sqrt(query::squared_scale(map, 3)->get_d());
  return r;
}

struct Expected {
  Exact3 direction;  // any multiple above zero
  mpq_class core_square;
  bool apart = false, is_unique = true;
};

/// By x, then y, then z of the vectors of length 1.
inline int compare_units(const Exact3& u, const Exact3& v) {
  const mpq_class uu = dot(u, u), vv = dot(v, v);
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class p = u[k] * abs(u[k]) * vv, q = v[k] * abs(v[k]) * uu;
    if (p != q) return p < q ? -1 : 1;
  }
  return 0;
}

/// The first of some directions.
inline Expected first_of(const std::vector<Exact3>& all, mpq_class square) {
  Expected e{all[0], std::move(square)};
  for (const Exact3& u : all) {
    const int order = compare_units(u, e.direction);
    if (order != 0) e.is_unique = false;
    if (order < 0) e.direction = u;
  }
  return e;
}

using Whole3 = std::array<mpz_class, 3>;
inline Whole3 minus(const Whole3& a, const Whole3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline mpz_class dot_whole(const Whole3& a, const Whole3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Whole3 cross_whole(const Whole3& a, const Whole3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_none(const Whole3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// Each once, all times one scale.
struct Differences {
  std::vector<Whole3> points;
  mpz_class scale = 1;

  Differences(const Round& a, const Round& b) {
    std::vector<Exact3> all;
    for (const Exact3& p : a.corners) {
      for (const Exact3& q : b.corners) all.push_back(p - q);
    }
    for (const Exact3& p : all) {
      for (const mpq_class& x : p) scale = lcm(scale, x.get_den());
    }
    for (const Exact3& p : all) {
      Whole3 w;
      for (std::size_t k = 0; k < 3; ++k) w[k] = mpq_class(p[k] * scale).get_num();
      points.push_back(w);
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
};

struct Plane {
  Whole3 normal;  // outward
  mpz_class height;
};

/// Through each triple that has all points on one side; the same plane as often as it is met.
inline std::vector<Plane> supporting_planes(const std::vector<Whole3>& points) {
  std::vector<Plane> all;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const Whole3 normal = cross_whole(minus(points[j], points[i]), minus(points[k], points[i]));
        if (is_none(normal)) continue;
        const mpz_class height = dot_whole(normal, points[i]);
        bool above = false, below = false;
        for (std::size_t m = 0; m < n && !(above && below); ++m) {
          const int side = cmp(dot_whole(normal, points[m]), height);
          above = above || side > 0, below = below || side < 0;
        }
        if (!below) all.push_back({{-normal[0], -normal[1], -normal[2]}, -height});
        if (!above) all.push_back({normal, height});
      }
    }
  }
  return all;
}

/// Of a flat difference: at right angles to it.
inline Expected beside(const std::vector<Whole3>& points) {
  if (points.size() == 1) return {{-1, 0, 0}, 0, false, false};
  const Whole3 u = minus(points[1], points[0]);
  for (const Whole3& p : points) {
    const Whole3 n = cross_whole(u, minus(p, points[0]));
    if (is_none(n)) continue;
    const Exact3 up{n[0], n[1], n[2]};
    return first_of({up, mpq_class(-1) * up}, 0);
  }
  // What is left of -x, or of -y, when its part along u is taken away.
  const Exact3 along{u[0], u[1], u[2]};
  const Exact3 axis = u[1] == 0 && u[2] == 0 ? Exact3{0, -1, 0} : Exact3{-1, 0, 0};
  return {axis - (dot(axis, along) / dot(along, along)) * along, 0, false, false};
}

/// Of bodies that meet.
inline Expected of_planes(const std::vector<Plane>& planes, const mpz_class& scale) {
  std::vector<Exact3> ways;
  mpz_class height = 0, square = 0;
  for (const Plane& p : planes) {
    const mpz_class n = dot_whole(p.normal, p.normal);
    const int order = square == 0 ? -1 : cmp(p.height * p.height * square, height * height * n);
    if (order < 0) ways.clear(), height = p.height, square = n;
    if (order <= 0) ways.push_back({-p.normal[0], -p.normal[1], -p.normal[2]});
  }
  mpq_class least(height * height, square * scale * scale);
  least.canonicalize();
  return first_of(ways, least);
}

inline bool is_flat(const std::vector<Plane>& planes, const std::vector<Whole3>& points) {
  return planes.empty() || std::ranges::any_of(planes, [&](const Plane& plane) {
           return std::ranges::all_of(points,
                                      [&](const Whole3& x) { return dot_whole(plane.normal, x) == plane.height; });
         });
}

inline std::optional<Expected> expected(const Round& a, const Round& b) {
  const FlatSet p{a.corners, {}, {}}, q{b.corners, {}, {}};
  if (query::relate(p, q) == Relation::disjoint) {
    const auto pair = query::nearest_pair(p, q, query::WhichPair::any);
    const mpq_class radii = a.radius + b.radius;
    if (pair->square > radii * radii) return {};
    return Expected{pair->on_a - pair->on_b, pair->square, true, true};
  }
  const Differences d(a, b);
  const std::vector<Plane> planes = supporting_planes(d.points);
  return is_flat(planes, d.points) ? beside(d.points) : of_planes(planes, d.scale);
}

}  // namespace plumb::penetration_oracle

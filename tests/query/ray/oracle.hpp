// Where does a ray first hit the hull of some points, by brute force over rationals?  Independent of the library's
// formulas.
//
// The least parameter of a line in a hull is that of a vertex of a linear program: of at most three of the points that
// a single parameter and weights, none negative, bring onto the line.  A ray that begins in the hull hits it at zero.
// Features are hulls of few points; those that hold the point are tried in order.
// Laws: exact for all finite doubles.
// Cost: 20 us to 5 ms.
#pragma once

#include <cmath>

#include "figure/basic/rationals.hpp"
#include "figure/containment/exact_locations.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb::ray_oracle {

using exact::Coordinates, exact::Rational;
using Corners = std::vector<Coordinates>;

struct Path {
  Coordinates origin, direction;
  bool begins, ends;

  explicit Path(const AnyRay& r)
      : origin(exact::of(r.origin)),
        direction(r.kind == AnyRay::Kind::segment ? exact::difference(exact::of(r.end), exact::of(r.origin))
                                                  : exact::of(r.direction)),
        begins(r.kind != AnyRay::Kind::line),
        ends(r.kind == AnyRay::Kind::segment) {}

  [[nodiscard]] bool has(const Rational& t) const { return (!begins || t >= 0) && (!ends || t <= 1); }
  [[nodiscard]] bool is_point() const { return exact::square(direction) == 0; }
  [[nodiscard]] Coordinates at(const Rational& t) const { return exact::combination(origin, t, direction); }
};

/// The only parameter at which these points, with weights, are on the line; nothing where a weight is negative.
inline std::optional<Rational> meets(const Path& path, const Corners& chosen) {
  exact::Equations rows(4);
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i].push_back(-path.direction[i]);
    for (const Coordinates& c : chosen) rows[i].push_back(c[i]);
    rows[i].push_back(path.origin[i]);
  }
  rows[3].push_back(0);
  for (std::size_t k = 0; k <= chosen.size(); ++k) rows[3].push_back(1);
  const exact::Solution s = exact::solve(rows, 1 + chosen.size());
  if (s.rank != 1 + chosen.size() || !s.unknowns) return {};
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if ((*s.unknowns)[1 + k] < 0) return {};
  }
  return (*s.unknowns)[0];
}

inline std::optional<Rational> first(const Path& path, const Corners& corners) {
  if (path.is_point() || path.begins) {
    if (exact::in_hull(corners, path.origin)) return Rational(0);
    if (path.is_point()) return {};
  }
  std::optional<Rational> best;
  const auto take = [&](const Corners& chosen) {
    const auto t = meets(path, chosen);
    if (t && path.has(*t) && (!best || *t < *best)) best = t;
  };
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    take({corners[i]});
    for (std::size_t j = i + 1; j < n; ++j) {
      take({corners[i], corners[j]});
      for (std::size_t k = j + 1; k < n; ++k) take({corners[i], corners[j], corners[k]});
    }
  }
  return best;
}

/// A feature, and the numbers of its corners; listed by dimension, then number.
struct Part {
  Feature feature;
  std::vector<std::size_t> corners;
};

inline Feature holder(const Corners& corners, const std::vector<Part>& parts, const Coordinates& p) {
  for (const Part& part : parts) {
    Corners its;
    for (const std::size_t c : part.corners) its.push_back(corners[c]);
    if (exact::in_hull(its, p)) return part.feature;
  }
  return {FeatureKind::interior, 0};
}

inline std::vector<Part> parts_of(std::size_t vertices, const std::vector<std::vector<std::size_t>>& edges,
                                  const std::vector<std::vector<std::size_t>>& faces) {
  std::vector<Part> parts;
  for (std::size_t v = 0; v < vertices; ++v)
    parts.push_back({{FeatureKind::vertex, static_cast<std::uint32_t>(v)}, {v}});
  const auto add = [&](FeatureKind kind, const std::vector<std::vector<std::size_t>>& lists) {
    for (std::size_t i = 0; i < lists.size(); ++i) parts.push_back({{kind, static_cast<std::uint32_t>(i)}, lists[i]});
  };
  add(FeatureKind::edge, edges), add(FeatureKind::face, faces);
  return parts;
}

inline const std::vector<Part> triangle_parts = parts_of(3, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}});
inline const std::vector<Part> tetrahedron_parts =
    parts_of(4, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}, {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}});
/// Corner bit k is the upper end of axis k.
inline const std::vector<Part> rectangle_parts = parts_of(4, {{0, 1}, {2, 3}, {0, 2}, {1, 3}}, {{0, 1, 3, 2}});
inline const std::vector<Part> box_parts =
    parts_of(8, {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}},
             {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}});

inline Corners corners_of(const Triangle3& t) { return {exact::of(t.a), exact::of(t.b), exact::of(t.c)}; }
inline Corners corners_of(const Tetrahedron3& t) {
  return {exact::of(t.a), exact::of(t.b), exact::of(t.c), exact::of(t.d)};
}
inline Corners corners_of(const Coordinates& center, const std::vector<Coordinates>& axes, const Coordinates& half) {
  Corners all;
  for (std::size_t ends = 0; ends < std::size_t{1} << axes.size(); ++ends) {
    Coordinates p = center;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const Rational h = abs(half[k]);
      p = exact::combination(p, (ends >> k & 1) != 0 ? h : Rational(-h), axes[k]);
    }
    all.push_back(p);
  }
  return all;
}
inline Corners corners_of(const Rectangle3& r) {
  return corners_of(exact::of(r.center), {exact::of(r.axes[0]), exact::of(r.axes[1])}, exact::of(r.half));
}
inline Corners corners_of(const Obb3& b) {
  return corners_of(exact::of(b.center), {exact::of(b.axes[0]), exact::of(b.axes[1]), exact::of(b.axes[2])},
                    exact::of(b.half));
}
/// None of an empty box.
inline Corners corners_of(const Aabb3& b) {
  const Coordinates min = exact::of(b.min), max = exact::of(b.max);
  for (std::size_t i = 0; i < 3; ++i) {
    if (min[i] > max[i]) return {};
  }
  Corners all;
  for (std::size_t ends = 0; ends < 8; ++ends) {
    Coordinates p = min;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (ends >> k & 1) != 0 ? max[k] : min[k];
    all.push_back(p);
  }
  return all;
}

inline const std::vector<Part>& parts(const Triangle3&) { return triangle_parts; }
inline const std::vector<Part>& parts(const Tetrahedron3&) { return tetrahedron_parts; }
inline const std::vector<Part>& parts(const Rectangle3&) { return rectangle_parts; }
inline const std::vector<Part>& parts(const Obb3&) { return box_parts; }
inline const std::vector<Part>& parts(const Aabb3&) { return box_parts; }

/// Is x the double nearest to q, infinite where that is beyond all doubles?
inline bool is_nearest(double x, const Rational& q) {
  if (rationals::overflows(q)) return std::isinf(x) && (x > 0) == (q > 0);
  return rationals::is_nearest(x, q);
}
inline bool is_nearest(const Point3& p, const Coordinates& q) {
  return is_nearest(p.x, q[0]) && is_nearest(p.y, q[1]) && is_nearest(p.z, q[2]);
}
inline bool is_nearest(const Vector3& p, const Coordinates& q) {
  return is_nearest(p.x, q[0]) && is_nearest(p.y, q[1]) && is_nearest(p.z, q[2]);
}

inline Coordinates cross(const Coordinates& a, const Coordinates& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace plumb::ray_oracle

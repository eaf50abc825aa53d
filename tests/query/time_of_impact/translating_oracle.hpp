// When do two convex shapes that move straight first meet?  Brute force in rationals and in sums with one square root.
//
// A shape is all points within its reach of the hull of some points.  The first shape reaches the second when its
// motion from the origin comes within both reaches of the hull D of the differences of their points.
// Laws: (1) without reach, the motion is cut by the slab of D along every axis that can bound D.  (2) With one, the
// first time is the least at which a point, a segment or a triangle of points of D is within reach, for what is nearest
// in D to a point outside is in one of these.  Written from the definition, independent of the library's formulas.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::translating_oracle {

using Number = mpq_class;
using Vector = std::array<Number, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector times(const Vector& a, const Number& t) { return {a[0] * t, a[1] * t, a[2] * t}; }
inline Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Vector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
template <class P>
Vector vector(const P& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

/// a + b sqrt(c).
struct Surd {
  Number a, b, c;
};

inline int sign(const Surd& s) {
  const int of_a = sgn(s.a), of_root = s.c == 0 ? 0 : sgn(s.b);
  if (of_a == 0 || of_root == 0 || of_a == of_root) return of_a != 0 ? of_a : of_root;
  return of_a * sgn(Number(s.a * s.a - s.b * s.b * s.c));
}
inline int compare(const Surd& x, const Surd& y) {
  const Number a = x.a - y.a, p = x.b * x.b * x.c, q = y.b * y.b * y.c;
  const int s = p == 0 ? 0 : sgn(x.b), t = q == 0 ? 0 : -sgn(y.b);
  const int of_roots = s == 0 || t == 0 || s == t ? (s != 0 ? s : t) : s * sgn(Number(p - q));
  if (a == 0 || of_roots == 0 || sgn(a) == of_roots) return a != 0 ? sgn(a) : of_roots;
  return sgn(a) * sign({a * a - p - q, 2 * x.b * y.b, x.c * y.c});
}
inline int compare(const Surd& x, double y) { return sign({x.a - Number(y), x.b, x.c}); }
/// The sign of from + change t.
inline int side(const Number& from, const Number& change, const Surd& t) {
  return sign({from + change * t.a, change * t.b, t.c});
}

struct Part {
  Feature feature;
  std::vector<std::size_t> corners;
};

struct Body {
  std::vector<Vector> points, ways;  // of the edges, and no two parallel
  std::vector<Part> parts;
  Number reach = 0;
  bool is_plane = false;
  Vector normal;
  Number offset;

  /// The part alone, around which its corners go: of those of a solid some edges would be missing.
  [[nodiscard]] Body part(const Part& p) const {
    Body b{{}, {}, {}, reach, is_plane, normal, offset};
    for (const std::size_t i : p.corners) b.points.push_back(points[i]);
    for (std::size_t i = 0; i < p.corners.size(); ++i) b.way(b.points[i] - b.points[(i + 1) % p.corners.size()]);
    return b;
  }
  void way(const Vector& w) {
    if (is_zero(w)) return;
    if (std::ranges::none_of(ways, [&](const Vector& v) { return is_zero(cross(v, w)); })) ways.push_back(w);
  }
  void add(FeatureKind kind, std::size_t index, std::vector<std::size_t> corners) {
    if (kind == FeatureKind::edge) way(points[corners[1]] - points[corners[0]]);
    parts.push_back({{kind, static_cast<std::uint32_t>(index)}, std::move(corners)});
  }
  void add_points(std::vector<Vector> all) {
    points = std::move(all);
    for (std::size_t i = 0; i < points.size(); ++i) add(FeatureKind::vertex, i, {i});
  }
  void add_box() {
    for (std::size_t i = 0; i < 12; ++i) {
      const std::size_t axis = i / 4, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
      const std::size_t from = (i & 1) << u | (i >> 1 & 1) << v;
      add(FeatureKind::edge, i, {from, from | std::size_t{1} << axis});
    }
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t axis = i / 2, u = std::size_t{1} << (axis + 1) % 3, v = std::size_t{1} << (axis + 2) % 3;
      const std::size_t at = (i & 1) << axis;
      add(FeatureKind::face, i, {at, at | u, at | u | v, at | v});
    }
  }
};

inline Body body(const Point3& p) {
  Body b;
  b.add_points({vector(p)});
  return b;
}
inline Body body(const Segment3& s) {
  Body b;
  b.add_points({vector(s.a), vector(s.b)});
  b.add(FeatureKind::edge, 0, {0, 1});
  return b;
}
inline Body body(const Triangle3& t) {
  Body b;
  b.add_points({vector(t.a), vector(t.b), vector(t.c)});
  for (std::size_t i = 0; i < 3; ++i) b.add(FeatureKind::edge, i, {i, (i + 1) % 3});
  b.add(FeatureKind::face, 0, {0, 1, 2});
  return b;
}
inline Body body(const Aabb3& box) {
  Body b;
  if (!(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z)) return b;
  const std::array<Vector, 2> ends{vector(box.min), vector(box.max)};
  std::vector<Vector> all(8);
  for (std::size_t i = 0; i < 8; ++i) all[i] = {ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2][2]};
  b.add_points(all);
  b.add_box();
  return b;
}
inline Body body(const Obb3& box) {
  Body b;
  const Vector half = vector(Vector3{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)});
  std::vector<Vector> all(8, vector(box.center));
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      all[i] = all[i] + times(vector(box.axes[k]), (i >> k & 1) != 0 ? half[k] : Number(-half[k]));
  }
  b.add_points(all);
  b.add_box();
  return b;
}
inline Body body(const ConvexPolyhedron3& p) {
  Body b;
  std::vector<Vector> all;
  for (const Point3& v : p.mesh.vertices) all.push_back(vector(v));
  b.add_points(all);
  for (std::size_t f = 0; f + 1 < p.mesh.first.size(); ++f) {
    const std::vector<std::size_t> corners(p.mesh.corners.begin() + static_cast<std::ptrdiff_t>(p.mesh.first[f]),
                                           p.mesh.corners.begin() + static_cast<std::ptrdiff_t>(p.mesh.first[f + 1]));
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::size_t from = corners[c], to = corners[(c + 1) % corners.size()];
      // The other face has it the other way round, and the face of the lower number names it.
      const auto named = [&](const Part& q) { return q.corners == std::vector<std::size_t>{to, from}; };
      if (std::ranges::none_of(b.parts, named)) b.add(FeatureKind::edge, p.mesh.first[f] + c, {from, to});
    }
    b.add(FeatureKind::face, f, corners);
  }
  return b;
}
inline Body body(const Sphere3& s) {
  Body b;
  b.points = {vector(s.center)};
  b.add(FeatureKind::face, 0, {0});
  b.reach = s.radius;
  return b;
}
inline Body body(const Capsule3& c) {
  Body b = body(Segment3{c.a, c.b});
  b.reach = c.radius;
  return b;
}
inline Body body(const Tetrahedron3& t) {
  Body b;
  b.add_points({vector(t.a), vector(t.b), vector(t.c), vector(t.d)});
  const std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  for (std::size_t i = 0; i < 6; ++i) b.add(FeatureKind::edge, i, {edges[i][0], edges[i][1]});
  const std::array<std::array<std::size_t, 3>, 4> faces{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
  for (std::size_t i = 0; i < 4; ++i) b.add(FeatureKind::face, i, {faces[i].begin(), faces[i].end()});
  return b;
}
inline Body parallelogram(const Vector& at, const Vector& u, const Vector& v) {
  Body b;
  b.add_points({at, at + u, at + v, at + u + v});
  b.add(FeatureKind::edge, 0, {0, 1}), b.add(FeatureKind::edge, 1, {2, 3});
  b.add(FeatureKind::edge, 2, {0, 2}), b.add(FeatureKind::edge, 3, {1, 3});
  b.add(FeatureKind::face, 0, {0, 1, 3, 2});
  return b;
}
inline Body body(const Rectangle3& r) {
  const Vector u = times(vector(r.axes[0]), Number(std::fabs(r.half.x))),
               v = times(vector(r.axes[1]), Number(std::fabs(r.half.y)));
  return parallelogram(vector(r.center) - u - v, u + u, v + v);
}
inline Body body(const Lozenge3& l) {
  Body b = parallelogram(vector(l.corner), vector(l.edges[0]), vector(l.edges[1]));
  b.reach = l.radius;
  return b;
}
inline Body body(const Plane3& p) {
  Body b;
  b.is_plane = true;
  b.normal = vector(p.normal);
  b.offset = p.offset;
  b.add(FeatureKind::face, 0, {});
  return b;
}

/// The time at which `velocity` comes into all slabs lowest <= x . axis <= highest of D.
inline std::optional<Number> first_in_hull(const Body& a, const Body& b, const Vector& velocity) {
  std::vector<Vector> axes, ways = a.ways;
  ways.insert(ways.end(), b.ways.begin(), b.ways.end());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) axes.push_back(cross(ways[i], ways[j]));
  }
  const bool solid = std::ranges::any_of(axes, [&](const Vector& n) {
    return std::ranges::any_of(ways, [&](const Vector& w) { return dot(n, w) != 0; });
  });
  if (!solid) {  // of a flat D also what bounds it within its plane or line
    const std::vector<Vector> normals = axes;
    const std::array<Vector, 3> units{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
    axes.insert(axes.end(), ways.begin(), ways.end());
    axes.insert(axes.end(), units.begin(), units.end());
    for (const Vector& w : ways) {
      for (const Vector& n : normals) axes.push_back(cross(w, n));
      for (const Vector& u : units) axes.push_back(cross(w, u));
    }
  }
  Number from = 0, to = 1;
  for (const Vector& n : axes) {
    if (is_zero(n)) continue;
    const auto ends = [&](const std::vector<Vector>& points) {
      std::vector<Number> at;
      for (const Vector& p : points) at.push_back(dot(p, n));
      const auto [low, high] = std::ranges::minmax_element(at);
      return std::pair(*low, *high);
    };
    const auto [low_a, high_a] = ends(a.points);
    const auto [low_b, high_b] = ends(b.points);
    const Number low = low_b - high_a, high = high_b - low_a, speed = dot(velocity, n);
    if (speed == 0) {
      if (low > 0 || high < 0) return {};
      continue;
    }
    Number enters = low / speed, leaves = high / speed;
    if (speed < 0) std::swap(enters, leaves);
    from = std::max(from, enters), to = std::min(to, leaves);
    if (from > to) return {};
  }
  return from;
}

/// Keeps the least time at which a simplex of points of D is within reach.
class FirstWithinReach {
 public:
  FirstWithinReach(const Vector& velocity, const Number& reach) : v_(velocity), square_(reach * reach) {}

  void ask(const Vector& p) {
    if (const auto t = entered(dot(p, p) - square_, -dot(p, v_), dot(v_, v_))) keep(*t);
  }
  void ask(const Vector& p, const Vector& q) {
    const Vector u = q - p, m = cross(u, p), k = cross(v_, u);
    const Number length = dot(u, u);
    const auto t = length == 0 ? std::nullopt : entered(dot(m, m) - square_ * length, dot(m, k), dot(k, k));
    if (!t) return;
    const Number from = -dot(p, u), change = dot(v_, u);
    if (side(from, change, *t) >= 0 && side(length - from, -change, *t) >= 0) keep(*t);
  }
  void ask(const Vector& p, const Vector& q, const Vector& r) {
    const Vector n = cross(q - p, r - p);
    const Number area = dot(n, n), from = -dot(p, n), change = dot(v_, n);
    const auto t = area == 0 ? std::nullopt : entered(from * from - square_ * area, from * change, change * change);
    if (!t) return;
    const std::array<const Vector*, 3> corners{&p, &q, &r};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector inward = cross(n, *corners[(i + 1) % 3] - *corners[i]);
      if (side(-dot(*corners[i], inward), dot(v_, inward), *t) < 0) return;
    }
    keep(*t);
  }
  [[nodiscard]] const std::optional<Surd>& first() const { return first_; }

 private:
  /// The first time in [0, 1] with c + 2 h t + e t^2 <= 0; e is not negative.
  [[nodiscard]] std::optional<Surd> entered(const Number& c, const Number& h, const Number& e) const {
    if (c <= 0) return Surd{0, 0, 0};
    const Number rest = h * h - e * c;
    if (h >= 0 || rest < 0) return {};
    const Surd t{-h / e, -1 / e, rest};
    return compare(t, 1.0) > 0 || (first_ && compare(t, *first_) >= 0) ? std::nullopt : std::optional(t);
  }
  void keep(const Surd& t) {
    if (!first_ || compare(t, *first_) < 0) first_ = t;
  }

  Vector v_;
  Number square_;
  std::optional<Surd> first_;
};

/// `velocity` is that of the body, seen from the plane.
inline std::optional<Surd> first_at_plane(const Body& body, const Body& plane, const Vector& velocity) {
  if (body.points.empty()) return {};
  std::vector<Number> heights;
  for (const Vector& p : body.points) heights.push_back(dot(p, plane.normal) - plane.offset);
  const auto [low, high] = std::ranges::minmax_element(heights);
  const Number square = dot(plane.normal, plane.normal), speed = dot(velocity, plane.normal), &reach = body.reach;
  const bool above = sign({*low, -reach, square}) > 0, below = sign({*high, reach, square}) < 0;
  if (!above && !below) return Surd{0, 0, 0};
  if (above ? speed >= 0 : speed <= 0) return {};
  const Surd t = above ? Surd{-*low / speed, reach / speed, square} : Surd{-*high / speed, -reach / speed, square};
  return compare(t, 1.0) > 0 ? std::nullopt : std::optional(t);
}

/// The first time at which they meet; `velocity` is that of a, seen from b.
inline std::optional<Surd> first_time(const Body& a, const Body& b, const Vector& velocity) {
  if (b.is_plane) return first_at_plane(a, b, velocity);
  if (a.is_plane) return first_at_plane(b, a, times(velocity, -1));
  if (a.points.empty() || b.points.empty()) return {};
  const Number reach = a.reach + b.reach;
  if (reach == 0) {
    const std::optional<Number> t = first_in_hull(a, b, velocity);
    return t ? std::optional(Surd{*t, 0, 0}) : std::nullopt;
  }
  if (first_in_hull(a, b, {0, 0, 0})) return Surd{0, 0, 0};
  std::vector<Vector> d;
  for (const Vector& p : a.points) {
    for (const Vector& q : b.points) {
      if (std::ranges::find(d, Vector(q - p)) == d.end()) d.push_back(q - p);
    }
  }
  FirstWithinReach first(velocity, reach);
  for (std::size_t i = 0; i < d.size(); ++i) first.ask(d[i]);
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) first.ask(d[i], d[j]);
  }
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) first.ask(d[i], d[j], d[k]);
    }
  }
  return first.first();
}

}  // namespace plumb::translating_oracle

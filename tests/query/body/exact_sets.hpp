// What do two convex figures have in common, by brute force over rationals?
//
// A figure is all sums of weights times its points and not negative multiples of its rays, the weights not negative and
// of sum one.  So a common point is a solution of linear equations in numbers that are not negative, and every extreme
// one is a basic solution: all bases are tried.  Written from the structs' comments, independent of the library.
// Laws: exact for all finite doubles.
// Cost: some 10 us a basis, up to some thousands of them.
#pragma once

#include <string>

#include "figure/containment/exact_locations.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb::exact {

struct Generators {
  std::vector<Coordinates> points, rays;  // no points: the empty set
};

/// All directions that these span: one ray against all of them does for all negatives.
inline void add_directions(Generators& g, const std::vector<Coordinates>& directions) {
  Coordinates against(directions[0].size());
  for (const Coordinates& d : directions) {
    g.rays.push_back(d);
    against = difference(against, d);
  }
  g.rays.push_back(against);
}

inline Generators generated(const Point2& p) { return {{of(p)}, {}}; }
inline Generators generated(const Point3& p) { return {{of(p)}, {}}; }
template <class Line>
requires(std::is_same_v<Line, Line2> || std::is_same_v<Line, Line3>) Generators generated(const Line& l) {
  Generators g{{of(l.point)}, {}};
  add_directions(g, {of(l.direction)});
  return g;
}
template <class Ray>
requires(std::is_same_v<Ray, Ray2> || std::is_same_v<Ray, Ray3>) Generators generated(const Ray& r) {
  return {{of(r.origin)}, {of(r.direction)}};
}
template <class Segment>
requires(std::is_same_v<Segment, Segment2> || std::is_same_v<Segment, Segment3>) Generators
    generated(const Segment& s) {
  return {{of(s.a), of(s.b)}, {}};
}
template <class Triangle>
requires(std::is_same_v<Triangle, Triangle2> || std::is_same_v<Triangle, Triangle3>) Generators
    generated(const Triangle& t) {
  return {{of(t.a), of(t.b), of(t.c)}, {}};
}
inline Generators generated(const Tetrahedron3& t) { return {{of(t.a), of(t.b), of(t.c), of(t.d)}, {}}; }
inline Generators generated(const Polygon2& p) {
  Generators g;
  for (const Point2& v : p.vertices) g.points.push_back(of(v));
  return g;
}
inline Generators generated(const ConvexPolyhedron3& p) {
  Generators g;
  for (const Point3& v : p.mesh.vertices) g.points.push_back(of(v));
  return g;
}
inline Generators generated_box(const Coordinates& min, const Coordinates& max) {
  Generators g{{min}, {}};
  for (std::size_t axis = 0; axis < min.size(); ++axis) {
    if (min[axis] > max[axis]) return {};
    for (std::size_t i = 0, n = g.points.size(); i < n; ++i) {
      g.points.push_back(g.points[i]);
      g.points.back()[axis] = max[axis];
    }
  }
  return g;
}
inline Generators generated(const Aabb2& b) { return generated_box(of(b.min), of(b.max)); }
inline Generators generated(const Aabb3& b) { return generated_box(of(b.min), of(b.max)); }
inline Generators generated(const Obb3& b) {
  Generators g{{of(b.center)}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational half(i == 0 ? b.half.x : i == 1 ? b.half.y : b.half.z);
    std::vector<Coordinates> corners;
    for (const Coordinates& p : g.points) {
      corners.push_back(combination(p, half, of(b.axes[i])));
      corners.push_back(combination(p, -half, of(b.axes[i])));
    }
    g.points = corners;
  }
  return g;
}
inline Generators generated(const Plane3& plane) {
  const Coordinates n = of(plane.normal);
  if (square(n) == 0) {
    if (plane.offset != 0) return {};
    Generators all{{{0, 0, 0}}, {}};
    add_directions(all, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    return all;
  }
  Generators g{{combination({0, 0, 0}, Rational(plane.offset) / square(n), n)}, {}};
  const std::size_t used = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  std::vector<Coordinates> directions;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis == used) continue;
    Coordinates d{0, 0, 0};
    d[axis] = n[used];
    d[used] = -n[axis];
    directions.push_back(d);
  }
  add_directions(g, directions);
  return g;
}
inline Generators generated(const ThreePointPlane3& p) {
  Generators g{{of(p.a)}, {}};
  add_directions(g, {difference(of(p.b), of(p.a)), difference(of(p.c), of(p.a))});
  return g;
}
inline Generators generated(const Halfspace3& h) {
  Generators g = generated(Plane3{h.normal, h.offset});
  const Coordinates n = of(h.normal);
  if (square(n) == 0 && h.offset > 0) return generated(Plane3{h.normal, 0});
  if (square(n) != 0) g.rays.push_back(combination({0, 0, 0}, -1, n));
  return g;
}

/// Calls visit(used columns, their weights) for every basic solution of columns * weights = right, weights >= 0.
template <class Visit>
void basic_solutions(const std::vector<Coordinates>& columns, const Coordinates& right, Visit visit) {
  std::vector<std::size_t> used;
  const auto extend = [&](const auto& self, std::size_t from) -> void {
    if (!used.empty()) {
      std::vector<Coordinates> chosen;
      for (const std::size_t c : used) chosen.push_back(columns[c]);
      const Solution s = solve_columns(chosen, right);
      if (s.rank < used.size()) return;  // dependent, and so are all extensions
      if (s.unknowns && std::ranges::all_of(*s.unknowns, [](const Rational& x) { return x >= 0; }))
        visit(used, *s.unknowns);
    }
    if (used.size() == right.size()) return;
    for (std::size_t c = from; c < columns.size(); ++c) {
      used.push_back(c);
      self(self, c + 1);
      used.pop_back();
    }
  };
  extend(extend, 0);
}

struct CommonSet {
  std::vector<Coordinates> points, directions;  // all extreme points among the points; the directions it goes on in
};

inline CommonSet common(const Generators& a, const Generators& b) {
  CommonSet set;
  if (a.points.empty() || b.points.empty()) return set;
  const std::size_t n = a.points[0].size();
  const auto column = [n](const Coordinates& p, int sign, int of_a, int of_b) {
    Coordinates c = combination(Coordinates(n), sign, p);
    c.emplace_back(of_a);
    c.emplace_back(of_b);
    return c;
  };
  std::vector<Coordinates> columns, own;
  for (const Coordinates& p : a.points) columns.push_back(column(p, 1, 1, 0)), own.push_back(p);
  for (const Coordinates& r : a.rays) columns.push_back(column(r, 1, 0, 0)), own.push_back(r);
  for (const Coordinates& p : b.points) columns.push_back(column(p, -1, 0, 1));
  for (const Coordinates& r : b.rays) columns.push_back(column(r, -1, 0, 0));
  Coordinates right(n + 2);
  right[n] = right[n + 1] = 1;
  const auto insert = [](std::vector<Coordinates>& to, const Coordinates& x) {
    if (std::ranges::find(to, x) == to.end()) to.push_back(x);
  };
  const auto image = [&](const std::vector<std::size_t>& used, const Coordinates& weights) {
    Coordinates x(n);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (used[i] < own.size()) x = combination(x, weights[i], own[used[i]]);
    }
    return x;
  };
  basic_solutions(columns, right, [&](const auto& used, const auto& w) { insert(set.points, image(used, w)); });
  if (set.points.empty() || a.rays.empty() || b.rays.empty()) return set;
  columns.clear();
  own = a.rays;
  for (const Coordinates& r : a.rays) columns.push_back(column(r, 1, 1, 0));
  for (const Coordinates& r : b.rays) columns.push_back(column(r, -1, 0, 0));
  right[n + 1] = 0;
  basic_solutions(columns, right, [&](const auto& used, const auto& w) {
    if (const Coordinates d = image(used, w); square(d) != 0) insert(set.directions, d);
  });
  return set;
}

inline Coordinates of(const ExactPoint2& p) {
  const RationalPoint2 r = rational_point(p);
  return {r.x.value().value, r.y.value().value};
}
inline Coordinates of(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {r.x.value().value, r.y.value().value, r.z.value().value};
}

/// Of three points, the sign of their turn as seen along the first of z, x, y (or in the plane) that sees some.
inline int turn(const std::vector<Coordinates>& v, std::size_t i, std::size_t j, std::size_t k) {
  static const std::vector<std::pair<std::size_t, std::size_t>> space{{0, 1}, {1, 2}, {0, 2}}, plane{{0, 1}};
  const auto seen = [&](const Coordinates& a, const Coordinates& b, const Coordinates& c, const auto& look) {
    const auto [r, u] = look;
    return sgn(Rational((b[r] - a[r]) * (c[u] - a[u]) - (b[u] - a[u]) * (c[r] - a[r])));
  };
  for (const auto& look : v[0].size() == 2 ? plane : space) {
    if (const int s = seen(v[i], v[j], v[k], look); s != 0) return s;
  }
  return 0;
}

/// Is this the set, told as the laws of query/section/intersection_result.hpp say?  What is wrong, or nothing.
template <class Common>
std::string wrong(const Common& told, const CommonSet& set) {
  std::vector<Coordinates> v;
  for (const auto& p : told.vertices) v.push_back(of(p));
  if (told.empty()) return set.points.empty() && v.empty() ? "" : "not empty";
  if (set.points.empty()) return "empty";
  const auto in_set = [&](const Coordinates& p) { return std::ranges::find(set.points, p) != set.points.end(); };
  const auto way = [&](const Coordinates& d) {  // 1: along v0 v1, -1: against, 0: elsewhere
    const Coordinates e = difference(v[1], v[0]);
    if (square(d) * square(e) != dot(d, e) * dot(d, e)) return 0;
    return sgn(dot(d, e));
  };
  if (told.kind == IntersectionKind::line || told.kind == IntersectionKind::ray) {
    if (v.size() != 2 || v[0] == v[1]) return "no two points";
    bool forward = false, backward = false;
    for (const Coordinates& d : set.directions) {
      const int w = way(d);
      if (w == 0) return "has further directions";
      (w > 0 ? forward : backward) = true;
    }
    if (!forward || backward != (told.kind == IntersectionKind::line)) return "wrong directions";
    if (told.kind == IntersectionKind::ray && !in_set(v[0])) return "wrong origin";
    for (const Coordinates& p : set.points) {
      if (p != v[0] && way(difference(p, v[0])) == 0) return "wrong line";
    }
    return "";
  }
  if (!set.directions.empty()) return "not bounded";
  for (const Coordinates& p : v) {
    if (!in_set(p)) return "a vertex is not extreme";
  }
  for (const Coordinates& p : set.points) {
    if (!in_hull(v, p)) return "a point is missing";
  }
  const std::size_t n = v.size();
  if (told.kind == IntersectionKind::solid) return std::ranges::is_sorted(v) ? "" : "not sorted";
  if ((told.kind == IntersectionKind::point) != (n == 1)) return "not a point";
  if ((told.kind == IntersectionKind::segment) != (n == 2)) return "not a segment";
  if (n == 2 && !(v[0] < v[1])) return "not ascending";
  if (n < 3) return "";
  if (std::ranges::min_element(v) != v.begin()) return "begins elsewhere";
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(v, i, (i + 1) % n, (i + 2) % n) <= 0) return "not strictly convex or clockwise";
  }
  return "";
}

}  // namespace plumb::exact

// Where does a point lie to a shape, by brute force over rationals?
//
// Written from the structs' comments and independent of the library's formulas: it solves for the parameters by
// elimination, constructs the nearest points, and finds hulls of few points by trying all simplices.
// Laws: exact for all finite doubles.
// Cost: 5 us to 5 ms.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "plumb/figure.hpp"

namespace plumb::exact {

using Rational = mpq_class;
using Coordinates = std::vector<Rational>;  // of a point or vector in the plane or in space
using Equations = std::vector<Coordinates>;

inline Coordinates of(const Point2& p) { return {Rational(p.x), Rational(p.y)}; }
inline Coordinates of(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
inline Coordinates of(const Vector2& v) { return {Rational(v.x), Rational(v.y)}; }
inline Coordinates of(const Vector3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

inline Coordinates combination(const Coordinates& a, const Rational& times, const Coordinates& b) {
  Coordinates sum = a;
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] += times * b[i];
  return sum;
}
inline Coordinates difference(const Coordinates& a, const Coordinates& b) { return combination(a, -1, b); }
inline Rational dot(const Coordinates& a, const Coordinates& b) {
  Rational sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
inline Rational square(const Coordinates& a) { return dot(a, a); }

struct Solution {
  std::size_t rank;
  std::optional<Coordinates> unknowns;  // free ones are zero; nothing where the equations contradict one another
};

/// Rows of coefficients with the right side last, by Gauss and Jordan.
inline Solution solve(Equations rows, std::size_t unknowns) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t r = pivots.size();
    while (r < rows.size() && rows[r][column] == 0) ++r;
    if (r == rows.size()) continue;
    std::swap(rows[r], rows[pivots.size()]);
    const Coordinates& pivot = rows[pivots.size()];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == pivots.size() || rows[i][column] == 0) continue;
      const Rational factor = rows[i][column] / pivot[column];
      for (std::size_t k = column; k <= unknowns; ++k) rows[i][k] -= factor * pivot[k];
    }
    pivots.push_back(column);
  }
  for (std::size_t i = pivots.size(); i < rows.size(); ++i) {
    if (rows[i][unknowns] != 0) return {pivots.size(), {}};
  }
  Coordinates x(unknowns);
  for (std::size_t i = 0; i < pivots.size(); ++i) x[pivots[i]] = rows[i][unknowns] / rows[i][pivots[i]];
  return {pivots.size(), x};
}

/// t with sum of t_i columns_i = w.
inline Solution solve_columns(const std::vector<Coordinates>& columns, const Coordinates& w) {
  Equations rows(w.size());
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (const Coordinates& c : columns) rows[i].push_back(c[i]);
    rows[i].push_back(w[i]);
  }
  return solve(rows, columns.size());
}

/// Positive outside: of the largest of some signed excesses over a set that has an interior.
inline Location location(int excess) {
  return excess > 0 ? Location::outside : Location{static_cast<signed char>(-excess)};
}
inline Location boundary_if(bool member) { return member ? Location::boundary : Location::outside; }

/// Is p in the convex hull of the points?  It is in that of some affinely independent ones (Caratheodory).
inline bool in_hull(const std::vector<Coordinates>& points, const Coordinates& p) {
  const std::size_t dimension = p.size();
  std::vector<std::size_t> chosen;
  const auto in_chosen = [&] {
    Equations rows(dimension + 1);
    for (const std::size_t c : chosen) {
      for (std::size_t i = 0; i < dimension; ++i) rows[i].push_back(points[c][i]);
      rows[dimension].push_back(1);
    }
    for (std::size_t i = 0; i < dimension; ++i) rows[i].push_back(p[i]);
    rows[dimension].push_back(1);
    const Solution s = solve(rows, chosen.size());
    return s.rank == chosen.size() && s.unknowns &&
           std::ranges::all_of(*s.unknowns, [](const Rational& weight) { return weight >= 0; });
  };
  const auto try_from = [&](const auto& self, std::size_t next) -> bool {
    if (!chosen.empty() && in_chosen()) return true;
    if (chosen.size() == dimension + 1) return false;
    for (std::size_t i = next; i < points.size(); ++i) {
      chosen.push_back(i);
      if (self(self, i + 1)) return true;
      chosen.pop_back();
    }
    return false;
  };
  return try_from(try_from, 0);
}

/// Of a simplex with as many corners as the space has dimensions and one more; of fewer there is no inside.
inline Location in_simplex(const std::vector<Coordinates>& corners, const Coordinates& p) {
  std::vector<Coordinates> edges;
  for (std::size_t i = 1; i < corners.size(); ++i) edges.push_back(difference(corners[i], corners[0]));
  const Solution s = solve_columns(edges, difference(p, corners[0]));
  if (s.rank < p.size()) return boundary_if(in_hull(corners, p));
  Rational least = 1;
  for (const Rational& weight : *s.unknowns) least -= weight;
  for (const Rational& weight : *s.unknowns) least = std::min(least, weight);
  return location(-sgn(least));
}

/// The way from the nearest point of a line (from <= t <= to, where given) to p, squared.
struct Foot {
  std::optional<Rational> t;  // none for a line of zero direction
  Rational squared_distance;
};
inline Foot foot(const Coordinates& point, const Coordinates& direction, const Coordinates& p,
                 std::optional<Rational> from = {}, std::optional<Rational> to = {}) {
  const Coordinates w = difference(p, point);
  if (square(direction) == 0) return {{}, square(w)};
  Rational t = dot(w, direction) / square(direction);
  if (from && t < *from) t = *from;
  if (to && t > *to) t = *to;
  return {t, square(combination(w, -t, direction))};
}

inline Rational squared(double x) { return Rational(x) * Rational(x); }

template <class Line>
requires requires(Line l) { l.point; }
Location locate(const Line& line, const auto& p) {
  return boundary_if(foot(of(line.point), of(line.direction), of(p)).squared_distance == 0);
}
template <class Ray>
requires requires(Ray r) { r.origin; }
Location locate(const Ray& ray, const auto& p) {
  return boundary_if(foot(of(ray.origin), of(ray.direction), of(p), Rational(0)).squared_distance == 0);
}
inline Location locate(const Segment2& s, const Point2& p) { return boundary_if(in_hull({of(s.a), of(s.b)}, of(p))); }
inline Location locate(const Segment3& s, const Point3& p) { return boundary_if(in_hull({of(s.a), of(s.b)}, of(p))); }

inline Location locate(const Plane3& plane, const Point3& p) {
  if (dot(of(plane.normal), of(p)) != plane.offset) return Location::outside;
  return plane.normal == Vector3{0, 0, 0} ? Location::inside : Location::boundary;
}
inline Location locate(const ThreePointPlane3& plane, const Point3& p) {
  const Coordinates a = of(plane.a);
  return boundary_if(solve_columns({difference(of(plane.b), a), difference(of(plane.c), a)}, difference(of(p), a))
                         .unknowns.has_value());
}
template <class Halfspace>
requires requires(Halfspace h) { h.offset; }
Location locate(const Halfspace& halfspace, const auto& p) {
  const Rational excess = dot(of(halfspace.normal), of(p)) - Rational(halfspace.offset);
  if (square(of(halfspace.normal)) == 0) return excess > 0 ? Location::outside : Location::inside;
  return location(sgn(excess));
}
template <class Slab>
requires requires(Slab s) { s.normal, s.min; }
Location locate(const Slab& slab, const auto& p) {
  const Rational along = dot(of(slab.normal), of(p));
  if (along < slab.min || along > slab.max) return Location::outside;
  const bool everywhere = square(of(slab.normal)) == 0;
  return everywhere || (along > slab.min && along < slab.max) ? Location::inside : Location::boundary;
}
template <class Intersection>
requires requires(Intersection i) { i.halfspaces; }
Location locate(const Intersection& intersection, const auto& p) {
  Location all = Location::inside;
  for (const auto& h : intersection.halfspaces) all = std::min(all, exact::locate(h, p));
  return all;
}

inline Location locate(const Triangle2& t, const Point2& p) { return in_simplex({of(t.a), of(t.b), of(t.c)}, of(p)); }
inline Location locate(const Triangle3& t, const Point3& p) {
  return boundary_if(in_hull({of(t.a), of(t.b), of(t.c)}, of(p)));
}
inline Location locate(const Tetrahedron3& t, const Point3& p) {
  return in_simplex({of(t.a), of(t.b), of(t.c), of(t.d)}, of(p));
}

template <class Ball>
requires requires(Ball b) { b.center, b.radius; }
Location locate(const Ball& ball, const auto& p) {
  return location(sgn(Rational(square(difference(of(p), of(ball.center))) - squared(ball.radius))));
}
template <class Capsule>
Location in_capsule(const Capsule& c, const auto& p) {
  const Foot f = foot(of(c.a), difference(of(c.b), of(c.a)), of(p), Rational(0), Rational(1));
  return location(sgn(Rational(f.squared_distance - squared(c.radius))));
}
inline Location locate(const Capsule2& c, const Point2& p) { return in_capsule(c, p); }
inline Location locate(const Capsule3& c, const Point3& p) { return in_capsule(c, p); }

/// Around an axis from t = 0 to t = 1, within a radius for t; the ball around its start where it has no length.
template <class Radius>
Location around_axis(const Point3& from, const Point3& to, const Point3& p, double ball, Radius squared_radius) {
  const Foot f = foot(of(from), difference(of(to), of(from)), of(p));
  if (!f.t) return location(sgn(Rational(f.squared_distance - squared(ball))));
  if (*f.t < 0 || *f.t > 1) return Location::outside;
  const int excess = sgn(Rational(f.squared_distance - squared_radius(*f.t)));
  return excess < 0 && (*f.t == 0 || *f.t == 1) ? Location::boundary : location(excess);
}
inline Location locate(const Cylinder3& c, const Point3& p) {
  return around_axis(c.a, c.b, p, c.radius, [&](const Rational&) { return squared(c.radius); });
}
inline Location locate(const Cone3& c, const Point3& p) {
  return around_axis(c.apex, c.base, p, c.radius,
                     [&](const Rational& t) { return Rational(squared(c.radius) * t * t); });
}

/// The least squared distance to corner + s u + t v: of the feet on the sides, and of the point where both derivatives
/// vanish, if it is between them.
inline Location locate(const Lozenge3& lozenge, const Point3& p) {
  const Coordinates corner = of(lozenge.corner), u = of(lozenge.edges[0]), v = of(lozenge.edges[1]), x = of(p);
  const auto side = [&](const Coordinates& from, const Coordinates& along) {
    return foot(from, along, x, Rational(0), Rational(1)).squared_distance;
  };
  Rational least = std::min(
      {side(corner, u), side(corner, v), side(combination(corner, 1, u), v), side(combination(corner, 1, v), u)});
  const Coordinates w = difference(x, corner);
  const Solution s = solve({{dot(u, u), dot(u, v), dot(w, u)}, {dot(u, v), dot(v, v), dot(w, v)}}, 2);
  const auto in_range = [](const Rational& t) { return t >= 0 && t <= 1; };
  if (s.unknowns && std::ranges::all_of(*s.unknowns, in_range)) {
    const auto& st = *s.unknowns;
    least = std::min(least, square(combination(combination(w, -st[0], u), -st[1], v)));
  }
  return location(sgn(Rational(least - squared(lozenge.radius))));
}

inline std::vector<Coordinates> generators(std::vector<Coordinates> axes, const Coordinates& half) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (Rational& x : axes[i]) x *= half[i];
  }
  return axes;
}

/// With M of columns g_i: the shortest t with M t = w is M^T y with M M^T y = w, and its square y . w.
inline Location locate(const Ellipsoid3& e, const Point3& p) {
  const auto g = generators({of(e.axes[0]), of(e.axes[1]), of(e.axes[2])}, of(e.half));
  const Coordinates w = difference(of(p), of(e.center));
  Equations rows(3, Coordinates(3));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (const Coordinates& column : g) rows[i][j] += column[i] * column[j];
    }
    rows[i].push_back(w[i]);
  }
  const Solution s = solve(rows, 3);
  if (!s.unknowns) return Location::outside;
  const int excess = sgn(Rational(dot(*s.unknowns, w) - 1));
  return s.rank == 3 ? location(excess) : boundary_if(excess <= 0);
}

/// Unique multiples where the generators are as many as the dimensions and independent, else the hull of the corners.
inline Location in_zonotope(const Coordinates& center, const std::vector<Coordinates>& g, const Coordinates& p) {
  const Solution s = solve_columns(g, difference(p, center));
  if (s.rank == p.size()) {
    Rational most = 0;
    for (const Rational& t : *s.unknowns) most = std::max(most, Rational(abs(t)));
    return location(sgn(Rational(most - 1)));
  }
  if (!s.unknowns) return Location::outside;
  std::vector<Coordinates> corners{center};
  for (const Coordinates& generator : g) {
    if (square(generator) == 0) continue;
    std::vector<Coordinates> doubled;
    for (const Coordinates& c : corners) {
      doubled.push_back(combination(c, 1, generator));
      doubled.push_back(combination(c, -1, generator));
    }
    corners = doubled;
  }
  return boundary_if(in_hull(corners, p));
}
inline Location locate(const Obb2& b, const Point2& p) {
  return in_zonotope(of(b.center), generators({of(b.axes[0]), of(b.axes[1])}, of(b.half)), of(p));
}
inline Location locate(const Rectangle3& r, const Point3& p) {
  return in_zonotope(of(r.center), generators({of(r.axes[0]), of(r.axes[1])}, of(r.half)), of(p));
}
inline Location locate(const Obb3& b, const Point3& p) {
  return in_zonotope(of(b.center), generators({of(b.axes[0]), of(b.axes[1]), of(b.axes[2])}, of(b.half)), of(p));
}

inline Location between(const Coordinates& min, const Coordinates& max, const Coordinates& p) {
  Location all = Location::inside;
  for (std::size_t i = 0; i < p.size(); ++i) {
    all = std::min({all, location(sgn(Rational(min[i] - p[i]))), location(sgn(Rational(p[i] - max[i])))});
  }
  return all;
}
inline Coordinates magnitudes(Coordinates x) {
  for (Rational& c : x) c = abs(c);
  return x;
}
inline Location locate(const Aabb2& b, const Point2& p) { return between(of(b.min), of(b.max), of(p)); }
inline Location locate(const Aabb3& b, const Point3& p) { return between(of(b.min), of(b.max), of(p)); }
inline Location locate(const AabbWidths3& b, const Point3& p) {
  return between(of(b.min), combination(of(b.min), 1, magnitudes(of(b.widths))), of(p));
}
inline Location locate(const AabbCenter3& b, const Point3& p) {
  const Coordinates half = magnitudes(of(b.half));
  return between(combination(of(b.center), -1, half), combination(of(b.center), 1, half), of(p));
}

}  // namespace plumb::exact

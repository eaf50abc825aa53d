// Segment intersection: how do lines, rays and segments in the plane lie to one another, and to points?  The signs of
// all 2D tests.
//
// Laws: one of zero direction, or of equal ends, is its point.  A direction that is the difference of two points is
// never rounded: the signs are those of the points.  Where two lines cross, the place of the crossing on each is told
// by the sides on which its ends lie of the other.
// Source: RTCD 5.1.9.1.
// Cost: one to five signs of degree 2.
#pragma once

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "query/overlap/signs.hpp"

namespace plumb::query {

enum class LinearKind : unsigned char { line, ray, segment };

/// (vector d, point p, point r): the side of the line from p along d on which r lies.
struct CrossFrom {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{2, 2, 2};
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return p[0] * (p[5] - p[3]) - p[1] * (p[4] - p[2]);
  }
};

struct Linear2 {
  LinearKind reach;
  bool by_points;  // the direction is that from p to q; otherwise q holds its coordinates
  Point2 p, q;

  static Linear2 through(LinearKind reach, const Point2& p, const Point2& q) { return {reach, true, p, q}; }
  static Linear2 along(LinearKind reach, const Point2& p, const Vector2& d) { return {reach, false, p, {d.x, d.y}}; }

  [[nodiscard]] bool is_point() const { return by_points ? p == q : q.x == 0 && q.y == 0; }
  /// The sign of the direction along each axis.
  [[nodiscard]] Sign heads_x() const { return by_points ? order(q.x, p.x) : order(q.x, 0); }
  [[nodiscard]] Sign heads_y() const { return by_points ? order(q.y, p.y) : order(q.y, 0); }
  /// Positive where r lies to the left.  Inline, so that what was made a moment ago is not read back from memory.
  [[nodiscard]] Sign side(const Point2& r) const {
    return by_points ? query::orient2d(p, q, r) : sign_of(CrossFrom{}, Vector2{q.x, q.y}, p, r);
  }
};

inline Linear2 linear(const Line2& l) { return Linear2::along(LinearKind::line, l.point, l.direction); }
inline Linear2 linear(const Ray2& r) { return Linear2::along(LinearKind::ray, r.origin, r.direction); }
inline Linear2 linear(const Segment2& s) { return Linear2::through(LinearKind::segment, s.a, s.b); }

/// Positive where the direction of b turns to the left of that of a.
Sign turn(const Linear2& a, const Linear2& b);

Relation relate(const Linear2& a, const Linear2& b);
Relation relate(const Point2& p, const Linear2& b);

}  // namespace plumb::query

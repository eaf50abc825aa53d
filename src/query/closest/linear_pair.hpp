// Closest points of segments: where do two lines, rays or segments come closest?  Which places of each, by signs; then
// the points, as quotients.
//
// Laws: (1) the places are those of a closest pair, an end before the inside.  (2) There is but one closest pair unless
// both are parallel; of those that one is taken which comes first in lexicographic order of coordinates (all differ by
// one vector, so both of its ends come first), where there is no first one (a ray that comes from below, so to say) the
// end of the pairs, and of two parallel lines the first of the pairs at their given points.  (3) All this is said of
// the sets of points: it does not matter which end or which of the two is named first.  (4) Over a number type whose
// signs are not certain the question says so, and the places mean nothing.
// Source: RTCD 5.1.8, 5.1.9; figures 5.7
// to 5.11.
// Cost: 50 to 90 operations.
#pragma once

#include <cstdint>

#include "plumb/figure/basic/linear.hpp"
#include "query/body/pair_numbers.hpp"

namespace plumb::query {

/// `given`: the point that a line is given by, for one of two parallel lines.
enum class SpotOnLine : std::uint8_t { start, end, inside, given };

struct SpotsOnLines {
  SpotOnLine a, b;
  [[nodiscard]] SpotsOnLines swapped() const { return {b, a}; }
};

/// A line, ray or segment over a number type: from + s along, 0 <= s where it starts, s <= 1 where it ends.
template <class V, class Point>
struct LinearFigure {
  Point from, to;  // `to` of segments only
  V along;
  bool starts, ends, is_point;
  int order;  // of `along`: positive where it leads to what comes later in lexicographic order

  [[nodiscard]] const Point& at(SpotOnLine place) const { return place == SpotOnLine::end ? to : from; }
};

inline int order_of(const Vector2& v) { return v.x != 0 ? (v.x > 0 ? 1 : -1) : (v.y > 0) - !(v.y >= 0); }
inline int order_of(const Vector3& v) {
  return v.x != 0 ? (v.x > 0 ? 1 : -1) : v.y != 0 ? (v.y > 0 ? 1 : -1) : (v.z > 0) - !(v.z >= 0);
}
inline int order_of(const Point2& a, const Point2& b) {
  return a.x != b.x ? (b.x > a.x ? 1 : -1) : (b.y > a.y) - !(b.y >= a.y);
}
inline int order_of(const Point3& a, const Point3& b) {
  return a.x != b.x ? (b.x > a.x ? 1 : -1) : a.y != b.y ? (b.y > a.y ? 1 : -1) : (b.z > a.z) - !(b.z >= a.z);
}

template <class Point>
using VectorOf = std::conditional_t<std::is_same_v<Point, Point2>, Vector2, Vector3>;

/// The same of doubles, in one form for all.
template <class Point>
struct Straight {
  Point from, to;
  VectorOf<Point> direction;  // where it does not end
  bool starts, ends, is_point;
  int order;

  [[nodiscard]] const Point& at(SpotOnLine place) const { return place == SpotOnLine::end ? to : from; }
};

inline Straight<Point2> straight(const Segment2& s) {
  const int order = order_of(s.a, s.b);
  return {s.a, s.b, {0, 0}, true, true, order == 0, order};
}
inline Straight<Point3> straight(const Segment3& s) {
  const int order = order_of(s.a, s.b);
  return {s.a, s.b, {0, 0, 0}, true, true, order == 0, order};
}
template <class Point>
Straight<Point> straight(const Point& from, const VectorOf<Point>& direction, bool starts) {
  const int order = order_of(direction);
  return {from, from, direction, starts, false, order == 0, order};
}
inline Straight<Point2> straight(const Ray2& r) { return straight(r.origin, r.direction, true); }
inline Straight<Point3> straight(const Ray3& r) { return straight(r.origin, r.direction, true); }
inline Straight<Point2> straight(const Line2& l) { return straight(l.point, l.direction, false); }
inline Straight<Point3> straight(const Line3& l) { return straight(l.point, l.direction, false); }

template <class T, class Point>
[[gnu::always_inline]] inline LinearFigure<VecOf<Point, T>, Point> linear(const Straight<Point>& s) {
  return {s.from,     s.to,   s.ends ? between<T>(s.from, s.to) : vector_of<T>(s.direction), s.starts, s.ends,
          s.is_point, s.order};
}
template <class T, class S>
requires requires(const S& s) { straight(s); }
[[gnu::always_inline]] inline auto linear(const S& s) { return linear<T>(straight(s)); }

/// Where s = numerator / whole lies, whole > 0.
template <class T, class L>
SpotOnLine place_on(const L& l, const T& numerator, const T& whole, CertainSigns& ask) {
  if (l.starts && ask(numerator) != Sign::positive) return SpotOnLine::start;
  if (l.ends && ask(whole - numerator) != Sign::positive) return SpotOnLine::end;
  return SpotOnLine::inside;
}

/// The place on l that is nearest to a point.
template <class T, class Point>
SpotOnLine place_near(const LinearFigure<VecOf<Point, T>, Point>& l, const Point& p, CertainSigns& ask) {
  if (l.is_point) return SpotOnLine::start;
  if (l.starts && ask(dot(between<T>(l.from, p), l.along)) != Sign::positive) return SpotOnLine::start;
  if (l.ends && ask(dot(between<T>(p, l.to), l.along)) != Sign::positive) return SpotOnLine::end;
  return SpotOnLine::inside;
}

/// Of parallel p and q, neither a point.
template <class T, class Point>
SpotsOnLines parallel_places(const LinearFigure<VecOf<Point, T>, Point>& p,
                             const LinearFigure<VecOf<Point, T>, Point>& q, CertainSigns& ask) {
  const bool same_way = ask(dot(p.along, q.along)) == Sign::positive;
  // What of q comes first and last in the direction of p.
  const bool has_low = same_way ? q.starts : q.ends, has_high = same_way ? q.ends : q.starts;
  const SpotOnLine low = same_way ? SpotOnLine::start : SpotOnLine::end,
                   high = same_way ? SpotOnLine::end : SpotOnLine::start;
  // How much farther than a place of p a place of q is.
  const auto farther = [&](SpotOnLine on_p, SpotOnLine on_q) {
    return ask(dot(between<T>(p.at(on_p), q.at(on_q)), p.along));
  };
  if (p.ends && has_low && farther(SpotOnLine::end, low) != Sign::negative) return {SpotOnLine::end, low};
  if (p.starts && has_high && farther(SpotOnLine::start, high) != Sign::positive) return {SpotOnLine::start, high};
  const bool lower_end = p.starts || has_low, upper_end = p.ends || has_high;
  if (lower_end && (p.order > 0 || !upper_end)) {
    const Sign s = !has_low ? Sign::negative : !p.starts ? Sign::positive : farther(SpotOnLine::start, low);
    return {s == Sign::positive ? SpotOnLine::inside : SpotOnLine::start,
            s == Sign::negative ? SpotOnLine::inside : low};
  }
  if (upper_end) {
    const Sign s = !has_high ? Sign::positive : !p.ends ? Sign::negative : farther(SpotOnLine::end, high);
    return {s == Sign::negative ? SpotOnLine::inside : SpotOnLine::end,
            s == Sign::positive ? SpotOnLine::inside : high};
  }
  const Sign s = farther(SpotOnLine::given, SpotOnLine::given);
  return (s == Sign::positive) == (p.order > 0) ? SpotsOnLines{SpotOnLine::given, SpotOnLine::inside}
                                                : SpotsOnLines{SpotOnLine::inside, SpotOnLine::given};
}

/// The least distance of a point within p from the line of q is at numerator / whole; where that is beyond an end, the
/// least of all is at the end.  The distance is a convex function of both parameters (RTCD 5.1.9).
template <class T, class Point>
SpotsOnLines closest_places(const LinearFigure<VecOf<Point, T>, Point>& p,
                            const LinearFigure<VecOf<Point, T>, Point>& q, CertainSigns& ask) {
  if (p.is_point) return {SpotOnLine::start, place_near<T>(q, p.from, ask)};
  if (q.is_point) return {place_near<T>(p, q.from, ask), SpotOnLine::start};
  const auto n = cross(p.along, q.along);
  const T whole = dot(n, n);
  if (ask(whole) != Sign::positive) return ask.certain() ? parallel_places<T>(p, q, ask) : SpotsOnLines{};
  const auto w = between<T>(p.from, q.from);
  const SpotOnLine on_p = p.starts || p.ends ? place_on(p, dot(cross(w, q.along), n), whole, ask) : SpotOnLine::inside;
  SpotOnLine on_q = SpotOnLine::inside;
  if (on_p == SpotOnLine::inside) {
    if (q.starts || q.ends) on_q = place_on(q, dot(cross(w, p.along), n), whole, ask);
    if (on_q == SpotOnLine::inside) return {on_p, on_q};
  } else {
    on_q = place_near<T>(q, p.at(on_p), ask);
    if (on_q == SpotOnLine::inside) return {on_p, on_q};
  }
  return {place_near<T>(p, q.at(on_q), ask), on_q};
}

/// What w has of the common normal; in the plane there is none.
template <class T>
[[gnu::always_inline]] inline T normal_gap(const Vec3<T>& w, const Vec3<T>& n) {
  return dot(w, n);
}
template <class T>
[[gnu::always_inline]] inline T normal_gap(const Vec2<T>&, const Normal2<T>&) {
  return T(0.0);
}

template <class T, class Point>
[[gnu::always_inline]] inline PointOn<T, Point> end_of(const LinearFigure<VecOf<Point, T>, Point>& l,
                                                       SpotOnLine place) {
  return {l.at(place), l.along, T(0.0), T(1.0)};
}

/// A place of a closest pair that is no inside of both parallel ones, with its numbers.
template <class T, class Point>
[[gnu::always_inline]] inline ClosePair<T, Point> close_pair(const LinearFigure<VecOf<Point, T>, Point>& p,
                                                             const LinearFigure<VecOf<Point, T>, Point>& q,
                                                             const SpotsOnLines& places) {
  const bool p_inside = places.a == SpotOnLine::inside, q_inside = places.b == SpotOnLine::inside;
  if (p_inside && q_inside) {
    const auto n = cross(p.along, q.along);
    const auto w = between<T>(p.from, q.from);
    const T whole = dot(n, n), gap = normal_gap(w, n);
    return {{p.from, p.along, dot(cross(w, q.along), n), whole},
            {q.from, q.along, dot(cross(w, p.along), n), whole},
            gap * gap,
            whole};
  }
  if (!p_inside && !q_inside) {
    const auto w = between<T>(p.at(places.a), q.at(places.b));
    return {end_of<T>(p, places.a), end_of<T>(q, places.b), dot(w, w), T(1.0)};
  }
  const auto& l = p_inside ? p : q;
  const Point& from = p_inside ? q.at(places.b) : p.at(places.a);
  const auto w = between<T>(l.from, from);
  const auto c = cross(w, l.along);
  const T whole = dot(l.along, l.along);
  const PointOn<T, Point> foot{l.from, l.along, dot(w, l.along), whole};
  if (p_inside) return {foot, end_of<T>(q, places.b), dot(c, c), whole};
  return {end_of<T>(p, places.a), foot, dot(c, c), whole};
}

}  // namespace plumb::query

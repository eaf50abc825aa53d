// Which pairs need no sets of bounds?  Those that a few signs part, and those that cross in one point inside of both.
//
// Laws: what is answered is exact; nothing where signs are zero that leave a choice, and the general way has to tell.
// Source: RTCD 5.1.9.1, 5.3.4, 5.3.6, 5.2.10.  Cost: 5 to 100 ns, and the allocation of what is in common.
#pragma once

#include <optional>

#include "plumb/predicates.hpp"
#include "plumb/query/intersection.hpp"

namespace plumb::meeting {

inline bool strictly_same(Sign a, Sign b) { return a * b == Sign::positive; }
inline bool opposite(Sign a, Sign b) { return a * b == Sign::negative; }

template <class A, class B>
using Common = decltype(intersection(std::declval<A>(), std::declval<B>()));

/// By doubles, whatever they are; for figures of which nothing is known the general way tells.
template <class A, class B>
std::optional<Common<A, B>> quick(const A&, const B&) {
  return {};
}
std::optional<Intersection2> quick(const Segment2& s, const Segment2& t);
std::optional<Intersection2> quick(const Triangle2& t, const Triangle2& u);
std::optional<Intersection3> quick(const Segment3& s, const Triangle3& t);
std::optional<Intersection3> quick(const Triangle3& t, const Triangle3& u);

/// By exact signs, of real numbers.
template <class A, class B>
std::optional<Common<A, B>> by_signs(const A&, const B&) {
  return {};
}

/// Of segments of one line, points among them.
inline Intersection2 on_one_line(const Segment2& s, const Segment2& t) {
  const auto least = [](const Point2& p, const Point2& q) {
    return compare_lexicographically(p, q) == Sign::positive ? q : p;
  };
  const auto most = [](const Point2& p, const Point2& q) {
    return compare_lexicographically(p, q) == Sign::positive ? p : q;
  };
  const Point2 from = most(least(s.a, s.b), least(t.a, t.b)), to = least(most(s.a, s.b), most(t.a, t.b));
  const Sign order = compare_lexicographically(from, to);
  if (order == Sign::positive) return {};
  if (order == Sign::zero) return {IntersectionKind::point, {from}};
  return {IntersectionKind::segment, {from, to}};
}

inline std::optional<Intersection2> by_signs(const Segment2& s, const Segment2& t) {
  const Sign a = orient2d(s.a, s.b, t.a), b = orient2d(s.a, s.b, t.b);
  if (strictly_same(a, b)) return Intersection2{};
  const Sign c = orient2d(t.a, t.b, s.a), d = orient2d(t.a, t.b, s.b);
  if (strictly_same(c, d)) return Intersection2{};
  const auto point = [](const ExactPoint2& p) { return Intersection2{IntersectionKind::point, {p}}; };
  if (opposite(a, b) && opposite(c, d)) return point(LineLinePoint2{s.a, s.b, t.a, t.b});
  if (a == Sign::zero && b == Sign::zero && c == Sign::zero && d == Sign::zero) return on_one_line(s, t);
  // The lines cross in one point, where one segment ends.
  return point(a == Sign::zero ? t.a : b == Sign::zero ? t.b : c == Sign::zero ? s.a : s.b);
}

std::optional<Intersection2> by_signs(const Triangle2& t, const Triangle2& u);
std::optional<Intersection3> by_signs(const Segment3& s, const Triangle3& t);
std::optional<Intersection3> by_signs(const Triangle3& t, const Triangle3& u);

inline std::optional<Intersection3> by_signs(const Triangle3& t, const Aabb3& b) {
  const auto outside = [](double x, double y, double z, double min, double max) {
    return (x < min && y < min && z < min) || (x > max && y > max && z > max);
  };
  if (outside(t.a.x, t.b.x, t.c.x, b.min.x, b.max.x) || outside(t.a.y, t.b.y, t.c.y, b.min.y, b.max.y) ||
      outside(t.a.z, t.b.z, t.c.z, b.min.z, b.max.z))
    return Intersection3{};
  return {};
}

}  // namespace plumb::meeting

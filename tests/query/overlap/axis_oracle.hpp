// How does a cylinder or a cone lie to what is straight or a plane?  From the structs' comments, in rationals: by the
// places along a line where something can change, and by what a disk reaches along a normal.
//
// Laws: exact.  A shape without axis is a ball, one of radius zero a segment.
// Cost: some 10 us.
#pragma once

#include "query/overlap/round_oracle.hpp"

namespace plumb::oracle {

struct AxisShape {
  RationalPoint from, axis;
  mpq_class radius;
  bool is_cone;

  [[nodiscard]] bool is_ball() const { return polygon_detail::is_zero(axis); }
  [[nodiscard]] Spanned core() const {
    Spanned all{{from}, {}};
    if (!is_ball()) all.points.push_back(sum(from, 1, axis));
    return all;
  }
};
inline AxisShape axis_shape(const Cylinder3& c) {
  return {rational(c.a), difference(rational(c.b), rational(c.a)), c.radius, false};
}
inline AxisShape axis_shape(const Cone3& c) {
  return {rational(c.apex), difference(rational(c.base), rational(c.apex)), c.radius, true};
}

/// Below zero inside the infinite surface, for a share `along` of the axis.
inline mpq_class beyond_surface(const AxisShape& s, const RationalPoint& p, const mpq_class& along) {
  const RationalPoint off = sum(difference(p, s.from), -along, s.axis);
  const mpq_class reach = s.is_cone ? mpq_class(s.radius * along) : s.radius;
  return dot(off, off) - reach * reach;
}

struct RationalLine {
  RationalPoint from, along;
  std::optional<mpq_class> first, last;
};
inline RationalLine rational_line(const Point3& p) { return {rational(p), {}, {}, {}}; }
inline RationalLine rational_line(const Line3& l) { return {rational(l.point), rational(l.direction), {}, {}}; }
inline RationalLine rational_line(const Ray3& r) {
  return {rational(r.origin), rational(r.direction), mpq_class(0), {}};
}
inline RationalLine rational_line(const Segment3& s) {
  return {rational(s.a), difference(rational(s.b), rational(s.a)), mpq_class(0), mpq_class(1)};
}

inline Relation relation(const RationalLine& line, const AxisShape& s) {
  const mpq_class square = dot(s.axis, s.axis);
  const auto share = [&](const mpq_class& t) {
    return mpq_class(dot(difference(sum(line.from, t, line.along), s.from), s.axis) / square);
  };
  const auto value = [&](const mpq_class& t) { return beyond_surface(s, sum(line.from, t, line.along), share(t)); };
  const mpq_class start = share(0), rise = share(1) - start;
  if (polygon_detail::is_zero(line.along)) {
    const mpq_class off = value(0);
    if (start < 0 || start > 1 || off > 0) return Relation::disjoint;
    return start > 0 && start < 1 && off < 0 ? Relation::overlapping : Relation::touching;
  }
  auto [first, last] = std::pair(line.first, line.last);
  bool strictly = true;
  if (rise == 0) {
    if (start < 0 || start > 1) return Relation::disjoint;
    strictly = start > 0 && start < 1;
  } else {
    const mpq_class at0 = -start / rise, at1 = (1 - start) / rise;
    const mpq_class in = std::min(at0, at1), out = std::max(at0, at1);
    if (!first || in > *first) first = in;
    if (!last || out < *last) last = out;
  }
  if (first && last && *first > *last) return Relation::disjoint;
  const bool has_length = !first || !last || *first < *last;
  // The quadratic through three values.
  const mpq_class v0 = value(0), v1 = value(1), v2 = value(2);
  const mpq_class a = (v2 - 2 * v1 + v0) / 2, b = v1 - v0 - a;
  std::vector<mpq_class> places;
  if (first) places.push_back(*first);
  if (last) places.push_back(*last);
  if (a > 0) {
    const mpq_class bottom = -b / (2 * a);
    if ((!first || bottom > *first) && (!last || bottom < *last)) places.push_back(bottom);
  }
  if (places.empty()) places.push_back(0);
  mpq_class least = value(places[0]);
  for (const mpq_class& t : places) least = std::min(least, value(t));
  if (least > 0) return Relation::disjoint;
  return least < 0 && has_length && strictly ? Relation::overlapping : Relation::touching;
}

/// The sign of h - root of square, for square >= 0.
inline int above_root(const mpq_class& h, const mpq_class& square) {
  return sgn(h) < 0 ? -1 : sgn(mpq_class(h * h - square));
}

/// normal . x = offset, or <=, where the normal is not zero.
inline Relation relation(const RationalPoint& n, const mpq_class& offset, bool halfspace, const AxisShape& s) {
  const mpq_class along = dot(n, s.axis);
  const mpq_class reach = s.radius * s.radius * (dot(n, n) - along * along / dot(s.axis, s.axis));
  const mpq_class low = dot(n, s.from) - offset, high = low + along;
  const mpq_class of_from = s.is_cone ? mpq_class(0) : reach;
  const int above = std::min(above_root(low, of_from), above_root(high, reach));
  if (halfspace) return static_cast<Relation>(-above);
  const int below = std::min(above_root(-low, of_from), above_root(-high, reach));
  return static_cast<Relation>(-std::max(above, below));
}

template <class Other, class Round>
Relation relation_to_axis_shape(const Other& other, const Round& round) {
  const AxisShape s = axis_shape(round);
  if (s.is_ball() || s.radius == 0) return RoundOracle(s.core(), {{spanned(other)}, {}}).relation(s.radius);
  if constexpr (requires { other.normal; }) {
    if (other.normal == Vector3{0, 0, 0}) return RoundOracle(s.core(), {{spanned(other)}, {}}).relation(s.radius);
    return relation(rational(other.normal), other.offset, std::is_same_v<Other, Halfspace3>, s);
  } else if constexpr (std::is_same_v<Other, ThreePointPlane3>) {  // or the line or place that the points are on
    const RationalPoint a = rational(other.a), u = difference(rational(other.b), a),
                        v = difference(rational(other.c), a), n = polygon_detail::cross(u, v);
    if (!polygon_detail::is_zero(n)) return relation(n, dot(n, a), false, s);
    return relation(RationalLine{a, polygon_detail::is_zero(u) ? v : u, {}, {}}, s);
  } else {
    return relation(rational_line(other), s);
  }
}

}  // namespace plumb::oracle

// How do signs make a relation?  What is inside of all has the least of the answers.
//
// Laws: for sets whose difference has an interior, and the gap along each axis that can separate them, the relation is
// the least of the answers along the axes: apart along one is apart, level along one is touching at most.
// Source: RTCD 5.2.1.
// Cost: none.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::query {

/// Along an axis where a positive sign is an overlap, a negative one a gap.
constexpr Relation relation(Sign inside) { return static_cast<Relation>(inside); }

constexpr Relation least(Relation a, Relation b) { return a < b ? a : b; }
constexpr Sign least(Sign a, Sign b) { return a < b ? a : b; }
constexpr Sign most(Sign a, Sign b) { return a > b ? a : b; }

/// The order of two coordinates as given.
constexpr Sign order(double a, double b) { return static_cast<Sign>((a > b) - (a < b)); }

inline Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of(predicates::Orient2d{}, a, b, c);
}
inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(predicates::Orient3d{}, a, b, c, d);
}

/// The closed intervals of two numbers each, which may be infinite; by their relative interiors.
struct ClosedRange {
  double low, high;
};
constexpr Relation relate_ranges(const ClosedRange& a, const ClosedRange& b) {
  const bool a_is_point = a.low == a.high, b_is_point = b.low == b.high;
  if (a_is_point && b_is_point) return a.low == b.low ? Relation::overlapping : Relation::disjoint;
  const double from = std::max(a.low, b.low), to = std::min(a.high, b.high);
  if (a_is_point || b_is_point) {
    const ClosedRange& range = a_is_point ? b : a;
    const double x = a_is_point ? a.low : b.low;
    return static_cast<Relation>((range.low <= x && x <= range.high) + (range.low < x && x < range.high) - 1);
  }
  return relation(order(to, from));
}

}  // namespace plumb::query

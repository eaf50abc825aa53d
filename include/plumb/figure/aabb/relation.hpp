// Bounding volumes (AABB): do two axis-aligned boxes meet, and does one hold the other?  In each of their three
// representations.
//
// Laws: (1) the closed sets of the numbers in real arithmetic decide: min + widths and center + half are never rounded.
// (2) relate and intersects are symmetric; intersects(a, b) is relate(a, b) != disjoint.  (3) An empty box meets
// nothing, and every box holds it.  (4) The three representations of one box answer alike.
// NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 4.2.1, 6.5.1.
// Cost: min-max boxes that of the plain test, without branches on what is found: the sum of all numbers is finite only
// where each is.
#pragma once

#include <span>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

namespace figure::box {

constexpr double larger(double x, double y) { return x > y ? x : y; }
constexpr double smaller(double x, double y) { return x < y ? x : y; }

/// The largest of (later start - earlier end) over the axes: positive when apart, negative when the interiors meet.
/// NaN where a number may not be finite.
constexpr double gap(const Aabb2& a, const Aabb2& b) {
  const double all = ((a.min.x + a.max.x) + (b.min.x + b.max.x)) + ((a.min.y + a.max.y) + (b.min.y + b.max.y));
  const double x = larger(a.min.x, b.min.x) - smaller(a.max.x, b.max.x);
  const double y = larger(a.min.y, b.min.y) - smaller(a.max.y, b.max.y);
  return larger(x, y) + (all - all);
}
constexpr double gap(const Aabb3& a, const Aabb3& b) {
  const double all = ((a.min.x + a.max.x) + (b.min.x + b.max.x)) + ((a.min.y + a.max.y) + (b.min.y + b.max.y)) +
                     ((a.min.z + a.max.z) + (b.min.z + b.max.z));
  const double x = larger(a.min.x, b.min.x) - smaller(a.max.x, b.max.x);
  const double y = larger(a.min.y, b.min.y) - smaller(a.max.y, b.max.y);
  const double z = larger(a.min.z, b.min.z) - smaller(a.max.z, b.max.z);
  return larger(larger(x, y), z) + (all - all);
}

/// For boxes that touch, are flat, or whose numbers add up to no double; `function` is what a failure names.
Relation relate_exactly(std::string_view function, const Aabb2& a, const Aabb2& b);
Relation relate_exactly(std::string_view function, const Aabb3& a, const Aabb3& b);

template <class Box>
Relation relate(const Box& a, const Box& b) {
  const double g = gap(a, b);
  if (g > 0) return Relation::disjoint;
  if (g < 0) return Relation::overlapping;
  return relate_exactly("relate", a, b);
}

template <class Box>
bool intersects(const Box& a, const Box& b) {
  const double g = gap(a, b);
  if (g - g == 0) [[likely]]
    return g <= 0;
  return relate_exactly("intersects", a, b) != Relation::disjoint;
}

}  // namespace figure::box

inline Relation relate(const Aabb2& a, const Aabb2& b) { return figure::box::relate(a, b); }
inline Relation relate(const Aabb3& a, const Aabb3& b) { return figure::box::relate(a, b); }
Relation relate(const AabbWidths3& a, const AabbWidths3& b);
Relation relate(const AabbCenter3& a, const AabbCenter3& b);

inline bool intersects(const Aabb2& a, const Aabb2& b) { return figure::box::intersects(a, b); }
inline bool intersects(const Aabb3& a, const Aabb3& b) { return figure::box::intersects(a, b); }
bool intersects(const AabbWidths3& a, const AabbWidths3& b);
bool intersects(const AabbCenter3& a, const AabbCenter3& b);

/// Does the outer box hold every point of the inner one?
bool contains(const Aabb2& outer, const Aabb2& inner);
bool contains(const Aabb3& outer, const Aabb3& inner);
bool contains(const AabbWidths3& outer, const AabbWidths3& inner);
bool contains(const AabbCenter3& outer, const AabbCenter3& inner);

}  // namespace plumb

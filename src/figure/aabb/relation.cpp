#include "plumb/figure/aabb/relation.hpp"

#include <algorithm>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

// x - y + w, x - y - v - w and the like: the numbers of one axis.
constexpr auto end_beyond = [](auto start, auto width, auto other) { return (start - other) + width; };
constexpr auto gap_of_centers = [](auto x, auto y, auto h, auto k) { return (x - y) - (h + k); };
constexpr auto excess = [](auto x, auto y, auto h, auto k) { return (x - y) + (h - k); };

// Of one axis, from the signs of (end of a - start of b) and (end of b - start of a); `points` where both are points.
// Where ends meet, the interiors of an interval and of anything else do not; two points that meet are equal.
Relation relation(Sign a_beyond, Sign b_beyond, bool points) {
  const Sign least = std::min(a_beyond, b_beyond);
  if (least == Sign::negative) return Relation::disjoint;
  return least == Sign::positive || points ? Relation::overlapping : Relation::touching;
}

// `empty` of a box: nothing it could share.
Relation of_axis(double a_min, double a_max, double b_min, double b_max) {
  if (a_min > a_max || b_min > b_max) return Relation::disjoint;
  const auto order = [](double x, double y) { return x > y ? Sign::positive : x < y ? Sign::negative : Sign::zero; };
  return relation(order(a_max, b_min), order(b_max, a_min), a_min == a_max && b_min == b_max);
}

Relation of_widths(double a, double a_width, double b, double b_width) {
  a_width = magnitude_of(a_width), b_width = magnitude_of(b_width);
  return relation(sign_of(end_beyond, a, a_width, b), sign_of(end_beyond, b, b_width, a), a_width == 0 && b_width == 0);
}

Relation of_centers(double a, double a_half, double b, double b_half) {
  a_half = magnitude_of(a_half), b_half = magnitude_of(b_half);
  const Sign gap = sign_of(gap_of_centers, std::max(a, b), std::min(a, b), a_half, b_half);
  if (gap == Sign::positive) return Relation::disjoint;
  return gap == Sign::negative || (a_half == 0 && b_half == 0) ? Relation::overlapping : Relation::touching;
}

bool widths_within(double outer, double outer_width, double inner, double inner_width) {
  return outer <= inner &&
         sign_of(excess, inner, outer, magnitude_of(inner_width), magnitude_of(outer_width)) != Sign::positive;
}

bool center_within(double outer, double outer_half, double inner, double inner_half) {
  return sign_of(excess, std::max(outer, inner), std::min(outer, inner), magnitude_of(inner_half),
                 magnitude_of(outer_half)) != Sign::positive;
}

Relation relate_widths(std::string_view function, const AabbWidths3& a, const AabbWidths3& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  const Relation x = of_widths(a.min.x, a.widths.x, b.min.x, b.widths.x);
  if (x == Relation::disjoint) return x;
  const Relation y = of_widths(a.min.y, a.widths.y, b.min.y, b.widths.y);
  if (y == Relation::disjoint) return y;
  return std::min({x, y, of_widths(a.min.z, a.widths.z, b.min.z, b.widths.z)});
}

Relation relate_centers(std::string_view function, const AabbCenter3& a, const AabbCenter3& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  const Relation x = of_centers(a.center.x, a.half.x, b.center.x, b.half.x);
  if (x == Relation::disjoint) return x;
  const Relation y = of_centers(a.center.y, a.half.y, b.center.y, b.half.y);
  if (y == Relation::disjoint) return y;
  return std::min({x, y, of_centers(a.center.z, a.half.z, b.center.z, b.half.z)});
}

}  // namespace

namespace figure::box {

Relation relate_exactly(std::string_view function, const Aabb2& a, const Aabb2& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  return std::min(of_axis(a.min.x, a.max.x, b.min.x, b.max.x), of_axis(a.min.y, a.max.y, b.min.y, b.max.y));
}

Relation relate_exactly(std::string_view function, const Aabb3& a, const Aabb3& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  return std::min({of_axis(a.min.x, a.max.x, b.min.x, b.max.x), of_axis(a.min.y, a.max.y, b.min.y, b.max.y),
                   of_axis(a.min.z, a.max.z, b.min.z, b.max.z)});
}

}  // namespace figure::box

Relation relate(const AabbWidths3& a, const AabbWidths3& b) { return relate_widths("relate", a, b); }
Relation relate(const AabbCenter3& a, const AabbCenter3& b) { return relate_centers("relate", a, b); }
bool intersects(const AabbWidths3& a, const AabbWidths3& b) {
  return relate_widths("intersects", a, b) != Relation::disjoint;
}
bool intersects(const AabbCenter3& a, const AabbCenter3& b) {
  return relate_centers("intersects", a, b) != Relation::disjoint;
}

bool contains(const Aabb2& outer, const Aabb2& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  if (is_empty(inner)) return true;
  return outer.min.x <= inner.min.x && inner.max.x <= outer.max.x &&  //
         outer.min.y <= inner.min.y && inner.max.y <= outer.max.y;
}

bool contains(const Aabb3& outer, const Aabb3& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  if (is_empty(inner)) return true;
  return outer.min.x <= inner.min.x && inner.max.x <= outer.max.x &&  //
         outer.min.y <= inner.min.y && inner.max.y <= outer.max.y &&  //
         outer.min.z <= inner.min.z && inner.max.z <= outer.max.z;
}

bool contains(const AabbWidths3& outer, const AabbWidths3& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  return widths_within(outer.min.x, outer.widths.x, inner.min.x, inner.widths.x) &&
         widths_within(outer.min.y, outer.widths.y, inner.min.y, inner.widths.y) &&
         widths_within(outer.min.z, outer.widths.z, inner.min.z, inner.widths.z);
}

bool contains(const AabbCenter3& outer, const AabbCenter3& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  return center_within(outer.center.x, outer.half.x, inner.center.x, inner.half.x) &&
         center_within(outer.center.y, outer.half.y, inner.center.y, inner.half.y) &&
         center_within(outer.center.z, outer.half.z, inner.center.z, inner.half.z);
}

}  // namespace plumb

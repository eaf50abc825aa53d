// Support mapping: how far apart are two convex bodies of which no more is known than their farthest points along directions?
//
//   const auto ball = [](const Vector3& d) { return farthest_point_of_my_shape(d); };
//   const GjkBounds b = gjk_bounds(ball, other, {.rounding = 1e-15});
//   if (b.told == GjkTold::disjoint) ...
//
// A black box proves what its points prove: two bodies are at least as far apart as the planes at both their farthest points
// along a direction, and at most as far as the hulls of the points that were told.
// Laws: (1) if each point told is within `rounding` of the body, and no point of the body is farther along the direction by
// more than that, the distance is within [lower, upper]; the bounds are exact, rounded outward.  (2) `disjoint` and `meeting`
// are told where that is certain, else `undecided`: of mappings with a rounding, meeting is certain where hulls of their points
// still meet after one was moved by four times the rounding either way along each axis of space.  (3) A mapping that contradicts
// itself beyond its rounding (a point told now is less far along the direction than one that was told before, or farther along
// an earlier direction than the point that was told then) throws InvalidShape with both points and the direction; NaN and
// infinity throw NonFinite with the direction.  A negative `rounding` or `within` throws InvalidShape.
// The search is exact between calls, and ends where a call brings the hulls no nearer, or the bounds are within `within`.
// Source: Gilbert, Johnson and Keerthi 1988; Gilbert and Foo 1990; RTCD 9.5.3.
// Cost: some tens of microseconds a step beside the calls.  Bounded by n steps and n^2 signs for n points that the mappings
// can tell, for each step brings their hulls nearer, on integers as long as the exponents' span.
#pragma once

#include <concepts>
#include <cstdint>

#include "plumb/arith/point.hpp"

namespace plumb {

template <class F>
concept SupportMapping3 = requires(const F& f, const Vector3& direction) {
  { f(direction) } -> std::convertible_to<Point3>;
};

enum class GjkTold : unsigned char { disjoint, meeting, undecided };

struct GjkBounds {
  double lower = 0, upper = 0;
  GjkTold told = GjkTold::undecided;
  Vector3 direction{0, 0, 0};  // the one along which the lower bound is
  std::uint32_t steps = 0;     // calls of each mapping
};

struct GjkBoundsOptions {
  double rounding = 0;  // of what the mappings tell, as a distance
  double within = 0;    // how near the bounds have to come: by default as near as they do
};

namespace query {

struct SupportCall {
  const void* mapping;
  Point3 (*call)(const void* mapping, const Vector3& direction);

  Point3 operator()(const Vector3& direction) const { return call(mapping, direction); }
};
template <class F>
SupportCall support_call(const F& f) {
  return {&f, [](const void* mapping, const Vector3& d) -> Point3 { return (*static_cast<const F*>(mapping))(d); }};
}

GjkBounds bounds_of(const SupportCall& a, const SupportCall& b, const GjkBoundsOptions& options);

}  // namespace query

template <SupportMapping3 F, SupportMapping3 G>
GjkBounds gjk_bounds(const F& a, const G& b, const GjkBoundsOptions& options = {}) {
  return query::bounds_of(query::support_call(a), query::support_call(b), options);
}

}  // namespace plumb

// Penetration depth between bounds: how deep are two convex bodies in one another of which only farthest points are
// known, as of a cylinder, a cone, an ellipsoid, or a shape of the user's?
//
//   const PenetrationBounds p = penetration_bounds(f, g, {.rounding = 1e-15, .within = 1e-9});
//   const PenetrationBounds q = penetration(cylinder, box);     // figures tell their rounding themselves
//
// The hulls of the points told so far lie within the bodies, and so they are no deeper in one another than these; the
// planes at the farthest points along any direction are a way out.  The direction is that in which the hulls leave.
// Laws: (1) if each point told is within `rounding` of a point of the body than which none is farther along the
// direction, the depth is within [lower, upper]; both are exact, rounded outward.  (2) Moved by `upper` along
// `direction` the first body is parted from the second for certain.  (3) `disjoint`, of depth zero, and `meeting` are
// told where that is certain, else `undecided`.  (4) The search ends where the bounds are within `within` or eight times
// `rounding`, of which four are never gained, where a direction tells no new point, and after `most_steps`, for of two
// balls around one center no direction is nearer than any other; whatever it ends by, the bounds hold.
// Errors: those of gjk_bounds (query/gjk/support_mapping.hpp); most_steps of zero throws InvalidShape.
// Source: van den Bergen 2001 (EPA); RTCD 9.3.8, 9.5.3.
// Cost: a call of penetration a step, of as many points as steps, whatever the exponents are: some milliseconds for
// cones.  Bounded by most_steps calls of penetration, of n points at step n.
#pragma once

#include "plumb/query/gjk/figure_support.hpp"

namespace plumb {

struct PenetrationBounds {
  double lower = 0, upper = 0;  // of the depth
  GjkTold told = GjkTold::undecided;
  Vector3 direction{0, 0, 0};  // of length 1, but for rounding; none where they are disjoint
  std::uint32_t steps = 0;     // calls of each mapping
};

struct PenetrationBoundsOptions {
  double rounding = 0;  // of what the mappings tell, as a distance
  double within = 0;    // how near the bounds have to come: by default as near as they do
  std::uint32_t most_steps = 128;
};

namespace query {

PenetrationBounds penetration_bounds_of(const SupportCall& a, const SupportCall& b,
                                        const PenetrationBoundsOptions& options);

}  // namespace query

template <SupportMapping3 F, SupportMapping3 G>
PenetrationBounds penetration_bounds(const F& a, const G& b, const PenetrationBoundsOptions& options = {}) {
  return query::penetration_bounds_of(query::support_call(a), query::support_call(b), options);
}

template <SupportedFigure3 A, SupportedFigure3 B>
PenetrationBounds penetration_bounds(const A& a, const B& b, const PenetrationBoundsOptions& options = {}) {
  const FigureSupport3<A> of_a(a);
  const FigureSupport3<B> of_b(b);
  return penetration_bounds(of_a, of_b, query::with_rounding(options, of_a, of_b));
}

/// Where one is round by a quadric, of which query/penetration/penetration.hpp has no exact depth.
template <SupportedFigure3 A, SupportedFigure3 B>
requires(QuadricBody3<A> || QuadricBody3<B>)  //
    PenetrationBounds penetration(const A& a, const B& b, const PenetrationBoundsOptions& options = {}) {
  return penetration_bounds(a, b, options);
}

}  // namespace plumb

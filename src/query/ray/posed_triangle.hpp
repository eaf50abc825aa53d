// Ray cast: where does a ray first hit a triangle under a pose, whose corners are not rounded?
//
// Laws: those of first_hit, first_hit_parameter and hits of a triangle, of the exact image.
// Source: RTCD 5.3.6.
// Cost: twice that of a triangle as given.
#pragma once

#include "plumb/query/ray/ray.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// Of finite numbers.
std::optional<Hit> first_hit(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule);
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule);
bool hits(const AnyRay& ray, const PosedTriangle3& triangle, HitRule rule);
/// Of two that are hit by this rule: their parameters.
Sign compare_hits(const AnyRay& ray, const PosedTriangle3& first, const PosedTriangle3& second, HitRule rule);

}  // namespace plumb::query

// Where in a triangle under a pose does a ray hit it?
//
// Laws: those of plumb/query/ray/hit_barycentric.hpp, of the exact image.
// Source: RTCD 5.3.6.
#pragma once

#include "plumb/query/ray/hit_barycentric.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// The numbers must be finite.
std::optional<HitBarycentric> hit_barycentric(const AnyRay& ray, const PosedTriangle3& triangle);
std::optional<ExactHitBarycentric> exact_hit_barycentric(const AnyRay& ray, const PosedTriangle3& triangle);

}  // namespace plumb::query

// Which of two triangles that a ray hits does it hit first?
//
// Law: the sign of the exact parameter of the first minus that of the second.
// Source: RTCD 5.3.6.
// Cost: two or three signs of degree 6; microseconds where the ray runs in the plane of one.
#pragma once

#include "plumb/query/ray/ray.hpp"

namespace plumb::query {

/// Of two that are hit by this rule.
Sign compare_hits(const AnyRay& ray, const Triangle3& first, const Triangle3& second, HitRule rule);

}  // namespace plumb::query

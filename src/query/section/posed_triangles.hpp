// What have two triangles under poses, whose corners are not rounded, in common?
//
// Law: intersection(Triangle3, Triangle3) of the exact images.
// Source: RTCD 5.2.10.
// Cost: some 100 us: all by integers.
#pragma once

#include "plumb/query/section/intersection_result.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// Of finite numbers.
Intersection3 intersection(const PosedTriangle3& a, const PosedTriangle3& b);

}  // namespace plumb::query

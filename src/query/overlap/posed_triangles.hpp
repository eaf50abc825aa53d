// Do two triangles under poses meet, and do they overlap or only touch?  Their corners are not rounded.
//
// Laws: those of relate(Triangle3, Triangle3), of the exact images; the poses may differ, be singular, and lead beyond
// the largest double.
// Source: Guigue and Devillers 2003; RTCD 5.2.10.
// Cost: some 300 ns where doubles decide, microseconds where they do not.
#pragma once

#include "plumb/figure/basic/relation.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// Of finite numbers.
Relation relate(const PosedTriangle3& a, const PosedTriangle3& b);

}  // namespace plumb::query

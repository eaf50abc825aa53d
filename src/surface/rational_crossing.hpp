// Does the ray along x from a point that is no double cross a triangle?  In rational numbers, as query/ray/crossings.hpp
// has it in doubles.
//
// Laws: those of plumb/query/ray/parity.hpp.
// Source: RTCD 5.4.3.
// Cost: some 10 us for a triangle whose box the ray's line passes.
#pragma once

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::surface {

struct RationalPoint3 {
  Rational x, y, z;
};

/// (2 a + b + c) / 4: in the triangle, and not on its edges where it has area.
RationalPoint3 middle_of(const Triangle3& t);

enum class Crossing : unsigned char { none, crossed, on_triangle };

Crossing crossing_of(const Triangle3& triangle, const RationalPoint3& p);

}  // namespace plumb::surface

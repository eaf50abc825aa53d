// Does the ray along x from the middle of a triangle cross another?  That middle is no double, as a rule; all else is as
// query/ray/crossings.hpp has it.
//
// Laws: those of plumb/query/ray/parity.hpp, of the point (2 a + b + c) / 4: in the triangle, and not on its edges where
// it has area.
// Source: RTCD 5.4.3.
// Cost: below 1 us for a triangle whose box the ray's line passes; some microseconds where the middle is in its plane.
#pragma once

#include "plumb/figure/basic/simplex.hpp"

namespace plumb::surface {

enum class MiddleCrossing : unsigned char { none, crossed, on_triangle };

MiddleCrossing crossing_from_middle(const Triangle3& of, const Triangle3& triangle);

}  // namespace plumb::surface

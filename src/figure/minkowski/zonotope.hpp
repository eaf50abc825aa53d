// Is the origin in a zonotope, and is it inside?  A center and generators of any kind and number, exactly.
//
// A zonotope is all center + sum of t_i generators_i with |t_i| <= 1.  The difference of two boxes is one, and they
// meet where it contains the origin, their relative interiors where its relative interior does.
// Laws: `overlapping` for the relative interior, `touching` for the rest, whatever the dimension, down to a point.
// Source: its facets' normals are cross products of generators; RTCD 4.4.1.
// Cost: GMP; some 10 us for six generators.
#pragma once

#include <array>
#include <span>

#include "plumb/arith/big.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

using BigVector = std::array<BigDyadic, 3>;

Relation locate_origin(const BigVector& center, std::span<const BigVector> generators);

}  // namespace plumb

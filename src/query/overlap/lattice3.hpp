// How do a segment and a triangle in space lie, on the lattice of their corners?  And two triangles of one plane, where
// that lattice has few bits?
//
// Of the latter words tell whether all corners are in one plane, though volumes take more bits than a word has: they are
// known to be small, and what wraps around on the way does no harm.  Then the areas that tell the rest are exact in
// plain doubles.
// Laws: exact; nothing for coordinates of more than 125 bits, what is not finite, and figures without length or area
// that do not lie on one line.  Of triangles nothing where corners take more than 24 bits, where they are not in one
// plane, where one alone is a point, and beyond 2^400 or below 2^-400.
// Source: RTCD 5.2.10, 5.3.6, 11.5; arith/lattice_integers.hpp.
// Cost: some 30 to 60 ns, twice that beyond 61 bits; of triangles 30, or 3 where corners take more bits.
#pragma once

#include <optional>

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::query {

std::optional<Relation> by_lattice(const Segment3& s, const Triangle3& t);

/// The volumes of b's corners over a's plane, seen from a.a, are 3 `error` at the most.
std::optional<Relation> by_short_plane(const Triangle3& a, const Triangle3& b, double error);

}  // namespace plumb::query

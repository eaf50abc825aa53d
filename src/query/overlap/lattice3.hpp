// How do a segment and a triangle in space lie, on the lattice of their corners?
//
// Laws: exact; nothing for coordinates of more than 125 bits, what is not finite, and figures without length or area
// that do not lie on one line.
// Source: RTCD 5.3.6.
// Cost: some 30 to 60 ns, twice that beyond 61 bits.
#pragma once

#include <optional>

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::query {

std::optional<Relation> by_lattice(const Segment3& s, const Triangle3& t);

}  // namespace plumb::query

// Segment intersection: how do segments and triangles of the plane lie to one another, where doubles tell, or the
// integers of a common lattice?
//
// Laws: an answer is that of real arithmetic, for any doubles at all; what these cannot tell is nothing: coordinates of
// more than 61 bits in an axis, what is not finite, and figures without area or length that do not lie on one line.
// Source: flat_areas.hpp, lattice_points.hpp.
// Cost: 5 to 15 ns by doubles, some 50 ns by integers.
#pragma once

#include <optional>

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::query {

std::optional<Relation> quickly(const Segment2& s, const Segment2& t);
std::optional<Relation> quickly(const Segment2& s, const Triangle2& t);
std::optional<Relation> quickly(const Triangle2& a, const Triangle2& b);

/// By doubles alone.
std::optional<Relation> by_doubles(const Segment2& s, const Segment2& t);
std::optional<Relation> by_doubles(const Segment2& s, const Triangle2& t);
std::optional<Relation> by_doubles(const Triangle2& a, const Triangle2& b);

}  // namespace plumb::query

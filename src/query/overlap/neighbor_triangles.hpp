// Two triangles in space that share corners, as neighbors in a mesh do: how do they lie to one another?
//
// What is in common lies, but for what is shared, on the other corners' sides of both planes:
// - one corner: along a ray from it in the line of the planes, if both triangles cross the other's plane there;
// - an edge: it is all, unless the triangles are in one plane; then the third corners are on one side of it or not;
// - three: all.
// The shared corners themselves are of no inside, where there is an area.
// Laws: an answer is that of real arithmetic; nothing where it takes another exact sign, or no area is certain.
// Source: RTCD 5.2.10; the signs of Guigue and Devillers 2003, of which a shared corner leaves four.
// Cost: comparisons of corners for heights in doubt; a plane more, where one corner is shared; an exact volume, where an
// edge is and the planes are nearly one.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::query {

/// `axis` is a guess of one along which a is seen well; `over_a` are the heights of b's corners over a's plane, and
/// `error` the bound of volumes that are seen from a.a; times from_any_corner it bounds those that are seen from others.
std::optional<Relation> relate_neighbors(const Triangle3& a, const Triangle3& b, std::size_t axis,
                                         const std::array<double, 3>& over_a, double error);

}  // namespace plumb::query

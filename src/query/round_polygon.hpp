// How does a ball or capsule lie to what chains in one plane wind around an odd number of times?
//
// Laws: chains that lie on one line are the union of their edges.  Of edges that cover one another an even number of
// times nothing is beside but what is on both sides: they are boundary, and near to the inside only as other points
// are. Source: RTCD 5.2.8, 5.4.1.  Cost: the edges in turn, and one more pass; where edges lie on one another
// quadratic.
#pragma once

#include <span>
#include <vector>

#include "plumb/figure/linear.hpp"
#include "plumb/figure/relation.hpp"
#include "plumb/figure/round.hpp"

namespace plumb::query {

using Chain3 = std::span<const Point3>;

/// Of a radius above zero and finite numbers.  Throws InvalidShape, as relate, where the chains are in no plane.
Relation relate_region(std::span<const Chain3> chains, const Sphere3& ball);
Relation relate_region(std::span<const Chain3> chains, const Capsule3& capsule);

/// The parts of the edges that an odd number of edges cover, as segments between corners.
std::vector<Segment3> odd_edges(std::span<const Segment3> edges);

}  // namespace plumb::query

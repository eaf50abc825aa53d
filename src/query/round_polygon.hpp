// A ball or capsule against the region of some chains in one plane.
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

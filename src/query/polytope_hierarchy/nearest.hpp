// Distance of a hierarchy: where does its polytope come nearest to a point, a segment or another small body?
//
// The nearest point of the coarsest polytope, then of each finer one: what of that is beyond the plane through the one
// before, at right angles to the way, is within the hull of one removed vertex and its neighbors, eight at most, and
// nothing else of it can be nearer.
// Laws: exact; nothing where a number takes more than a thousand bits.
// Source: Dobkin and Kirkpatrick 1990; RTCD 9.3.1.
// Cost: a step of query/polytope_hierarchy/descent.hpp a polytope, and a search among nine points where it finds one.
#pragma once

#include "query/polytope_hierarchy/descent.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query::hierarchy {

struct NearestOfHierarchy {
  DifferenceCorners corners;  // of the body, and of the polytope by its ranks
  bool meets;
  // The finest polytope that changed the answer; of another than the coarsest the vertex about which it did.
  std::size_t level;
  std::optional<std::uint32_t> about;
};

/// Where the body meets a polytope of the hierarchy, finer ones are not asked.
std::optional<NearestOfHierarchy> nearest(const PolytopeHierarchy& h, const CoreCorners& body);

}  // namespace plumb::query::hierarchy

// Descent of a hierarchy: what of the next finer polytope lies beyond a plane that bounds the coarser one?
//
// A vertex of the finer polytope that lies beyond the plane was removed, and so has all its neighbors on this side of
// it: it is higher than they, and therefore the highest of all.  Any other vertex has a higher neighbor on the way up
// to it; of one that lies in the plane that is it.  So there is one such vertex at most, and it is a neighbor of each
// in the plane.
// Laws: nothing where no vertex lies beyond the plane.
// Source: Dobkin and Kirkpatrick 1983; RTCD 9.3.1.
// Cost: a sign for each removed neighbor, of a fan the logarithm of their number.
#pragma once

#include <algorithm>

#include "query/polytope_hierarchy/fan.hpp"

namespace plumb::query::hierarchy {

/// `at`: a vertex in the plane, at right angles to the direction, which says whether one point is beyond() another.
template <class Direction>
std::optional<std::uint32_t> beyond_plane(const PolytopeHierarchy& h, const HierarchyLevel& finer, std::uint32_t at,
                                          const Direction& direction) {
  const auto removed = finer.removed_at(at);
  const auto is_beyond = [&](std::uint32_t v) { return direction.beyond(h.points[v], h.points[at]) == Sign::positive; };
  if (removed.size() >= fewest_of_fan) {
    const auto fan = std::ranges::lower_bound(finer.fans, at, {}, &HierarchyLevel::Fan::vertex);
    if (fan != finer.fans.end() && fan->vertex == at) {
      const std::uint32_t v = farthest_of_fan(h.points, *fan, removed, direction);
      return is_beyond(v) ? std::optional(v) : std::nullopt;
    }
  }
  const auto found = std::ranges::find_if(removed, is_beyond);
  return found != removed.end() ? std::optional(*found) : std::nullopt;
}

}  // namespace plumb::query::hierarchy

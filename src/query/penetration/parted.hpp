// Along which direction is the least translation that parts two bodies?
//
// Laws: those of plumb/query/penetration/penetration.hpp; nothing of bodies that are disjoint.
// Source: query/penetration/search.hpp; of cores that are apart, query/separation/proved_corners.hpp.
// Cost: that of both.
#pragma once

#include "query/penetration/way.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query::parting {

struct Parting {
  Way way;
  bool cores_are_apart, is_unique;
};

std::optional<Parting> parted(const Body& a, const Body& b);

/// Do the cores meet, and which corners of their difference are nearest to the origin?
struct CoreDistance {
  DifferenceCorners nearest;
  bool meet = false;
};
CoreDistance core_distance(const Difference& d);

}  // namespace plumb::query::parting

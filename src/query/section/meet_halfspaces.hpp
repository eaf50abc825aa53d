// What do halfspaces have in common?  In rationals, where nothing else names the corners.
//
// Laws: those of query/section/solid.hpp.
// Source: Motzkin and others 1953, by query/convex/flat_set.hpp.
// Cost: GMP; some milliseconds for thirty halfspaces.
#pragma once

#include "plumb/query/section/solid.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query::meeting {

SolidIntersection3 meet_halfspaces(const std::vector<ExactHalfspace>& halfspaces);

RationalPoint3 rational_of(const Exact3& p);

}  // namespace plumb::query::meeting

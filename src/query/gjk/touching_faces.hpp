// Separating plane of two sets that touch: which of their points can lie in one?
//
// Laws: exact.  Of two sets of points whose hulls have x in common a plane through x has all of one on one side and all of the
// other on the other: the one found is in as few of the points as any is.  None where the relative insides of the hulls meet.
// Source: Chvatal, Linear Programming, 1983, chapter 10; Rockafellar, Convex Analysis, 1970, section 11.
// Cost: a rational linear program of as many rows as points, three times.
#pragma once

#include <optional>

#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// A normal of the plane, along which a is not before x and b not beyond it.
std::optional<Exact3> touching_plane(const std::vector<Exact3>& a, const std::vector<Exact3>& b, const Exact3& x);

}  // namespace plumb::query

// Distance: how far apart are two flat convex sets, exactly?  And what that makes of a round shape with such a core.
//
// Laws: (1) exact, whatever is flat, repeated, unbounded or a point; the search ends, for each set of corners that it
// stops at is independent and nearer than the one before.  (2) A core with a radius above zero meets a set where the
// distance is at most that; interiors meet where it is less.  With radius zero it is its core.
// Source: Wolfe 1976, "Finding the nearest point in a polytope".
// Cost: GMP; some 10 us for a few points, linear in them, and what flat_set takes.
#pragma once

#include <optional>

#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// The square; nothing where a set is empty.
std::optional<mpq_class> squared_distance(const FlatSet& a, const FlatSet& b);

/// Of all that is near to the core by one radius or by two.
Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other);
Relation relate_swept(const FlatSet& core, double radius, const FlatSet& other_core, double other_radius);

}  // namespace plumb::query

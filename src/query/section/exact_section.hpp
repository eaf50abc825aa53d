// Intersection: what do two exact sets have in common?  With exact corners.
//
// Laws: those of query/section/intersection_result.hpp.
// Source: Motzkin and others 1953, by query/convex/flat_set.hpp.
// Cost: rationals; grows fast with the points of a set that nothing else is known of.
#pragma once

#include "plumb/query/section/intersection_result.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

Intersection3 common_part3(const FlatSet& a, const FlatSet& b);

/// A point as given where its numbers are doubles.
ExactPoint3 exact_point3(const Exact3& p);

}  // namespace plumb::query

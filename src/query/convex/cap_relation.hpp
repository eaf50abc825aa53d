// Spherical caps in rationals: disjoint, touching or overlapping, against flat convex sets and balls as a cap sees them?
//
// Laws: those of query/overlap/overlap.hpp.
// Source: RTCD 5.2.
// Cost: GMP; some 100 us.
#pragma once

#include <optional>

#include "plumb/figure/basic/round.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// Of a cap that has no interior: its only point, or the empty set.
std::optional<FlatSet> thin_cap(const SphericalCap3& cap);

/// A set that is not empty.
Relation relate_exact_cap(const FlatSet& set, const SphericalCap3& cap);
/// A ball by the square of its radius, which is above zero.
Relation relate_exact_cap(const Exact3& center, const mpq_class& squared_radius, const SphericalCap3& cap);

}  // namespace plumb::query

// Time of impact: when do they meet first, exactly?  By polynomials of time, for what intervals leave in doubt, and for
// times.
//
// Laws: those of query/time_of_impact/continuous_contact.hpp.
// Without separation, contacts are at roots of the coplanarity cubic, where the signs of the points' projections tell
// whether they meet.  Otherwise, and where the cubic is zero or the projections are degenerate: at time 0 the distance
// is small enough, or at the first contact a pair of features is at that distance and was not just before, so the
// first contact is the first of the roots of the pairs' distances at which the pair counts.
// Source: RTCD 5.5; Sturm-like signs at roots (arith/root.hpp).
// Cost: some 20 us, ten times as much with separation.
#pragma once

#include <optional>
#include <span>

#include "arith/isolated_root.hpp"
#include "query/time_of_impact/feature_pairs.hpp"

namespace plumb::query::moving {

struct TimedContact {
  arith::IsolatedRoot time;
  Feature a, b;
};

/// Of finite coordinates, and a separation that is not negative.
std::optional<TimedContact> exact_first_contact(MovingKind kind, std::span<const Point3, 4> at_0,
                                                std::span<const Point3, 4> at_1, double separation);

/// Of points and a separation on a lattice, as integers.
std::optional<TimedContact> exact_first_contact(MovingKind kind, const FourMoving& points, const mpz_class& separation);

}  // namespace plumb::query::moving

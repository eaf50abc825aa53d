// Closest points, separating plane: do plain doubles prove how two capsules or lozenges lie to one another?  Two near
// points of the cores, and what they show.
//
// Laws: negative: the cores are nearer than the radii reach; positive: a plane lies between; nothing where rounding
// leaves a doubt, and for what is not finite or has a negative radius.
// Source: RTCD 4.5.1; the near points of lozenges by coordinate descent.
// Cost: some 20 ns, of lozenges some 300 operations.
#pragma once

#include <optional>

#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::swept {

std::optional<Sign> quick_gap(const Capsule3& a, const Capsule3& b);
std::optional<Sign> quick_gap(const Lozenge3& a, const Lozenge3& b);

}  // namespace plumb::figure::swept

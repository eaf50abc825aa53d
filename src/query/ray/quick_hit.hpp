// Which doubles are the parameter, the point and the normal of a hit of a triangle by its plane, where pairs of doubles
// without radii tell?
//
// Laws: what is told is the exact number rounded once, to nearest; never -0.
// Source: Ziv 1991; arith/twofold.hpp.
// Cost: some 50 ns for all seven.
#pragma once

#include <array>
#include <optional>

#include "plumb/query/ray/ray.hpp"

namespace plumb::query {

/// t, the point, the normal (b - a) x (c - a).
using QuickHit = std::array<std::optional<double>, 7>;

QuickHit quick_hit(const AnyRay& ray, const Triangle3& triangle);

}  // namespace plumb::query

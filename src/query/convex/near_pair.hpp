// GJK, separating plane: are two convex hulls of few points nearer than this, or farther?  A guess in doubles, and its
// proof.
//
// Laws: an answer is the sign of (distance of the hulls) - (sum of the two radii), proved: by a pair of points, one of
// each hull, that are nearer, or by a direction along which all pairs of vertices are farther apart.  Where doubles
// prove neither there is none: where the shapes touch or all but do, and where the sum of the radii is zero.
// Source: RTCD 9.5 (the guess).
// Cost: some 50 to 200 ns.
#pragma once

#include <optional>
#include <span>

#include "arith/running_error.hpp"
#include "arith/vec.hpp"

namespace plumb::query {

/// A vertex, of which a coordinate may be rounded.
using Vertex = arith::Vec<Running>;
inline arith::Plain plain(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }

/// For radii that are not negative; of anything but real numbers there is no answer.
std::optional<Sign> quick_gap(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b);

}  // namespace plumb::query

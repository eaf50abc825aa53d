// GJK, separating plane: are two convex hulls of few points nearer than this, or farther?  A guess in doubles, and its
// proof, by doubles or by integers.
//
// Laws: an answer is the sign of (distance of the hulls) - (sum of the two radii), proved: by a pair of points, one of
// each hull, that are nearer, or by a direction along which all pairs of vertices are farther apart; by both at once
// where integers tell, and then shapes that touch are told as well.  Where doubles prove neither there is none, nor
// where a thousand bits do not hold the integers, the guess was wrong, or the sum of the radii is zero.
// Source: RTCD 9.5 (the guess).
// Cost: some 50 to 200 ns; by integers half a microsecond, without allocation.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "arith/running_error.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/short_dyadic.hpp"

namespace plumb::query {

/// A vertex, of which a coordinate may be rounded.
using Vertex = arith::Vec<Running>;
inline arith::Plain plain(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }

/// Between which vertices of both the least way is likely to be.
struct LikelyEnds {
  std::array<std::array<std::size_t, 2>, 4> ends{};
  std::size_t size = 0;
};

/// For radii that are not negative; of anything but real numbers there is no answer.  Where there is none `likely` is
/// what integers may be asked about.
std::optional<Sign> quick_gap(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b,
                              LikelyEnds* likely = nullptr);

using ExactVertex = arith::Vec<ShortDyadic>;
std::optional<Sign> integer_gap(std::span<const ExactVertex> a, std::span<const ExactVertex> b, double radius_a,
                                double radius_b, const LikelyEnds& likely);

}  // namespace plumb::query

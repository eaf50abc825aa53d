// Do two convex sets meet, and how far are things apart?  In GMP's rationals, by the plainest ways there are.
//
// Laws: exact for all finite doubles; degenerate shapes are the sets that they are.  Not a line is shared with the
// library's own answers, but for the rounding of the last number.
// Source: Chvatal, Linear Programming, 1983 (simplex method, Bland's rule).
// Cost: tens of microseconds to milliseconds.
#pragma once

#include <gmpxx.h>

#include <span>
#include <vector>

#include "tool/trial/vec.hpp"

namespace plumb::tool::trial {

using RationalVec = Vec<mpq_class>;

/// Point or vector number i of a question.
RationalVec rational_vec(std::span<const double> question, std::size_t i);

/// The points p + s with p in the hull of `points` and s a sum of nonnegative multiples of `directions`.
struct Generated {
  std::vector<RationalVec> points, directions;
};
bool meet(const Generated& a, const Generated& b);

mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b);  // to a segment
mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b, const RationalVec& c);
mpq_class square_distance_of_segments(const RationalVec& a, const RationalVec& b, const RationalVec& c,
                                      const RationalVec& d);

/// The double nearest to the root.
double nearest_root(const mpq_class& square);

}  // namespace plumb::tool::trial

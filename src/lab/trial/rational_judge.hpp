// Do two convex sets meet, how far are things apart, and is a point inside?  In GMP's rationals, by the plainest ways there are.
//
// Laws: exact for all finite doubles; degenerate shapes are the sets that they are.  Not a line is shared with the
// library's own answers, but for the rounding of the last number.
// Source: Chvatal, Linear Programming, 1983 (simplex method, Bland's rule).
// Cost: tens of microseconds to milliseconds.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

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

/// Of the hulls of these points: the least of all distances between points, edges and triangles of either, 0 where they meet.
mpq_class square_between_hulls(std::span<const RationalVec> a, std::span<const RationalVec> b);

/// A point, and the corners of a polygon in turn: on an edge, or an odd number of edges crosses the ray to the right.
bool in_polygon(std::span<const double> point_and_corners);

/// In a closed solid: on a face, or an odd number of faces is hit by a ray that meets no edge.
bool in_solid(const RationalVec& p, std::span<const std::array<RationalVec, 3>> faces);

/// Which of the points are corners of their hull, as bits; of equal ones the first.
std::uint32_t corners_of_hull(std::span<const RationalVec> points);

/// The double nearest to the root.
double nearest_root(const mpq_class& square);

}  // namespace plumb::lab::trial

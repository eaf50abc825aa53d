// Closest points: what are the numbers of a nearest pair, whose corners are proved?  Both points and the distance, each
// rounded once, and the exact square of it.
//
// Laws: the corners are independent and their nearest point needs all of them (query/separation/proved_corners.hpp).
// Pairs of doubles answer where they leave one double, GMP's integers otherwise.
// Source: query/separation/nearest_corners.hpp; Ziv 1991.
// Cost: some 200 ns by pairs of doubles, some microseconds by integers.
#pragma once

#include "plumb/arith/big.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query {

struct ClosestCorners {
  Point3 on_a{}, on_b{};
  double distance = 0;
};

ClosestCorners numbers_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners);
double distance_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners);
mpq_class square_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners);

}  // namespace plumb::query

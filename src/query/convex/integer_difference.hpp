// Minkowski difference: two flat sets as integers, for a search of the difference's point nearest to the origin.
//
// Laws: exact: a point of either set is (integers + origin * scale) / scale; directions are theirs times any factor above
// zero, those of the second set turned round behind those of the first, a line two of them.
// Source: arith/difference_search.hpp.
// Cost: an integer division a number; the guess some microseconds.
#pragma once

#include "arith/difference_search.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

struct IntegerDifference {
  arith::Difference<mpz_class> difference;
  std::size_t directions_of_a = 0;
  Exact3 origin;
  mpz_class scale;
};

/// Of sets that are not empty.
IntegerDifference in_integers(const FlatSet& a, const FlatSet& b);

/// Corners that are likely those of the nearest point: found in doubles.
std::vector<arith::DifferenceCorner> guessed_corners(const arith::Difference<mpz_class>& sets);

}  // namespace plumb::query

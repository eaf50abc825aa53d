// Closest points: which points of two flat convex sets are nearest to one another, exactly?
//
// Laws: (1) nearest pairs all differ by one vector, and form a convex set; the pair is the one that comes first in
// lexicographic order of coordinates, both of whose points come first.  (2) Where none comes first, of sets that go on,
// it is one of the nearest pairs, and `is_first` says so.
// Source: Wolfe 1976 (any pair); the first one is that of a linear program with three objectives in turn: Chvatal,
// Linear Programming, 1983, chapter 5.
// Cost: GMP; some 10 us, with several nearest pairs some 30 us, and linear in the generators.
#pragma once

#include <optional>

#include "plumb/query/closest/which_pair.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

using plumb::WhichPair;

struct NearestPair {
  Exact3 on_a, on_b;
  mpq_class square;  // of what is between them
  bool is_first = true;
};

/// Nothing where a set is empty.
std::optional<NearestPair> nearest_pair(const FlatSet& a, const FlatSet& b, WhichPair which);

}  // namespace plumb::query

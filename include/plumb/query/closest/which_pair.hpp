// Closest points: which of several closest pairs is told?
//
//   gjk(a, b, {.pair = WhichPair::first})      closest_points(a, b, WhichPair::first)
//
// Law: `first` is the one that comes first in lexicographic order of coordinates, as query/separation/separation.hpp says;
// `any` is one of them, and the same for the same input.
// Source: none.
// Cost: where there are several, the first takes a linear program in rationals, 0.1 to some milliseconds.  Bounded by
// n^2 signs for n corners of both, and n expected ones of the program, on integers as long as the exponents' span.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

enum class WhichPair : unsigned char { any, first };

}  // namespace plumb

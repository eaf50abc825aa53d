// Closest points: which of several closest pairs is told?
//
//   gjk(a, b, {.pair = WhichPair::first})
//
// Law: `first` is the one that comes first in lexicographic order of coordinates, as query/separation/separation.hpp says;
// `any` is one of them, and the same for the same input.
// Source: none.
// Cost: where there are several, the first takes a linear program in rationals, 0.1 to some milliseconds.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

enum class WhichPair : unsigned char { any, first };

}  // namespace plumb

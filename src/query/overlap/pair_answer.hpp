// A pair of the table (query/body/pairs.hpp) is answered by this function: one line a pair, in the order of the table.
#pragma once

#include "plumb/query/overlap/overlap.hpp"

// Inside plumb::query; the function is called with both figures, and the question by whose name errors begin.
#define PLUMB_PAIR_ANSWER(A, B, function)                                                                \
  Relation relate_pair(PairFunction<A, B>, const A& a, const B& b, [[maybe_unused]] Question question) { \
    return function(a, b, question);                                                                     \
  }

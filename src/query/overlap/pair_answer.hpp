// Pairs of the table (query/body/pairs.hpp) are answered by this function: each of a list with one figure.
#pragma once

#include "plumb/query/overlap/overlap.hpp"

// Inside plumb::query; the function is called with both figures, and the question by whose name errors begin.
#define PLUMB_PAIR_ANSWER(A, B, function)                                                                \
  Relation relate_pair(PairFunction<A, B>, const A& a, const B& b, [[maybe_unused]] Question question) { \
    return function(a, b, question);                                                                     \
  }

// A macro is not expanded within itself: the next one of a list comes with the next pass, of which there are 27.
#define PLUMB_PASSES(...) PLUMB_NINE_PASSES(PLUMB_NINE_PASSES(PLUMB_NINE_PASSES(__VA_ARGS__)))
#define PLUMB_NINE_PASSES(...) PLUMB_THREE_PASSES(PLUMB_THREE_PASSES(PLUMB_THREE_PASSES(__VA_ARGS__)))
#define PLUMB_THREE_PASSES(...) PLUMB_PASS(PLUMB_PASS(PLUMB_PASS(__VA_ARGS__)))
#define PLUMB_PASS(...) __VA_ARGS__
#define PLUMB_LATER ()

/// Each A with B.
#define PLUMB_PAIR_ANSWERS_TO(B, function, ...) PLUMB_PASSES(PLUMB_ANSWER_TO(B, function, __VA_ARGS__))
#define PLUMB_ANSWER_TO(B, function, A, ...) \
  PLUMB_PAIR_ANSWER(A, B, function) __VA_OPT__(PLUMB_NEXT_TO PLUMB_LATER(B, function, __VA_ARGS__))
#define PLUMB_NEXT_TO() PLUMB_ANSWER_TO

/// A with each B.
#define PLUMB_PAIR_ANSWERS_OF(A, function, ...) PLUMB_PASSES(PLUMB_ANSWER_OF(A, function, __VA_ARGS__))
#define PLUMB_ANSWER_OF(A, function, B, ...) \
  PLUMB_PAIR_ANSWER(A, B, function) __VA_OPT__(PLUMB_NEXT_OF PLUMB_LATER(A, function, __VA_ARGS__))
#define PLUMB_NEXT_OF() PLUMB_ANSWER_OF

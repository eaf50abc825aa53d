// Which function answers a pair of figures that has a way of its own?  One declaration for all of them.
//
// PairFunction<A, B>, which whoever asks makes, declares relate_pair for A and B; src/query/overlap/ defines one for
// each pair of the table (query/body/pairs.hpp) whose method is `signs` or `distance`, in the table's order.
// Law: a pair of the table that nobody defines does not link.
// Cost: a plain call; the tag is empty.
#pragma once

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/detail/question.hpp"

namespace plumb::query {

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-template-friend"  // that it is no template is what it is for
#endif
template <class A, class B>
struct PairFunction {
  friend Relation relate_pair(PairFunction, const A& a, const B& b, Question question);
};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

}  // namespace plumb::query

// Adaptive precision: what is the answer to a question over any number type, for certain?
//
//   const Location where = certainly<CertainSigns>([&]<class T>(CertainSigns& ask) { return locate<T>(p, ask); });
//
// Laws: the question is asked over Approximate, Ball and BigDyadic in turn, until all signs that it asked were certain;
// over the last they always are.  Only that answer counts, so it must depend on its input and its signs alone.
// Source: docs/proof.md.
// Cost: as a rule that of plain doubles.
#pragma once

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"

namespace plumb {

template <class Signs, class Question>
auto certainly(const Question& question) {
  {
    Signs ask;
    auto answer = question.template operator()<Approximate>(ask);
    if (ask.certain()) [[likely]]
      return answer;
  }
  {
    Signs ask;
    auto answer = question.template operator()<Ball>(ask);
    if (ask.certain()) return answer;
  }
  Signs ask;
  return question.template operator()<BigDyadic>(ask);
}

}  // namespace plumb

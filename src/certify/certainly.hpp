// Adaptive precision: what is the answer to a question over any number type, for certain?
//
//   const Location where = certainly<CertainSigns>([&]<class T>(CertainSigns& ask) { return locate<T>(p, ask); });
//
// For questions whose numbers are too many for types to know their errors, loops over halfspaces or edges: each number
// carries its own.  They are worlds of the one ladder (plumb/certify/certainly.hpp), and `ask` is who judges.
// Laws: the question is asked over Approximate, Ball and BigDyadic in turn, until all signs that it asked were certain;
// over the last they always are.  Only that answer counts, so it must depend on its input and its signs alone.
// Source: docs/proof.md.
// Cost: as a rule that of plain doubles.
#pragma once

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb {

template <class N, class Signs, WorldKind which>
struct WorldOfSigns {
  using Number = N;
  static constexpr WorldKind kind = which;
  Signs ask;

  [[nodiscard]] bool certain() const { return ask.certain(); }
};

template <class Signs, class Question>
auto certainly(const Question& question) {
  return certify::one_lane::ask_worlds<WorldOfSigns<Approximate, Signs, WorldKind::floats>,
                                       WorldOfSigns<Ball, Signs, WorldKind::pairs>,
                                       WorldOfSigns<BigDyadic, Signs, WorldKind::rationals>>(
      NoWorldRecorder{},
      [&]<class W>(W& world) { return question.template operator()<typename W::Number>(world.ask); });
}

}  // namespace plumb

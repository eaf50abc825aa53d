// Adaptive precision: what is the answer to a question whose numbers carry their own errors, for certain?
//
//   const Location where =
//       certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) { return locate<T>(p, ask); });
//
// For questions whose numbers are too many for types to know their errors: loops over halfspaces or edges.  They are
// worlds of the one ladder (plumb/certify/certainly.hpp), and a world is who judges.
// Laws: the question is asked over Approximate, Ball and BigDyadic in turn, until all signs that it asked were certain;
// over the last they always are.  Only that answer counts, so it must depend on its input and its signs alone.
// Source: docs/proof.md.
// Cost: as a rule that of plain doubles.
#pragma once

#include <concepts>
#include <utility>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb {

/// The world of these numbers, whose signs are told as `Signs` says.
template <class T, class Signs = CertainSigns>
struct Carrying : Signs {
  using Number = T;
  static constexpr WorldKind kind = std::same_as<decltype(std::declval<T>().sign()), Sign> ? WorldKind::integers
                                    : std::same_as<T, Ball>                                ? WorldKind::pairs
                                                                                           : WorldKind::floats;
};

template <class Signs = CertainSigns>
using CarriedErrors = Worlds<Carrying<Approximate, Signs>, Carrying<Ball, Signs>, Carrying<BigDyadic, Signs>>;

}  // namespace plumb

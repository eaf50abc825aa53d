// Adaptive precision: what is the answer to a question whose numbers carry their own errors, for certain?
//
//   const Location where =
//       certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) { return locate<T>(p, ask); });
//
// For questions whose numbers are too many for types to know their errors: loops over halfspaces or edges.  They are
// worlds of the one ladder (plumb/certify/certainly.hpp), and a world is who judges.
// Laws: the question is asked over Approximate, Ball and BigDyadic in turn, until all signs that it asked were certain;
// over the last they always are.  Only that answer counts, so it must depend on its input and its signs alone.
// Which sign has this number?  Walks whose every step takes a few signs ask one question for each, so that none is asked
// again because another was not certain:
//
//   const Sign s = proved_sign([&]<class T>() { return dot(way<T>(), at<T>(i) - at<T>(j)); });
//
// Running errors tell most, integers on the stack what is left, and GMP's what a thousand bits do not hold.  Of numbers
// that are NaN or infinite it means nothing.
// Source: docs/proof.md.
// Cost: as a rule that of plain doubles; of a proved sign three times that.
#pragma once

#include <concepts>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb {

template <class T>
concept TellsEverySign = requires(const T& x) {
  { x.sign() } -> std::same_as<Sign>;
};

/// The world of these numbers, whose signs are told as `Signs` says.  A statement that makes its numbers by its world
/// may be asked here as well.
template <class T, class Signs = CertainSigns>
struct Carrying : Signs {
  using Number = T;

  template <std::size_t scale = 0>
  [[nodiscard]] T difference(double b, double a) const {
    return coordinate_difference<T>(b, a);
  }
  template <std::size_t scale = 0>
  [[nodiscard]] T number(double a) const {
    return T(a);
  }
  [[nodiscard]] Sign sign(const T& x) { return (*this)(x); }
  [[nodiscard]] Sign compare(const T& x, const T& y) { return (*this)(x - y); }

  static constexpr WorldKind kind = TellsEverySign<T>       ? WorldKind::integers
                                    : std::same_as<T, Ball> ? WorldKind::pairs
                                                            : WorldKind::floats;
};

/// Integers on the stack: certain where none takes more than they hold.
template <class Signs>
struct Carrying<StackDyadic, Signs> : IntegerWorld {
  [[nodiscard]] Sign operator()(const StackDyadic& x) const { return x.sign(); }
};

template <class Signs = CertainSigns>
using CarriedErrors = Worlds<Carrying<Approximate, Signs>, Carrying<Ball, Signs>, Carrying<BigDyadic, Signs>>;

template <class... T>
using SignWorlds = Worlds<Carrying<T>...>;

/// For a statement whose products may be of very different size: what is as small as the error of the largest one may
/// be certain by its own.
template <class Statement>
using SpreadWorlds = Worlds<FloatWorld<Statement>, PairWorld<Statement>, Carrying<Running>, Carrying<BigDyadic>>;

template <class List, class Text>
Sign sign_in(const Text& text) {
  return certainly<List>([&]<class T>(Carrying<T>& ask) { return ask(text.template operator()<T>()); });
}
/// Without doubles.
template <class Text>
[[gnu::noinline]] Sign sign_by_integers(const Text& text) {
  return sign_in<SignWorlds<ShortDyadic, BigDyadic>>(text);
}

template <class Text>
Sign proved_sign(const Text& text) {
  return sign_in<SignWorlds<Running, ShortDyadic, BigDyadic>>(text);
}

}  // namespace plumb

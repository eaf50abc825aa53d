// What is known of a formula before it is run?  Degree, error constant, tape: all derived when compiled.
//
// A formula is a type with `name`, the shape of its input, and a call operator template over std::array<T, arity> that
// uses + - *, also by whole numbers as in -3 * x (predicates/orient.hpp is an example).  The shape is `points` and
// `dimension`, or, where arguments differ in kind, the number of coordinates of each in `arguments`.  It is stated
// once; running it over different numbers yields every stage: the formula itself, or its tape where it has constants.
// Laws: a formula that needs more error than the bound can hold does not compile; what else is refused, and in which
// words: certify/accepted.hpp.
// Source: docs/proof.md.
// Cost: compile time only.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "plumb/arith/bound.hpp"
#include "plumb/arith/degree.hpp"
#include "plumb/certify/accepted.hpp"
#include "plumb/certify/detail/formula_tape.hpp"

namespace plumb {

/// The degree of the homogeneous polynomial.
template <Formula F>
consteval int degree() {
  return term_degrees<F>().highest;
}

namespace certify::tape {

/// x + x; a number whose doubling is better known than its sums says so by `twice`.
template <class T>
constexpr auto doubled(const T& x) {
  if constexpr (requires { twice(x); }) {
    return twice(x);
  } else {
    return x + x;
  }
}

template <char operation, class L, class R>
constexpr auto result(const L& l, const R& r) {
  if constexpr (operation == '*') {
    return l * r;
  } else if constexpr (operation == '-') {
    return l - r;
  } else {
    return l + r;
  }
}

/// The result of instruction I over numbers of the type Input, beside those before it.
template <Formula F, class Input, std::size_t I>
struct Step {
  static constexpr Instruction instruction = of<F>.instructions[I];

  template <std::size_t K, class All>
  static constexpr const auto& number(const std::array<Input, arity<F>>& in, const All& all) {
    if constexpr (K < arity<F>) {
      return in[K];
    } else {
      return static_cast<const Step<F, Input, K - arity<F>>&>(all).value;
    }
  }
  template <std::size_t K>
  static constexpr auto type_of() {
    if constexpr (K < arity<F>) {
      return std::type_identity<Input>{};
    } else {
      return std::type_identity<typename Step<F, Input, K - arity<F>>::Value>{};
    }
  }
  using Left = typename decltype(type_of<instruction.left>())::type;
  using Right = typename decltype(type_of<instruction.right>())::type;

  static constexpr auto applied(const Left& l, const Right& r) {
    if constexpr (instruction.doubles()) {
      return doubled(l);
    } else {
      return result<instruction.operation>(l, r);
    }
  }
  using Value = decltype(applied(std::declval<const Left&>(), std::declval<const Right&>()));

  Value value;

  template <class All>
  constexpr Step(const std::array<Input, arity<F>>& in, const All& all)
      : value(applied(number<instruction.left>(in, all), number<instruction.right>(in, all))) {}
};

template <Formula F, class Input, class I>
struct Replay;
template <Formula F, class Input, std::size_t... I>
struct Replay<F, Input, std::index_sequence<I...>> : Step<F, Input, I>... {
  constexpr explicit Replay(const std::array<Input, arity<F>>& in) : Step<F, Input, I>(in, *this)... {}
};

/// The formula's value over these numbers, by its tape: what multiplies by constants runs over numbers that have none.
template <Formula F, class Input>
constexpr auto replay(const std::array<Input, arity<F>>& in) {
  using Last = Step<F, Input, of<F>.size - 1>;
  const Replay<F, Input, std::make_index_sequence<of<F>.size>> all(in);
  return static_cast<const Last&>(all).value;
}

/// The formula as data.
template <Formula F>
constexpr Program program() {
  return {arity<F>, of<F>.instructions};
}

}  // namespace certify::tape

/// F's value over these numbers.
template <Formula F, class T>
constexpr auto value_of(const std::array<T, arity<F>>& p) {
  if constexpr (certify::tape::of<F>.as_written) {
    return F{}(p);
  } else {
    return certify::tape::replay<F>(p);
  }
}

/// Runs F over the numbers make(0), make(1), ...; expanded, not looped, so that optimizers keep all of them in
/// registers.
template <Formula F, class Make>
constexpr auto evaluate(Make make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return value_of<F>(std::array<decltype(make(std::size_t{})), arity<F>>{make(I)...});
  }
  (std::make_index_sequence<arity<F>>{});
}

/// With |coordinates| < 2^bits, the exact value is below 2^(this) in magnitude.
template <Formula F>
constexpr int value_bits(int bits) {
  return evaluate<F>([bits](std::size_t) { return BitLength{bits}; }).bits;
}

/// c with: a computed value beyond c * magnitude has the sign of the exact value.  The two units added pay for the
/// roundings of the magnitude's last sum and of the product with c.
template <Formula F>
consteval double filter_constant() {
  return static_cast<double>(Bound(evaluate<F>([](std::size_t) { return Bound::Input{}; })).root + 2) * Bound::unit;
}

}  // namespace plumb

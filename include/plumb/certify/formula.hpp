// What is known of a formula before it is run?  Degree, error constant, tape: all derived when compiled.
//
// A formula is a type with `name`, `points` and `dimension`, and a call operator template over std::array<T, points *
// dimension> that uses + - * only (predicates/orient.hpp is an example).  It is stated once; running it over different
// numbers yields every stage.
// Laws: a formula that adds terms of unequal degree, that needs more error than the bound can hold, or that returns a
// coordinate as it is given, does not compile.
// Source: docs/proof.md; cost: compile time only.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "plumb/arith/bound.hpp"
#include "plumb/arith/degree.hpp"
#include "plumb/arith/strict.hpp"
#include "plumb/arith/tape.hpp"

namespace plumb {

template <class F>
concept Formula = std::default_initializable<F> && requires {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::points } -> std::convertible_to<int>;
  { F::dimension } -> std::convertible_to<int>;
};

/// How many coordinates the formula takes, point after point.
template <Formula F>
inline constexpr std::size_t arity = static_cast<std::size_t>(F::points* F::dimension);

template <Formula F>
using Coordinates = std::array<double, arity<F>>;

/// Runs F over the numbers make(0), make(1), ...; expanded, not looped, so that optimizers keep all of them in
/// registers.
template <Formula F, class Make>
constexpr auto evaluate(Make make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return F{}(std::array<decltype(make(std::size_t{})), arity<F>>{make(I)...});
  }
  (std::make_index_sequence<arity<F>>{});
}

/// The degree of the homogeneous polynomial.
template <Formula F>
consteval int degree() {
  return Degree(F{}(std::array<Degree::Input, arity<F>>{})).degree;
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
  return static_cast<double>(Bound(F{}(std::array<Bound::Input, arity<F>>{})).root + 2) * 0x1p-85;
}

namespace tape {

template <Formula F, std::size_t Capacity>
consteval Tape<Capacity> record() {
  Tape<Capacity> tape;
  tape.arity = arity<F>;
  std::array<Recorded<Capacity>, arity<F>> in{};
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = {&tape, static_cast<std::uint16_t>(i)};
  const auto result = F{}(in);
  if (result.index < arity<F>) throw std::logic_error("a formula returns a coordinate as it is given");
  tape.size = result.index + 1 - arity<F>;  // what is computed after the result is no part of it
  return tape;
}

template <Formula F>
inline constexpr auto of = [] {
  constexpr auto recorded = record<F, 4096>();
  Tape<recorded.size> tape;
  tape.size = recorded.size;
  tape.arity = recorded.arity;
  for (std::size_t i = 0; i < tape.size; ++i) tape.instructions[i] = recorded.instructions[i];
  return tape;
}();

}  // namespace tape

/// The formula as data.
template <Formula F>
constexpr Program program() {
  return {arity<F>, tape::of<F>.instructions};
}

}  // namespace plumb

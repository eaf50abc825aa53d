// What is known of a formula before it is run?  Degree, error constant, tape: all derived when compiled.
//
// A formula is a type with `name`, the shape of its input, and a call operator template over std::array<T, arity> that
// uses + - * only (predicates/orient.hpp is an example).  The shape is `points` and `dimension`, or, where arguments
// differ in kind, the number of coordinates of each in `arguments`.  It is stated once; running it over different
// numbers yields every stage. Laws: a formula that needs more error than the bound can hold, or that returns a
// coordinate as it is given, does not compile; nor does one that adds terms of unequal degree, unless it says
// `homogeneous = false` (it has no integer stages then). Source: docs/proof.md; cost: compile time only.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "plumb/arith/bound.hpp"
#include "plumb/arith/degree.hpp"
#include "plumb/arith/strict.hpp"
#include "plumb/arith/tape.hpp"

namespace plumb {

/// All arguments are points of one dimension.
template <class F>
concept TakesPoints = requires {
  { F::points } -> std::convertible_to<int>;
  { F::dimension } -> std::convertible_to<int>;
};

template <class F>
concept Formula = std::default_initializable<F> && requires {
  { F::name } -> std::convertible_to<std::string_view>;
} &&(TakesPoints<F> || requires { std::span<const int>(F::arguments); });

/// How many coordinates each argument has.
template <Formula F>
inline constexpr auto arguments = [] {
  if constexpr (TakesPoints<F>) {
    std::array<int, static_cast<std::size_t>(F::points)> all{};
    all.fill(F::dimension);
    return all;
  } else {
    return F::arguments;
  }
}();

/// How the coordinates of an argument are called, "xyz" unless the formula has `axes` of its own.
template <Formula F>
inline constexpr std::string_view axes = [] {
  if constexpr (requires { F::axes; }) {
    return F::axes;
  } else {
    return std::string_view("xyz");
  }
}();

/// What the arguments are called: a, b, c, ... unless the formula has `argument_names` of its own.
template <Formula F>
inline constexpr std::span<const std::string_view> argument_names = [] {
  if constexpr (requires { F::argument_names; }) {
    static_assert(F::argument_names.size() == arguments<F>.size());
    return std::span<const std::string_view>(F::argument_names);
  } else {
    return std::span<const std::string_view>();
  }
}();

/// How many coordinates the formula takes, argument after argument.
template <Formula F>
inline constexpr std::size_t arity = [] {
  std::size_t sum = 0;
  for (const int n : arguments<F>) sum += static_cast<std::size_t>(n);
  return sum;
}();

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

/// All terms have one degree: scaling the coordinates by a power of two keeps the sign.
template <Formula F>
inline constexpr bool is_homogeneous = [] {
  if constexpr (requires { F::homogeneous; }) {
    return F::homogeneous;
  } else {
    return true;
  }
}();

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

/// The formula as data.
template <Formula F>
constexpr Program program() {
  return {arity<F>, of<F>.instructions};
}

}  // namespace tape

/// Of the terms of the formula, whether or not they have one degree.
struct TermDegrees {
  int highest;
  bool equal;
};

template <Formula F>
consteval TermDegrees term_degrees() {
  constexpr auto& steps = tape::of<F>.instructions;
  std::array<int, arity<F> + steps.size()> degree{};
  for (std::size_t i = 0; i < arity<F>; ++i) degree[i] = 1;
  bool equal = true;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const int left = degree[steps[i].left], right = degree[steps[i].right];
    equal = equal && (steps[i].operation == '*' || left == right);
    degree[arity<F> + i] = steps[i].operation == '*' ? left + right : left > right ? left : right;
  }
  return {degree.back(), equal};
}

}  // namespace plumb

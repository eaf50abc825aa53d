// What shape has a formula, and which operations does it do?  Recorded when compiled, before anything runs it.
//
// Cost: compile time only.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>

#include "plumb/arith/strict.hpp"
#include "plumb/certify/detail/tape.hpp"

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

/// All terms have one degree: scaling the coordinates by a power of two keeps the sign.
template <Formula F>
inline constexpr bool is_homogeneous = [] {
  if constexpr (requires { F::homogeneous; }) {
    return F::homogeneous;
  } else {
    return true;
  }
}();

namespace certify::tape {

template <Formula F, std::size_t Capacity>
consteval Tape<Capacity> record() {
  Tape<Capacity> tape;
  tape.arity = arity<F>;
  using Number = Recorded<Capacity>;
  using Input = std::array<Number, arity<F>>;
  if constexpr (!std::is_invocable_v<F, const Input&>) {
    tape.note(Misuse::other_input);
  } else if constexpr (!std::is_same_v<std::invoke_result_t<F, const Input&>, Number>) {
    tape.note(Misuse::other_result);
  } else {
    Input in{};
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = {&tape, static_cast<std::uint16_t>(i)};
    const Number result = F{}(in);
    const std::uint16_t last = result.result();
    if (result.index < arity<F>) tape.note(Misuse::coordinate_returned);
    if (last >= arity<F>) tape.size = last + 1 - arity<F>;  // what is computed after the result is no part of it
  }
  if (tape.misuse != Misuse::none) {  // anything that all numbers can run: the compiler says what is wrong, and no more
    tape.size = 0;
    tape.as_written = false;
    tape.write('*', 0, 0);
  }
  return tape;
}

template <Formula F>
inline constexpr auto of = [] {
  constexpr auto recorded = record<F, 4096>();
  Tape<recorded.size> tape;
  tape.size = recorded.size;
  tape.arity = recorded.arity;
  tape.misuse = recorded.misuse;
  tape.as_written = recorded.as_written;
  for (std::size_t i = 0; i < tape.size; ++i) tape.instructions[i] = recorded.instructions[i];
  return tape;
}();

/// On which coordinates the result depends.
template <Formula F>
inline constexpr auto uses = [] {
  std::array<bool, arity<F> + of<F>.size> used{};
  used.back() = true;
  for (std::size_t i = of<F>.size; i-- > 0;) {
    if (!used[arity<F> + i]) continue;
    used[of<F>.instructions[i].left] = true;
    used[of<F>.instructions[i].right] = true;
  }
  return used;
}();

}  // namespace certify::tape

/// Of the terms of the formula, whether or not they have one degree.
struct TermDegrees {
  int highest;
  bool equal;
};

template <Formula F>
consteval TermDegrees term_degrees() {
  constexpr auto& steps = certify::tape::of<F>.instructions;
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

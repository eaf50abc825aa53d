// Is this a polynomial at these arguments?  What the compiler says, in a sentence each, of what is none.
//
// A formula, or a lambda without captures that takes every coordinate as `auto`, uses + - * on its coordinates and on
// results, and multiplies by whole numbers; each argument is a point, a vector, a number or an array of numbers.
// Laws: what is refused is refused by one of the sentences below and nothing else: a formula is first run over the
// number that records its tape, which can do all that a double can and notes what no polynomial does.
// This header comes first where others are included, so that a compiler has little to tell of the way to it.
// Cost: compile time only.
#pragma once

#include <tuple>
#include <utility>

#include "plumb/arith/point.hpp"
#include "plumb/certify/detail/formula_tape.hpp"

namespace plumb {

/// Refuses to compile what is no polynomial; true.
template <Formula F>
consteval bool is_polynomial() {
  constexpr certify::tape::Misuse did = certify::tape::of<F>.misuse;
  static_assert(did != certify::tape::Misuse::other_input,
                "plumb: a formula's call operator takes std::array<T, N> of any T, with N = points * dimension or the "
                "sum of `arguments`");
  static_assert(did != certify::tape::Misuse::other_result,
                "plumb: a formula returns the polynomial's value, made by + - * of its coordinates");
  static_assert(did != certify::tape::Misuse::coordinate_returned,
                "plumb: a formula returns a coordinate as it is given, whose sign needs no formula");
  static_assert(did != certify::tape::Misuse::broken_constant,
                "plumb: a formula multiplies by whole numbers from 1 to 2^31 - 1 and their opposites (2 * x, -3.0 * "
                "x); multiply all terms up to whole numbers, or give the constant as one more argument");
  static_assert(did != certify::tape::Misuse::added_constant,
                "plumb: a formula adds no constants: give it as one more argument (f * f for 1, with f = 1.0)");
  static_assert(did != certify::tape::Misuse::division,
                "plumb: a formula does not divide: multiply by the denominator, whose sign is another formula's");
  static_assert(did != certify::tape::Misuse::comparison,
                "plumb: a formula does not compare its values: each branch is a formula of its own");
  static_assert(did != certify::tape::Misuse::none || !is_homogeneous<F> || term_degrees<F>().equal,
                "plumb: a formula adds terms of unequal degree: give one more argument as their factor, or say `static "
                "constexpr bool homogeneous = false;`");
  return true;
}

/// Refuses to compile polynomials of which none uses some coordinate; true.
template <Formula F, Formula... Others>
consteval bool use_all_coordinates() {
  constexpr bool all = [] {
    for (std::size_t i = 0; i < arity<F>; ++i) {
      if (!certify::tape::uses<F>[i] && !(certify::tape::uses<Others>[i] || ...))
        return certify::tape::of<F>.misuse != certify::tape::Misuse::none;
    }
    return true;
  }();
  static_assert(all,
                "plumb: a formula does not use one of its coordinates, where a NaN would pass unseen: leave it out of "
                "the arguments");
  return true;
}

constexpr std::array<double, 1> coordinates(double x) { return {x}; }
constexpr std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
constexpr std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }
constexpr std::array<double, 2> coordinates(const Vector2& v) { return {v.x, v.y}; }
constexpr std::array<double, 3> coordinates(const Vector3& v) { return {v.x, v.y, v.z}; }
template <std::size_t N>
constexpr std::array<double, N> coordinates(const std::array<double, N>& x) {
  return x;
}

/// A point, a vector, a number, or an array of numbers.
template <class Argument>
concept HasCoordinates = requires(const Argument& a) {
  coordinates(a);
};

/// How many coordinates an argument of sign_of contributes.
template <class Argument>
inline constexpr int coordinate_count = [] {
  if constexpr (HasCoordinates<Argument>) {
    return static_cast<int>(std::tuple_size_v<decltype(coordinates(std::declval<const Argument&>()))>);
  } else {
    return 1;
  }
}();

/// A lambda of scalars as a formula; Counts says how many of them each argument contributes.
template <class Lambda, bool Homogeneous, int... Counts>
struct LambdaFormula {
  static constexpr std::string_view name = "sign_of";
  static constexpr std::array<int, sizeof...(Counts)> arguments{Counts...};
  static constexpr bool homogeneous = Homogeneous;

  template <class T>
  constexpr auto operator()(const std::array<T, (std::size_t{Counts} + ...)>& p) const {
    return std::apply(Lambda{}, p);
  }
};

/// Stands for a polynomial that was refused, so that the compiler says no more than that.
struct NoFormula {
  static constexpr std::string_view name = "none";
  static constexpr std::array arguments{1};
  template <class T>
  constexpr auto operator()(const std::array<T, 1>& p) const {
    return p[0] * p[0];
  }
};

/// How well a polynomial and its arguments go together.
template <class Polynomial, class... Arguments>
struct Fit {
  static constexpr std::size_t count = (static_cast<std::size_t>(coordinate_count<Arguments>) + ... + 0);
  static constexpr bool have_coordinates = (HasCoordinates<Arguments> && ...);
  static constexpr bool without_captures = std::is_empty_v<Polynomial> && std::is_default_constructible_v<Polynomial>;
  static constexpr bool equal_counts = [] {
    if constexpr (Formula<Polynomial>) {
      return arity<Polynomial> == count;
    } else if constexpr (without_captures && count > 0) {
      return []<std::size_t... I>(std::index_sequence<I...>) {
        return std::is_invocable_v<Polynomial,
                                   decltype((void)I, std::declval<const certify::tape::Recorded<4096>&>())...>;
      }
      (std::make_index_sequence<count>{});
    } else {
      return false;
    }
  }();
};

/// Refuses to compile what sign_of and its like do not take; true.
template <class Polynomial, class... Arguments>
consteval bool accepts(std::type_identity<std::tuple<Arguments...>> = {}) {
  using Fits = Fit<Polynomial, Arguments...>;
  static_assert(
      Fits::have_coordinates,
      "plumb: sign_of takes points, vectors, numbers and arrays of numbers; signs_of takes spans of them, and "
      "last a span of Sign to write to");
  static_assert(!Fits::have_coordinates || Fits::without_captures,
                "plumb: a polynomial is a formula or a lambda without captures; give it what it captures as one more "
                "argument");
  static_assert(!Fits::have_coordinates || !Fits::without_captures || Fits::equal_counts,
                "plumb: the polynomial takes another number of coordinates than these arguments have (a lambda takes "
                "each of them as `auto`)");
  return true;
}

/// The formula that sign_of takes a polynomial for: itself, or a lambda's.
template <class Polynomial, class... Arguments>
struct FormulaOf {
  static constexpr auto chosen() {
    using Fits = Fit<Polynomial, Arguments...>;
    if constexpr (!Fits::have_coordinates || !Fits::without_captures || !Fits::equal_counts) {
      return NoFormula{};
    } else if constexpr (Formula<Polynomial>) {
      return Polynomial{};
    } else {
      constexpr auto degrees = term_degrees<LambdaFormula<Polynomial, false, coordinate_count<Arguments>...>>();
      return LambdaFormula<Polynomial, degrees.equal, coordinate_count<Arguments>...>{};
    }
  }
  using Type = decltype(chosen());
};

/// The coordinates of all arguments in turn.
template <Formula F, class... Arguments>
constexpr Coordinates<F> coordinates_of(const Arguments&... arguments) {
  if constexpr (std::is_same_v<F, NoFormula>) {
    return {};
  } else {
    return std::apply([](auto... x) { return Coordinates<F>{x...}; }, std::tuple_cat(coordinates(arguments)...));
  }
}

}  // namespace plumb

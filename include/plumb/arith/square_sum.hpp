// How far off is a sum of squares in plain doubles, or a length?  Errors that are part of a number's type.
//
//   const auto apart = squared(difference(a.x, b.x)) + squared(difference(a.y, b.y));  // apart.value, and its error
//
// Nothing here is negative, so that a sum is its own magnitude: no second sum stands beside it.
// Laws: (1) |value - exact| <= relative value + absolute, as long as the value is finite; of NaN and infinity nothing is
// said.  (2) compare() has the sign of the exact difference, or says that it is not sure.  (3) What exceeds
// certainly_beyond() is beyond, infinity as well.
// Proof: docs/proof.md, "Sums of squares".
// Source: RTCD 11.2.
// Cost: that of the plain operations.
#pragma once

#include <cstdint>

#include "plumb/arith/bound.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb::arith::squares {

/// A relative error in units of 2^-85; and how many products may have underflown, by 2^-1021 each, or its root.
struct Error {
  std::uint64_t relative;
  unsigned products;
  bool is_root;
};

/// A difference or sum of two numbers as given, rounded once.
struct Difference {
  double value;
};
constexpr Difference difference(double a, double b) { return {a - b}; }
constexpr Difference sum(double a, double b) { return {a + b}; }
/// By a power of two.
constexpr Difference scaled(const Difference& d, double power) { return {d.value * power}; }

template <Error E>
struct NotNegative {
  static constexpr Error error = E;
  static constexpr double relative = static_cast<double>(E.relative) * Bound::unit;
  static constexpr double absolute = E.products * (E.is_root ? 0x1p-510 : 0x1p-1021);

  double value;

  /// The exact number is no less.
  [[nodiscard]] constexpr double lower() const {
    const Interval v(value), least = v - v * Interval(relative) - Interval(absolute);
    return least.lower > 0 ? least.lower : 0;
  }
  /// Whose value is no more than this is itself no more than the limit; below zero where nothing is certain.
  static constexpr double certainly_within(double limit) {
    const double most = quotient(Interval(limit) - Interval(absolute), Interval(1) + Interval(relative)).lower;
    return most >= 0 && limit < Interval::infinity ? most : -1;
  }
  /// Whose value is more than this is itself more than the limit; infinite where nothing is certain.
  static constexpr double certainly_beyond(double limit) {
    constexpr Interval share = quotient(Interval(1), Interval(1) - Interval(relative));
    return ((Interval(limit) + Interval(absolute)) * share).upper;
  }
  /// Whose value is more than this is itself more than the exact number.
  [[nodiscard]] constexpr double beyond() const {
    constexpr Interval less = Interval(1) - Interval(relative),
                       factor = quotient(Interval(1) + Interval(relative), less),
                       guard = quotient(Interval(absolute) + Interval(absolute), less);
    // Outward after each operation, whether it rounded or not.
    return Interval::up(Interval::up(value * factor.upper, 1) + guard.upper, 1);
  }
};

constexpr Error after_sum(const Error& a, const Error& b) {
  const std::uint64_t larger = a.relative > b.relative ? a.relative : b.relative;
  return {Bound::widened(larger) + Bound::eps, a.products + b.products, a.is_root || b.is_root};
}
inline constexpr Error of_square{(Bound(Bound::eps, 0) * Bound(Bound::eps, 0)).e, 1, false};

constexpr NotNegative<of_square> squared(const Difference& d) { return {d.value * d.value}; }

template <Error A, Error B>
constexpr auto operator+(const NotNegative<A>& a, const NotNegative<B>& b) {
  static_assert(A.is_root == B.is_root, "a square and a length");
  return NotNegative<after_sum(A, B)>{a.value + b.value};
}
/// With a number as given, not negative.
template <Error A>
constexpr auto plus_given(const NotNegative<A>& a, double b) {
  return NotNegative<after_sum(A, {0, 0, A.is_root})>{a.value + b};
}
template <Error A>
auto root(const NotNegative<A>& a) {
  static_assert(!A.is_root, "a root of a root");
  return NotNegative<Error{Bound::widened(A.relative) + Bound::eps, A.products, true}>{__builtin_sqrt(a.value)};
}

/// What a difference must exceed: this part of the sum, and a guard.
template <Error A, Error B>
inline constexpr double doubtful_part = [] {
  const std::uint64_t larger = A.relative > B.relative ? A.relative : B.relative;
  return static_cast<double>(Bound::widened(Bound::widened(Bound::widened(larger)))) * Bound::unit;
}();
template <Error A, Error B>
inline constexpr double doubtful_guard = (A.products + B.products + 1) * 0x1p-1021;

struct Comparison {
  double value;  // the sign, where sure
  bool sure;
};
template <Error A, Error B>
constexpr Comparison compare(const NotNegative<A>& a, const NotNegative<B>& b) {
  static_assert(!A.is_root && !B.is_root, "guards are those of squares");
  const double value = a.value - b.value;
  return {value, magnitude_of(value) > doubtful_part<A, B> * (a.value + b.value) + doubtful_guard<A, B>};
}

}  // namespace plumb::arith::squares

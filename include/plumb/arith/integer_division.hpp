// Which integer is a quotient, rounded down, up or to the nearest?  And which of two quotients is larger, not rounded?
//
//   integer_quotient(Rounding::down, -7, 2) == -4      // -7 / 2 is -3, toward zero
//   compare_quotients(1, 3, 2, 6) == Sign::zero
//
// Toward zero, as the processor divides, two neighboring cells are one around zero; a parameter rounded the wrong way is
// beyond its segment.  A decision compares quotients, which needs no division.
// Laws: (1) the integer that the rounding names of the exact quotient, of any signs; ties to even.  (2) compare_quotients
// is the sign of a / b - c / d, for all numbers: nothing overflows.
// A denominator of zero, and the one quotient that no integer of the type holds (least / -1), throw NoQuotient.
// Source: RTCD 11.5.2.
// Cost: a division, or two products of twice the width.
#pragma once

#include <concepts>
#include <limits>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/arith/rounding.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct NoQuotient : Error {
  using Error::Error;
};

template <std::signed_integral Integer>
requires(sizeof(Integer) <= 8) constexpr Integer integer_quotient(Rounding rounding, Integer a, Integer b) {
  if (b == 0) throw NoQuotient("integer_quotient: the denominator is zero");
  if (b == -1 && a == std::numeric_limits<Integer>::min()) {
    throw NoQuotient("integer_quotient: " + std::to_string(a) + " / -1 is above all integers of the type");
  }
  const auto toward_zero = static_cast<Integer>(a / b);
  const auto rest = static_cast<Integer>(a % b);
  if (rest == 0) return toward_zero;
  const bool is_negative = (a < 0) != (b < 0);
  const auto below = static_cast<Integer>(is_negative ? toward_zero - 1 : toward_zero);
  const auto above = static_cast<Integer>(is_negative ? toward_zero : toward_zero + 1);
  if (rounding != Rounding::nearest) return rounding == Rounding::down ? below : above;
  // |rest| against |b| - |rest|, as negative numbers, of which there is one more.
  const auto part = static_cast<Integer>(rest < 0 ? rest : -rest), whole = static_cast<Integer>(b < 0 ? b : -b);
  const auto other = static_cast<Integer>(whole - part);
  const auto away = static_cast<Integer>(is_negative ? below : above);
  if (part == other) return toward_zero % 2 == 0 ? toward_zero : away;
  return part < other ? away : toward_zero;
}

/// a / b against c / d.
template <std::signed_integral Integer>
requires(sizeof(Integer) <= 8) constexpr Sign compare_quotients(Integer a, Integer b, Integer c, Integer d) {
  if (b == 0 || d == 0) throw NoQuotient("compare_quotients: a denominator is zero");
  __extension__ using Wide = __int128;
  const Wide left = static_cast<Wide>(a) * d, right = static_cast<Wide>(c) * b;
  const bool turns = (b < 0) != (d < 0);
  if (left == right) return Sign::zero;
  return (left < right) != turns ? Sign::negative : Sign::positive;
}

}  // namespace plumb

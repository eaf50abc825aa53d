// Rounding: is this the double nearest to a distance?
//
// Laws: exact; what is in the middle between two doubles goes to the even one, and what is as far beyond the last as
// the middle between it and 2^1024 to infinity.
// Source: IEEE 754-2019, 4.3.1.
// Cost: GMP; two products.
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumb::query {

/// Of root(square) - inset, or of zero where that is negative.
inline bool is_rounded(double r, const mpq_class& square, const mpq_class& inset) {
  if (std::isnan(r) || std::signbit(r)) return false;
  constexpr auto infinity = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  const auto bits = std::bit_cast<std::uint64_t>(r);
  const auto value = [](std::uint64_t of) {
    if (of != infinity) return mpq_class(std::bit_cast<double>(of));
    return mpq_class(mpz_class(1) << 1024);
  };
  const auto beyond_middle = [&](std::uint64_t neighbor) {  // is the distance?
    const mpq_class middle = (value(bits) + value(neighbor)) / 2 + inset;
    return cmp(square, mpq_class(middle * middle));
  };
  const int in_middle = (bits & 1) == 0 ? 0 : 1;
  if (bits > 0 && beyond_middle(bits - 1) < in_middle) return false;
  return bits == infinity || beyond_middle(bits + 1) <= -in_middle;
}

}  // namespace plumb::query

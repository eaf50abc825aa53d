// On which power of two do these coordinates lie, and how many bits do they then take?
//
// Laws: every coordinate is an integer multiple of 2^exponent, and 2^exponent is the largest such power; the integers
// are below 2^bits in magnitude, and bits is the least such number.  All zeros: bits 0, exponent 0.
// A scene of few bits needs only small integers (section 3 of docs/proof.md).
// Source: RTCD 11.5.1.
// Cost: a few ns a value.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// A finite double as an odd integer times a power of two: x = mantissa * 2^exponent; mantissa 0 for zero.
struct OddForm {
  std::int64_t mantissa;
  int exponent;
};

struct Lattice {
  int exponent = 0;
  int bits = 0;
  friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// Any finite x.
constexpr OddForm odd_form(double x) {
  const auto pattern = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(pattern >> 52 & 0x7ff);
  std::uint64_t m = pattern & 0xfffffffffffff;
  if (biased != 0) m |= 1ull << 52;
  if (m == 0) return {0, 0};
  const int zeros = std::countr_zero(m);
  const auto odd = static_cast<std::int64_t>(m >> zeros);
  return {(pattern >> 63) != 0 ? -odd : odd, (biased != 0 ? biased : 1) - 1075 + zeros};
}

/// The exponents that a set of coordinates spans.
class ExponentSpan {
 public:
  constexpr void include(const OddForm& f) {
    if (f.mantissa == 0) return;
    const auto magnitude = static_cast<std::uint64_t>(f.mantissa < 0 ? -f.mantissa : f.mantissa);
    const int top = f.exponent + static_cast<int>(std::bit_width(magnitude));
    lowest_ = f.exponent < lowest_ ? f.exponent : lowest_;
    end_ = top > end_ ? top : end_;
  }
  [[nodiscard]] constexpr Lattice lattice() const {
    return end_ < lowest_ ? Lattice{} : Lattice{lowest_, end_ - lowest_};
  }

 private:
  int lowest_ = 4096, end_ = -4096;  // beyond every double
};

/// The lattice of a set of finite doubles.
constexpr Lattice lattice_of(std::span<const double> coordinates) {
  ExponentSpan span;
  for (const double x : coordinates) span.include(odd_form(x));
  return span.lattice();
}

}  // namespace plumb

// Which integers are these coordinates, on the lattice that they share?
//
// Adding 1.5 * 2^52 units to a double below 2^51 units rounds it to whole units, which then are the low bits of the
// sum. A second step takes ten bits more of what is left.  Two coordinates are converted at a time, without a branch.
// Laws: where bits() is not 0, every coordinate is exactly integer(i) times one power of two, the same for all, and
// |integer(i)| < 2^bits(), the least such number; zeros() more of them could be taken off at the other end.  bits() is
// 0 where the coordinates span more than 61 bits, where the largest is below 2^(Least - 1023) or not below 2^1021, and
// where one of them is not finite.  From 64 on no sum is subnormal, which takes a hundred times as long as others.
// Source: RTCD 11.5.1; Dekker 1971 for the rounding by a large addend.
// Cost: 1 to 2 ns for four coordinates.
#pragma once

#include "plumb/arith/coordinate_pairs.hpp"

namespace plumb {

template <std::size_t N, std::uint64_t Least = 9>
class LatticeIntegers {
 public:
  static constexpr int most_bits = 61;

  [[gnu::always_inline]] explicit LatticeIntegers(const std::array<double, N>& p) {
    const Pairs x(p);
    const std::uint64_t exponent = x.largest_exponent();
    if (exponent - least_exponent > most_exponent - least_exponent) return;

    origin_ = addend_bits(exponent + 2);
    const Pair addend = Pairs::both(origin_);
    Bits exact = ~Bits{};
    Bits ones{};
#pragma GCC unroll 64
    for (std::size_t i = 0; i < Pairs::count; ++i) {
      const Pair whole = x.pair[i] + addend;
      exact &= std::bit_cast<Bits>(whole - addend == x.pair[i]);
      ones |= set(i, std::bit_cast<Bits>(whole));
    }
    if ((exact[0] & exact[1]) != 0) {
      finish(ones, first_bits);
    } else {
      take_second_step(x, addend, exponent);
    }
  }

  [[nodiscard]] int bits() const { return bits_; }
  /// How many zeros end every integer.
  [[nodiscard]] int zeros() const { return zeros_; }
  [[nodiscard]] std::int64_t integer(std::size_t i) const { return static_cast<std::int64_t>(raw_[i] - origin_); }
  /// integer(i) - integer(j), for which no origin is needed.
  [[nodiscard]] std::int64_t difference(std::size_t i, std::size_t j) const {
    return static_cast<std::int64_t>(raw_[i] - raw_[j]);
  }

 private:
  using Pairs = CoordinatePairs<N>;
  using Pair = typename Pairs::Pair;
  using Bits = typename Pairs::Bits;

  static constexpr int first_bits = 51, second_bits = most_bits - first_bits;
  // The exponent fields of the largest coordinate whose addends are normal numbers with normal or subnormal units; one
  // more, and what rounds up to a power of two would overflow.
  static constexpr std::uint64_t least_exponent = Least, most_exponent = 2043;
  static_assert(Least >= 9);

  static std::uint64_t addend_bits(std::uint64_t exponent) { return exponent << 52 | 1ull << 51; }
  Bits set(std::size_t pair, Bits value) {
    Pairs::store(value, pair, raw_);
    return value;
  }

  [[gnu::always_inline]] void take_second_step(const Pairs& x, Pair addend, std::uint64_t exponent) {
    const std::uint64_t second_origin = addend_bits(exponent + 2 - second_bits);
    const Pair second_addend = Pairs::both(second_origin);
    origin_ = (origin_ << second_bits) + second_origin;
    Bits exact = ~Bits{};
    Bits ones{};
#pragma GCC unroll 64
    for (std::size_t i = 0; i < Pairs::count; ++i) {
      const Pair whole = x.pair[i] + addend, rest = x.pair[i] - (whole - addend), second = rest + second_addend;
      exact &= std::bit_cast<Bits>(second - second_addend == rest);
      ones |= set(i, (std::bit_cast<Bits>(whole) << second_bits) + std::bit_cast<Bits>(second));
    }
    if ((exact[0] & exact[1]) != 0) finish(ones, most_bits);
  }

  void finish(Bits ones, int bits) {
    zeros_ = std::countr_zero(ones[0] | ones[1] | 1ull << 51);  // below that the origin's bits are zero
    bits_ = bits;
  }

  std::array<std::uint64_t, N> raw_;
  std::uint64_t origin_;
  int zeros_, bits_ = 0;
};

}  // namespace plumb

// Which integers are these coordinates, when the lattice that they share takes hundreds of bits?
//
// As LatticeIntegers, in as many steps as it takes: each adds a large number that leaves the next 47 bits of every
// coordinate in the low bits of the sum, and goes on with what is left.
// Laws: where extend<B>() holds, coordinate i is exactly integer<B>(i) times one power of two, the same for all, and
// |integer<B>(i)| < 2^B.  It does not hold where the coordinates span more than B bits, where the largest is not below
// 2^1018 or so small that its digits' units are no doubles, and where one of them is not finite.
// Source: RTCD 11.5.1; Dekker 1971 for the rounding by a large addend.
// Cost: 1 ns for two coordinates and 47 bits.
#pragma once

#include "plumb/arith/coordinate_pairs.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb {

template <std::size_t N, int MostBits>
class LatticeDigits {
 public:
  // The exponents of the largest coordinate for which the addends of all digits are normal numbers.
  static constexpr int most_exponent = 1017;
  static constexpr int least_exponent(int bits) { return -1028 + (count(bits) - 1) * digit_bits; }

  explicit LatticeDigits(const std::array<double, N>& p) : rest_(p), exponent_(rest_.largest_exponent()) {}

  /// Finds the digits of the leading Bits bits; is that all there is?  In the order of growing Bits.
  template <int Bits>
  bool extend() {
    constexpr int digits = count(Bits), unused = digits * digit_bits - Bits;
    static_assert(Bits <= MostBits);
    const auto exponent = static_cast<int>(exponent_) - 1023;
    if (exponent < least_exponent(Bits) || exponent > most_exponent) return false;
    for (; found_ < digits; ++found_) take_digit();
    return exact_ && (ones_ & ((1ull << unused) - 1)) == 0;
  }

  template <int Bits>
  [[nodiscard]] WideInt<Bits> integer(std::size_t i) const {
    return composed<Bits, Bits>([&](std::size_t k) { return digit_[k][i] - origin(k); });
  }
  /// integer(i) - integer(j), for which no origins are needed.
  template <int Bits>
  [[nodiscard]] WideInt<Bits + 1> difference(std::size_t i, std::size_t j) const {
    return composed<Bits, Bits + 1>([&](std::size_t k) { return digit_[k][i] - digit_[k][j]; });
  }

 private:
  using Pairs = CoordinatePairs<N>;
  static constexpr int digit_bits = 47;
  static constexpr int count(int bits) { return (bits + digit_bits - 1) / digit_bits; }

  // The pattern of 1.5 * 2^52 units of digit k.
  [[nodiscard]] std::uint64_t origin(std::size_t k) const {
    return (exponent_ + 6 - k * digit_bits) << 52 | 1ull << 51;
  }

  void take_digit() {
    const auto k = static_cast<std::size_t>(found_);
    const auto addend = Pairs::both(origin(k));
    typename Pairs::Bits ones{}, inexact{};
#pragma GCC unroll 64
    for (std::size_t i = 0; i < Pairs::count; ++i) {
      const auto whole = rest_.pair[i] + addend;
      rest_.pair[i] -= whole - addend;
      inexact |= std::bit_cast<typename Pairs::Bits>(rest_.pair[i] != 0.0);
      const auto bits = std::bit_cast<typename Pairs::Bits>(whole);
      ones |= bits;
      Pairs::store(bits, i, digit_[k]);
    }
    exact_ = (inexact[0] | inexact[1]) == 0;
    ones_ = ones[0] | ones[1];
  }

  // The digits, the last of them without its unused bits, as one integer.
  template <int Bits, int ResultBits, class Digit>
  static WideInt<ResultBits> composed(Digit digit) {
    constexpr std::size_t digits = static_cast<std::size_t>(count(Bits));
    constexpr int unused = count(Bits) * digit_bits - Bits;
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
      WideInt<ResultBits> sum{static_cast<std::int64_t>(digit(digits - 1)) >> unused};
      ((sum = fitting_sum(sum, shifted_by<ResultBits, (static_cast<int>(digits - 1 - K) * digit_bits - unused)>(
                                   static_cast<std::int64_t>(digit(K))))),
       ...);
      return sum;
    }
    (std::make_index_sequence<digits - 1>{});
  }

  Pairs rest_;
  std::uint64_t exponent_, ones_ = 0;
  int found_ = 0;
  bool exact_ = false;
  std::array<std::array<std::uint64_t, N>, static_cast<std::size_t>(count(MostBits))> digit_;
};

}  // namespace plumb

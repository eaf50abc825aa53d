// What is the exact value of small integers?  Integers of 127 bits, each with the most bits that it can have.
//
// Laws: |value| < 2^bits, and the value is exact where bits is no more than 127; else it is lost, and so is what is
// computed of it, whose sign is not certain.
// Source: RTCD 11.5.1.
// Cost: a tenth of integers of as many limbs as they need.
#pragma once

#include <bit>
#include <cstdint>

#include "plumb/arith/sign.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb {

class TwoWordInteger {
 public:
  /// An integer of up to 62 bits.
  explicit TwoWordInteger(double x) : TwoWordInteger(static_cast<std::int64_t>(x)) {}
  static TwoWordInteger difference(double a, double b) {
    return TwoWordInteger(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
  }

  [[nodiscard]] Unsure<Sign> sign() const {
    if (bits_ > most_bits) return {};
    return Unsure{static_cast<Sign>(static_cast<int>(value_ > 0) - static_cast<int>(value_ < 0))};
  }

  friend TwoWordInteger operator+(const TwoWordInteger& a, const TwoWordInteger& b) {
    return {wrapped(a) + wrapped(b), bits_of_sum(a, b)};
  }
  friend TwoWordInteger operator-(const TwoWordInteger& a, const TwoWordInteger& b) {
    return {wrapped(a) - wrapped(b), bits_of_sum(a, b)};
  }
  friend TwoWordInteger operator*(const TwoWordInteger& a, const TwoWordInteger& b) {
    return {wrapped(a) * wrapped(b), a.bits_ + b.bits_};
  }

 private:
  static constexpr int most_bits = 127;

  explicit TwoWordInteger(std::int64_t m)
      : value_(m),
        bits_(
            static_cast<int>(std::bit_width(m < 0 ? -static_cast<std::uint64_t>(m) : static_cast<std::uint64_t>(m)))) {}
  TwoWordInteger(UInt128 value, int bits) : value_(static_cast<Int128>(value)), bits_(bits) {}

  static UInt128 wrapped(const TwoWordInteger& x) { return static_cast<UInt128>(x.value_); }
  static int bits_of_sum(const TwoWordInteger& a, const TwoWordInteger& b) {
    return (a.bits_ > b.bits_ ? a.bits_ : b.bits_) + 1;
  }

  Int128 value_;
  int bits_;
};

}  // namespace plumb

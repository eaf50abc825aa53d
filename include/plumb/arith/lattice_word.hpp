// How can one stored word be a double and an integer at once?  A lattice coordinate m is kept as m + the bit pattern of
// 1.5 * 2^52: below 2^51 in magnitude that is also the pattern of the double 1.5 * 2^52 + m.
//
// Laws: the difference of two words is that of their integers, in doubles while both are below 2^51 in magnitude and in
// integers while both are below 2^62; neither costs a conversion.  A coordinate by itself costs one subtraction.
// Each of the types below is an input that a formula can run over, for one arithmetic: doubles, WideInt, integers
// modulo 2^64.
// Source: the binade trick of fast float-to-integer conversions; RTCD 11.5.1.
// Cost: none beyond the arithmetic's own.
#pragma once

#include <bit>
#include <cstdint>

#include "plumb/arith/wide_int.hpp"

namespace plumb {

namespace arith::lattice_word {

inline constexpr double center = 0x1.8p52;
inline constexpr auto center_pattern = std::bit_cast<std::uint64_t>(center);

/// Coordinates of up to so many bits can be differences of doubles, and are kept so; of 64-bit integers.
inline constexpr int double_bits = 51, integer_bits = 62;

constexpr std::uint64_t of(std::int64_t m) { return static_cast<std::uint64_t>(m) + center_pattern; }
constexpr std::int64_t integer(std::uint64_t word) { return static_cast<std::int64_t>(word - center_pattern); }
constexpr double as_double(std::uint64_t word) { return std::bit_cast<double>(word); }

}  // namespace arith::lattice_word

/// Doubles, for coordinates below 2^51 in magnitude.
struct WordAsDouble {
  double from_center;

  constexpr explicit WordAsDouble(std::uint64_t word) : from_center(arith::lattice_word::as_double(word)) {}
  constexpr explicit WordAsDouble(double word) : from_center(word) {}

  friend constexpr double operator-(WordAsDouble a, WordAsDouble b) { return a.from_center - b.from_center; }
  constexpr operator double() const {  // NOLINT: mixes as an intermediate value
    return from_center - arith::lattice_word::center;
  }
};

/// Integers of Bits bits, for coordinates below 2^(Bits - 1) in magnitude: a difference or sum of two still fits.
template <int Bits>
struct WordAsInteger {
  std::uint64_t word;

  using Value = WideInt<Bits>;
  [[nodiscard]] constexpr Value value() const { return Value{arith::lattice_word::integer(word)}; }

  friend constexpr Value operator-(WordAsInteger a, WordAsInteger b) {
    return Value{static_cast<std::int64_t>(a.word - b.word)};
  }
  friend constexpr Value operator+(WordAsInteger a, WordAsInteger b) {
    return Value{arith::lattice_word::integer(a.word) + arith::lattice_word::integer(b.word)};
  }
  friend constexpr auto operator*(WordAsInteger a, WordAsInteger b) { return a.value() * b.value(); }
  template <int Other>
  friend constexpr auto operator-(WordAsInteger a, const WideInt<Other>& b) {
    return a.value() - b;
  }
  template <int Other>
  friend constexpr auto operator-(const WideInt<Other>& a, WordAsInteger b) {
    return a - b.value();
  }
  template <int Other>
  friend constexpr auto operator+(WordAsInteger a, const WideInt<Other>& b) {
    return a.value() + b;
  }
  template <int Other>
  friend constexpr auto operator+(const WideInt<Other>& a, WordAsInteger b) {
    return a + b.value();
  }
  template <int Other>
  friend constexpr auto operator*(WordAsInteger a, const WideInt<Other>& b) {
    return a.value() * b;
  }
  template <int Other>
  friend constexpr auto operator*(const WideInt<Other>& a, WordAsInteger b) {
    return a * b.value();
  }
};

/// Integers modulo 2^64.
struct Modular {
  std::uint64_t value;

  friend constexpr Modular operator+(Modular a, Modular b) { return {a.value + b.value}; }
  friend constexpr Modular operator-(Modular a, Modular b) { return {a.value - b.value}; }
  friend constexpr Modular operator*(Modular a, Modular b) { return {a.value * b.value}; }
  /// Of the integer itself, where that is known to be of magnitude below 2^63.
  [[nodiscard]] constexpr std::int64_t near_zero() const { return static_cast<std::int64_t>(value); }
};

struct WordModular {
  std::uint64_t word;

  friend constexpr Modular operator-(WordModular a, WordModular b) { return {a.word - b.word}; }
  friend constexpr Modular operator+(WordModular a, WordModular b) { return Modular(a) + Modular(b); }
  friend constexpr Modular operator*(WordModular a, WordModular b) { return Modular(a) * Modular(b); }
  constexpr operator Modular() const { return {word - arith::lattice_word::center_pattern}; }  // NOLINT: as above
};

/// The bits of WideInt's values and of the widest factor of a product, for a formula over WideInt<Bits>.
struct WidthGrowth {
  int bits, widest_factor = 0;

  friend constexpr WidthGrowth operator+(WidthGrowth a, WidthGrowth b) {
    return {arith::wide::sum_bits(a.bits, b.bits), larger(a.widest_factor, b.widest_factor)};
  }
  friend constexpr WidthGrowth operator-(WidthGrowth a, WidthGrowth b) { return a + b; }
  friend constexpr WidthGrowth operator*(WidthGrowth a, WidthGrowth b) {
    return {a.bits + b.bits, larger(larger(a.bits, b.bits), larger(a.widest_factor, b.widest_factor))};
  }

  /// A coordinate, of which a difference or sum takes no more bits.
  struct Input {
    int bits;
    friend constexpr WidthGrowth operator-(Input a, Input) { return {a.bits}; }
    friend constexpr WidthGrowth operator+(Input a, Input) { return {a.bits}; }
    constexpr operator WidthGrowth() const { return {bits}; }  // NOLINT: mixes as an intermediate value
  };

 private:
  static constexpr int larger(int a, int b) { return a > b ? a : b; }
};

}  // namespace plumb

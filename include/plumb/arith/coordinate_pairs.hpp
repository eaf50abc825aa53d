// Coordinates two by two: one operation of the machine serves both.
//
// Law: the last pair of an odd number overlaps the one before; what is done to pairs must be the same done twice.
// Cost: none.  By the vector types of GCC and Clang, which have them for every machine.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/standard.hpp"

namespace plumb {

template <std::size_t N>
struct CoordinatePairs {
  static_assert(N >= 2, "two coordinates make a pair");
  using Pair = double __attribute__((vector_size(16)));
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  static constexpr std::size_t count = (N + 1) / 2;

  std::array<Pair, count> pair;

  [[gnu::always_inline]] explicit CoordinatePairs(const std::array<double, N>& p) {
#pragma GCC unroll 64
    for (std::size_t i = 0; i < count; ++i) __builtin_memcpy(&pair[i], &p[place(i)], sizeof pair[i]);
  }

  /// The exponent field of the largest magnitude; that of infinity where a coordinate is infinite, any where one is
  /// NaN.
  [[nodiscard]] std::uint64_t largest_exponent() const {
    Pair larger = absolute(pair[0]);
#pragma GCC unroll 64
    for (std::size_t i = 1; i < count; ++i) larger = larger > absolute(pair[i]) ? larger : absolute(pair[i]);
    return std::bit_cast<std::uint64_t>(larger[0] > larger[1] ? larger[0] : larger[1]) >> 52;
  }

  /// The first of the coordinates of pair i.
  static constexpr std::size_t place(std::size_t i) { return 2 * i + 2 <= N ? 2 * i : N - 2; }
  static Pair absolute(Pair x) { return std::bit_cast<Pair>(std::bit_cast<Bits>(x) & Bits{~0ull >> 1, ~0ull >> 1}); }

  static void store(Bits value, std::size_t i, std::array<std::uint64_t, N>& to) {
    __builtin_memcpy(&to[place(i)], &value, sizeof value);
  }
  /// The double of this pattern, twice.
  static Pair both(std::uint64_t pattern) {
    const auto x = std::bit_cast<double>(pattern);
    return Pair{x, x};
  }
};

}  // namespace plumb

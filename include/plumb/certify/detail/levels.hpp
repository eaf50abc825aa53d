// How far apart are the sizes of these coordinates?  In each axis by itself, where the formula's axes may be scaled apart.
//
// A homogeneous formula keeps its sign when all coordinates are multiplied by one power of two; one whose terms have the
// same degree in each axis also when each axis is by one of its own.
// Laws: exponents are those of doubles (one for all subnormal numbers), zeros are left out; `at` are the coordinates times
// a power of two for each level, exactly where no level spans 900 exponents, the largest between 2^-51 and 4.  Of finite
// coordinates.
// Source: docs/proof.md, "Levels".
// Cost: 2 to 5 ns; `at` a product for each coordinate.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "plumb/arith/coordinate_pairs.hpp"
#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb::certify {

/// How many axes have a level of their own.
template <Formula F>
inline constexpr std::size_t level_count = [] {
  if constexpr (TakesPoints<F> && is_homogeneous<F>) {
    if (axis_degrees<F>.equal_terms) return static_cast<std::size_t>(F::dimension);
  }
  return std::size_t{1};
}();

template <Formula F>
class Levels {
 public:
  static constexpr std::size_t count = level_count<F>;

  [[gnu::always_inline]] explicit Levels(const Coordinates<F>& p) {
    const Pairs x(p);
    std::array<Pair, count> most, least;  // of the pairs that start in each axis
    most.fill(Pair{0, 0});
    least.fill(Pair{infinity, infinity});
#pragma GCC unroll 64
    for (std::size_t i = 0; i < Pairs::count; ++i) {
      const std::size_t first = Pairs::place(i) % count;
      const Pair size = Pairs::absolute(x.pair[i]), none{0, 0};
      const Pair size_or_infinity =
          std::bit_cast<Pair>(std::bit_cast<Bits>(size) | (std::bit_cast<Bits>(size == none) & infinity_bits));
      most[first] = most[first] > size ? most[first] : size;
      least[first] = least[first] < size_or_infinity ? least[first] : size_or_infinity;
    }
    for (std::size_t axis = 0; axis < count; ++axis) {
      const std::size_t before = (axis + count - 1) % count;
      highest_[axis] = exponent(std::max(most[axis][0], most[before][1]));
      lowest_[axis] = exponent(std::min(least[axis][0], least[before][1]));
    }
  }

  /// Are all below 2^-959?  Sums of such numbers may be subnormal, which takes a hundred times as long.
  static constexpr int least_exponent = 64;
  [[nodiscard]] bool are_low() const {
    bool low = true;
    for (const int highest : highest_) low = low && highest < least_exponent;
    return low;
  }
  /// The most exponents between the numbers of one axis.
  [[nodiscard]] int span() const {
    int most = 0;
    for (std::size_t axis = 0; axis < count; ++axis) most = std::max(most, highest_[axis] - lowest_[axis]);
    return most;
  }
  /// Between all of them.
  [[nodiscard]] int span_of_all() const {
    int highest = highest_[0], lowest = lowest_[0];
    for (std::size_t axis = 1; axis < count; ++axis)
      highest = std::max(highest, highest_[axis]), lowest = std::min(lowest, lowest_[axis]);
    return highest - lowest;
  }
  [[nodiscard]] Coordinates<F> at(const Coordinates<F>& p) const {
    std::array<double, count> factor;
    for (std::size_t axis = 0; axis < count; ++axis)
      factor[axis] = std::bit_cast<double>(static_cast<std::uint64_t>(2046 - std::min(highest_[axis], 2045)) << 52);
    Coordinates<F> leveled;
    for (std::size_t i = 0; i < p.size(); ++i) leveled[i] = p[i] * factor[i % count];
    return leveled;
  }

 private:
  using Pairs = CoordinatePairs<arity<F>>;
  using Pair = typename Pairs::Pair;
  using Bits = typename Pairs::Bits;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr Bits infinity_bits{0x7ffull << 52, 0x7ffull << 52};

  static int exponent(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52); }

  std::array<int, count> highest_, lowest_;
};

/// Of low ones: times 2^1000, exactly.
template <Formula F>
Coordinates<F> raised(Coordinates<F> p) {
  for (double& x : p) x *= 0x1p1000;
  return p;
}

}  // namespace plumb::certify

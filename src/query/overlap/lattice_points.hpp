// Which integers are the corners of a pair of figures, seen from the first corner?
//
// On the lattice that all coordinates share, else on one for each axis: stretching an axis by a power of two keeps the
// signs of areas and volumes.
// Laws: where is_lattice, point i minus point 0 is exactly as told, in units of one power of two for each axis; no two
// points differ by 2^bits along an axis.  The points are given one after the other.
// Source: arith/lattice_integers.hpp.
// Cost: 1 ns for two coordinates.
#pragma once

#include <bit>

#include "arith/wrapped_number.hpp"
#include "plumb/arith/lattice_integers.hpp"
#include "query/overlap/flat_areas.hpp"

namespace plumb::query {

constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// Of areas of differences that take so many bits together doubles are exact: 6 * 2^50 < 2^53.
inline constexpr int exact_area_bits = 50;

template <std::size_t N, std::size_t D>
class LatticePoints {
 public:
  static constexpr std::size_t count = N;

  explicit LatticePoints(const std::array<double, N * D>& coordinates) {
    if (const LatticeIntegers<N * D> all(coordinates); all.bits() != 0) {
      is_lattice_ = true;
      for (std::size_t k = 0; k < D; ++k) take(all, D, k, k);
    } else {
      take_each_axis(coordinates);
    }
  }

  [[nodiscard]] bool is_lattice() const { return is_lattice_; }
  [[nodiscard]] int bits(std::size_t axis) const { return bits_[axis]; }
  [[nodiscard]] std::int64_t difference(std::size_t from, std::size_t to, std::size_t axis) const {
    return at_[to][axis] - at_[from][axis];
  }
  /// Has the point the first one's coordinate?
  [[nodiscard]] bool is_first(std::size_t i, std::size_t axis) const { return at_[i][axis] == 0; }
  /// As seen with one axis to the right and one up: made(at, told), where at(i) is a point and told makes a double of
  /// an area, of the same sign.
  template <class Make>
  [[nodiscard]] auto seen(std::size_t right, std::size_t up, const Make& made) const {
    const int bits = bits_[right] + bits_[up];
    if (bits <= exact_area_bits) {
      return made(
          [&](std::size_t i) {
            return Seen2<double>{static_cast<double>(at_[i][right]), static_cast<double>(at_[i][up])};
          },
          [](double x) { return x; });
    }
    return made(
        [&](std::size_t i) {
          return Seen2<arith::LatticeStep>{arith::LatticeStep(at_[i][right]), arith::LatticeStep(at_[i][up])};
        },
        [error = area_error(1, 1) * power_of_two(bits)](const arith::Wrapped& x) {
          return static_cast<double>(arith::settled_sign(x, error));
        });
  }
  /// How three points turn, as seen so.
  [[nodiscard]] Sign turn(std::size_t right, std::size_t up, std::size_t i, std::size_t j, std::size_t k) const {
    return seen(right, up, [&](const auto& at, const auto& told) {
      const auto p = at(i), q = at(j), r = at(k);
      return sign_of_number(told((area(p, q) + area(q, r)) - area(p, r)));
    });
  }

 private:
  [[gnu::noinline]] void take_each_axis(const std::array<double, N * D>& coordinates) {
    for (std::size_t k = 0; k < D; ++k) {
      std::array<double, N> along;
      for (std::size_t i = 0; i < N; ++i) along[i] = coordinates[D * i + k];
      if (std::ranges::all_of(along, [](double x) { return x == 0; })) {
        for (std::size_t i = 0; i < N; ++i) at_[i][k] = 0;
        bits_[k] = 0;
        continue;
      }
      const LatticeIntegers<N> all(along);
      if (all.bits() == 0) return;
      take(all, 1, 0, k);
    }
    is_lattice_ = true;
  }
  template <class Integers>
  [[gnu::always_inline]] void take(const Integers& all, std::size_t stride, std::size_t first, std::size_t axis) {
    at_[0][axis] = 0;
    for (std::size_t i = 1; i < N; ++i) at_[i][axis] = all.difference(stride * i + first, first) >> all.zeros();
    bits_[axis] = all.bits() - all.zeros() + 1;
  }

  std::array<std::array<std::int64_t, D>, N> at_;
  std::array<int, D> bits_;
  bool is_lattice_ = false;
};

/// Do all points have one coordinate there?
template <class Points>
bool is_level(const Points& points, std::size_t axis) {
  std::size_t i = 1;
  while (i < Points::count && points.is_first(i, axis)) ++i;
  return i == Points::count;
}
/// Do all points lie on one line, as seen with one axis to the right and one up?
template <class Points>
bool is_straight(const Points& points, std::size_t right, std::size_t up) {
  std::size_t far = 1;
  while (far + 1 < Points::count && points.is_first(far, right) && points.is_first(far, up)) ++far;
  std::size_t i = far + 1;
  while (i < Points::count && points.turn(right, up, 0, far, i) == Sign::zero) ++i;
  return i >= Points::count;
}

/// Of two sets of points of one line, along an axis in which that line runs: by the coordinates as given.
template <std::size_t Dimension, std::size_t N, std::size_t M>
Relation relate_straight(const std::array<double, N>& a, const std::array<double, M>& b, std::size_t axis) {
  const auto range = [axis](const auto& of) {
    double low = of[axis], high = of[axis];
    for (std::size_t i = axis; i < of.size(); i += Dimension) low = std::min(low, of[i]), high = std::max(high, of[i]);
    return ClosedRange{low, high};
  };
  return relate_ranges(range(a), range(b));
}

}  // namespace plumb::query

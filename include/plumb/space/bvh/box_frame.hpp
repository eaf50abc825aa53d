// How do doubles of any size become floats that hold them?  A power of two for a whole tree, and rounding outward.
//
// Laws: a number x stands in the frame for x 2^-exponent.  (1) below(x) is a float that is at most x in the frame, and
//       above(x) one that is at least x: infinite where no finite float is.  (2) They are the nearest such floats,
//       where x 2^-exponent is no subnormal double.  (3) Both are monotone, so min and max may be taken before or
//       after.  (4) A frame for_magnitude(m) has exponent 0 where m lies within [2^-20, 2^40]; elsewhere it brings m
//       there, or as near as doubles allow: no box of such numbers is infinite, and no area or sum of areas overflows
//       a float.
// What is rounded is compared with the double itself and moved by one float where it lies on the wrong side, so there
// is no bound to believe.
// Source: RTCD 6.6.
// Cost: below, above: a multiplication, two conversions and a comparison, without branches.  Nothing is searched.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "plumb/figure/basic/box.hpp"

namespace plumb {

/// A box in the numbers of a frame; empty where min > max.
struct FloatBox3 {
  std::array<float, 3> min, max;
  friend bool operator==(const FloatBox3&, const FloatBox3&) = default;
};

class BoxFrame {
 public:
  BoxFrame() = default;
  /// For numbers of at most this magnitude (finite).
  static BoxFrame for_magnitude(double largest);
  /// From -1000 to 1000; another exponent throws InvalidShape.
  static BoxFrame of_exponent(int exponent);

  [[nodiscard]] int exponent() const { return exponent_; }
  friend bool operator==(const BoxFrame& a, const BoxFrame& b) { return a.exponent_ == b.exponent_; }

  /// Of finite numbers.
  [[nodiscard]] float below(double x) const {
    const float f = nearest(x);
    return next(f, over(f, x) ? -1 : 0);
  }
  [[nodiscard]] float above(double x) const {
    const float f = nearest(x);
    return next(f, under(f, x) ? 1 : 0);
  }
  [[nodiscard]] FloatBox3 around(const Aabb3& box) const {
    return {{below(box.min.x), below(box.min.y), below(box.min.z)},
            {above(box.max.x), above(box.max.y), above(box.max.z)}};
  }

  /// The numbers of a box outside of the frame, rounded outward; the largest doubles for what lies beyond them.
  [[nodiscard]] Aabb3 outside(const FloatBox3& box) const;

 private:
  static constexpr double most = 0x1.fffffep127;  // of floats

  [[nodiscard]] float nearest(double x) const {
    const double scaled = x * into_;
    return static_cast<float>(scaled > most ? most : scaled < -most ? -most : scaled);
  }
  // Whichever of the two products is exact is compared: that which makes numbers larger.  Where it is infinite, so
  // large is the number that it stands for.
  [[nodiscard]] bool over(float f, double x) const { return static_cast<double>(f) * up_ > x * down_; }
  [[nodiscard]] bool under(float f, double x) const { return static_cast<double>(f) * up_ < x * down_; }

  // The next float in this direction, by the order of their bits.
  static float next(float f, std::int32_t step) {
    const auto flip = [](std::int32_t bits) { return bits ^ (bits >> 31 & 0x7fffffff); };
    return std::bit_cast<float>(flip(flip(std::bit_cast<std::int32_t>(f)) + step));
  }

  int exponent_ = 0;
  double into_ = 1, up_ = 1, down_ = 1;  // 2^-exponent; 2^exponent or 1, and 1 or 2^-exponent, neither below 1
};

}  // namespace plumb

#include "plumb/space/bvh/box_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

constexpr int least_kept = -20, most_kept = 40;  // exponents that need no frame
constexpr int most_exponent = 1000;

}  // namespace

BoxFrame BoxFrame::for_magnitude(double largest) {
  if (largest == 0) return {};
  const int exponent = std::ilogb(largest);
  if (exponent < least_kept) return of_exponent(std::max(exponent, -most_exponent));
  if (exponent >= most_kept) return of_exponent(exponent - most_kept + 1);
  return {};
}

BoxFrame BoxFrame::of_exponent(int exponent) {
  if (std::abs(exponent) > most_exponent) {
    throw InvalidShape("BoxFrame: exponent is " + std::to_string(exponent) + ", but it must lie from -1000 to 1000");
  }
  BoxFrame frame;
  frame.exponent_ = exponent;
  frame.into_ = std::ldexp(1.0, -exponent);
  frame.up_ = std::ldexp(1.0, std::max(exponent, 0));
  frame.down_ = std::ldexp(1.0, std::max(-exponent, 0));
  return frame;
}

Aabb3 BoxFrame::outside(const FloatBox3& box) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  // Where x is rounded, it is subnormal, and back in the frame it is exact again.
  const auto low = [&](float f) {
    const double x = static_cast<double>(f) / into_;
    return std::clamp(under(f, x) ? std::nextafter(x, -infinity) : x, -largest, largest);
  };
  const auto high = [&](float f) {
    const double x = static_cast<double>(f) / into_;
    return std::clamp(over(f, x) ? std::nextafter(x, infinity) : x, -largest, largest);
  };
  return {{low(box.min[0]), low(box.min[1]), low(box.min[2])}, {high(box.max[0]), high(box.max[1]), high(box.max[2])}};
}

}  // namespace plumb

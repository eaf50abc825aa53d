#include "plumb/degenerate/coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumb {

namespace {

using Limits = std::numeric_limits<double>;

constexpr std::array special_values = {
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    3.0,
    1.0 + 0x1p-52,
    1.0 - 0x1p-53,
    0.1,
    1.0 / 3,
    0x1p53,
    0x1p53 - 1,
    -0x1p53 - 2,
    0x1p26 + 1,
    -0x1p27 - 1,
    0x1p-53,
    0x1p511,
    -0x1p512,
    0x1p-537,
    0x1p-511,
    Limits::min(),
    -Limits::min(),
    Limits::min() - Limits::denorm_min(),
    Limits::denorm_min(),
    -Limits::denorm_min(),
    0x1p1023,
    -0x1p1023,
    Limits::max() * (1 - 0x1p-53),
    Limits::max(),
    -Limits::max(),
};

double integer(std::int64_t i) { return static_cast<double>(i); }

}  // namespace

double unit_coordinate(Entropy& entropy) { return integer(static_cast<std::int64_t>(entropy.bits(53))) * 0x1p-53; }

double signed_unit_coordinate(Entropy& entropy) {
  return integer(entropy.within((std::int64_t{1} << 53) - 1)) * 0x1p-53;
}

double float32_coordinate(Entropy& entropy) {
  const double mantissa = integer(entropy.within((std::int64_t{1} << 24) - 1));
  return mantissa * 0x1p-24 / integer(std::int64_t{1} << entropy.below(8));
}

double grid_coordinate(Entropy& entropy, int bits) { return integer(entropy.within((std::int64_t{1} << bits) - 1)); }

double near_half_coordinate(Entropy& entropy, std::int64_t most) {
  return 0.5 + integer(entropy.within(most)) * 0x1p-53;
}

double wide_coordinate(Entropy& entropy) {
  const double mantissa = integer(entropy.within((std::int64_t{1} << 53) - 1));
  return std::ldexp(mantissa, static_cast<int>(entropy.within(40)) - 52);
}

double special_coordinate(Entropy& entropy) { return special_values[entropy.below(special_values.size())]; }

double extreme_coordinate(Entropy& entropy) {
  switch (entropy.below(4)) {
    case 0:
      return special_coordinate(entropy);
    case 1: {  // a power of two, whose products are exact until they overflow or vanish
      const auto exponent = static_cast<int>(std::min<std::int64_t>(entropy.within(1074), 1023));
      return std::ldexp(entropy.coin() ? -1.0 : 1.0, exponent);
    }
    default: {
      const double mantissa = integer(entropy.within((std::int64_t{1} << 53) - 1));
      const auto exponent = static_cast<int>(std::min<std::int64_t>(entropy.within(1074), 1023));
      return std::ldexp(mantissa, exponent - 52);  // rounds where the value is subnormal: still a double as any other
    }
  }
}

double coordinate_of(CoordinateClass which, Entropy& entropy) {
  switch (which) {
    case CoordinateClass::grid:
      return grid_coordinate(entropy, 10);
    case CoordinateClass::unit:
      return unit_coordinate(entropy);
    case CoordinateClass::signed_unit:
      return signed_unit_coordinate(entropy);
    case CoordinateClass::float32:
      return float32_coordinate(entropy);
    case CoordinateClass::near_half:
      return near_half_coordinate(entropy, 256);
    case CoordinateClass::wide:
      return wide_coordinate(entropy);
    case CoordinateClass::special:
      return special_coordinate(entropy);
    case CoordinateClass::extreme:
      break;
  }
  return extreme_coordinate(entropy);
}

}  // namespace plumb

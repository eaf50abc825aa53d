#include "arith/root_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

BigDyadic power_of_two(long exponent) {
  BigDyadic power(1);
  while (exponent != 0) {
    const long step = std::clamp(exponent, -1000L, 1000L);
    power = power * BigDyadic(std::ldexp(1.0, static_cast<int>(step)));
    exponent -= step;
  }
  return power;
}

// Consecutive doubles of pi.
constexpr double kPi = 0x1.921fb54442d18p+1, kPi2 = 0x1.1a62633145c07p-53, kPi3 = -0x1.f1976b7ed8fbcp-109,
                 kPi4 = 0x1.4cf98e804177dp-163;

}  // namespace

BigBounds root_bounds(const BigDyadic& x) {
  if (x.sign() == Sign::zero) return {};
  const long top = x.exponent() + static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2));
  const long half = (top - (top & 1)) / 2;
  const BigDyadic one(1), scaled = x * power_of_two(-2 * half);  // in [1/2, 2)
  const BigDyadic first(rounded_root(Rounding::down, scaled, one)), last(rounded_root(Rounding::up, scaled, one));
  const BigDyadic rest = scaled - first * first, scale = power_of_two(half);
  // The root is first + rest / (first + root), and root lies between these doubles.
  const BigDyadic less(rounded_quotient(Rounding::down, rest, first + last));
  const BigDyadic more(rounded_quotient(Rounding::up, rest, first + first));
  return {(first + less) * scale, (first + more) * scale};
}

BigBounds pi_bounds() {
  const BigDyadic near = BigDyadic(kPi) + BigDyadic(kPi2) + BigDyadic(kPi3) + BigDyadic(kPi4);
  const BigDyadic error(0x1p-215);
  return {near - error, near + error};
}

Ball pi_ball() { return {kPi, kPi2, 0x1p-108}; }

Ball ball_around(const BigBounds& bounds) {
  if (bounds.upper.sign() == Sign::zero) return Ball{0.0};
  const double high = rounded(Rounding::nearest, bounds.lower);
  if (!(high < Ball::infinity)) return {high, 0, Ball::infinity};
  const double low = rounded(Rounding::nearest, bounds.lower - BigDyadic(high));
  const BigDyadic taken = BigDyadic(high) + BigDyadic(low);
  return {high, low,
          std::max(rounded(Rounding::up, bounds.upper - taken), rounded(Rounding::up, taken - bounds.lower))};
}

}  // namespace plumb

#include "radial_number.hpp"

#include <bit>
#include <cstdint>
#include <limits>

namespace plumb::radial {
namespace {

/// The sign of K + W / sqrt(D) - x.
Sign compare(const Parts<BigDyadic>& p, const BigDyadic& x) {
  const BigDyadic rest = p.k - x;
  const Sign straight = rest.sign(), round = p.w.sign();
  if (straight == round || round == Sign::zero) return straight;
  if (straight == Sign::zero) return round;
  return straight * (rest * rest * p.d - p.w * p.w).sign();
}

/// Doubles in order: the number of steps from zero.
double at(std::int64_t step) {
  const double x = std::bit_cast<double>(static_cast<std::uint64_t>(step < 0 ? -step : step));
  return step < 0 ? -x : x;
}

}  // namespace

double rounded_exactly(Rounding rounding, const Parts<BigDyadic>& p) {
  constexpr double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  constexpr auto last = std::bit_cast<std::int64_t>(most);
  const BigDyadic half(0.5);
  // Half a step beyond the largest double, where rounding to nearest ends in infinity: 2^1024 - 2^970.
  const BigDyadic overflow = BigDyadic(most) + BigDyadic(0x1p970);
  if (compare(p, BigDyadic(most)) == Sign::positive) {
    if (rounding == Rounding::down) return most;
    return rounding == Rounding::up || compare(p, overflow) != Sign::negative ? infinity : most;
  }
  if (compare(p, BigDyadic(-most)) == Sign::negative) {
    if (rounding == Rounding::up) return -most;
    const BigDyadic underflow = BigDyadic(0.0) - overflow;
    return rounding == Rounding::down || compare(p, underflow) != Sign::positive ? -infinity : -most;
  }
  // The value is at low or beyond, and before high + 1; halves of the doubles, so that differences fit.
  const bool negative = compare(p, BigDyadic(0.0)) == Sign::negative;
  std::int64_t low = negative ? -last : 0, high = negative ? -1 : last;
  while (low < high) {
    const std::int64_t middle = low + (high - low + 1) / 2;
    if (compare(p, BigDyadic(at(middle))) == Sign::negative) {
      high = middle - 1;
    } else {
      low = middle;
    }
  }
  const double below = at(low);
  if (rounding == Rounding::down || compare(p, BigDyadic(below)) == Sign::zero) return below;
  const double above = at(low + 1);
  if (rounding == Rounding::up) return above;
  const Sign s = compare(p, half * (BigDyadic(below) + BigDyadic(above)));
  if (s == Sign::zero) return low % 2 == 0 ? below : above;
  return s == Sign::negative ? below : above;
}

}  // namespace plumb::radial

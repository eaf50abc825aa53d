// Which doubles try a number type hardest?  The edges of the format and random ones of every exponent.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/degenerate.hpp"

namespace plumb::samples {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Zeros, ones, halves and neighbors; powers of two at every edge that a proof mentions; the largest and the smallest.
inline std::vector<double> special_values() {
  std::vector<double> all{0.0, 0.1, 1.0 / 3, 0x1p53 - 1, 0x1p27 + 1};
  for (const int exponent : {-1074, -1073, -1023, -1022, -1021, -961, -960, -537, -511, -53,  -1,  0,
                             1,     52,    53,    511,   512,   959,  960,  961,  1021, 1022, 1023}) {
    const double power = std::ldexp(1.0, exponent);
    all.insert(all.end(), {moved_by_ulps(power, -1), power, moved_by_ulps(power, 1)});
  }
  all.push_back(std::numeric_limits<double>::max());
  for (std::size_t i = all.size(); i-- > 0;) all.push_back(-all[i]);
  return all;
}

/// A double of any exponent and mantissa, or near another one's negative, so that sums cancel.
inline double any_double(Entropy& entropy, double other = 0) {
  switch (entropy.below(4)) {
    case 0:
      return moved_by_ulps(-other, entropy.within(4));
    case 1:
      return wide_coordinate(entropy);
    default:
      return extreme_coordinate(entropy);
  }
}

inline mpq_class rational(double x) { return mpq_class(x); }

/// 2^exponent.
inline mpq_class power_of_two(int exponent) {
  mpq_class r = 1;
  if (exponent < 0) {
    mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  return r;
}

}  // namespace plumb::samples

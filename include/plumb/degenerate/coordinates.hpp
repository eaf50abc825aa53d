// What numbers do hard inputs hold?  One coordinate of each class.
//
// Laws: every value is finite; the choice 0 gives the simplest value of the class (0.0 wherever the class holds it).
// Source: the input classes of the project's measurements; the grid around 0.5 is Kettner, Mehlhorn, Pion, Schirra and
// Yap, "Classroom examples of robustness problems in geometric computations".
// Cost: a few ns each.
#pragma once

#include "plumb/degenerate/entropy.hpp"

namespace plumb {

/// Uniform in [0, 1): a multiple of 2^-53.
double unit_coordinate(Entropy& entropy);

/// Uniform in (-1, 1): a multiple of 2^-53.
double signed_unit_coordinate(Entropy& entropy);

/// A float32 in (-1, 1), its scale from 1 down to 2^-7.
double float32_coordinate(Entropy& entropy);

/// An integer of at most `bits` bits and a sign, for bits in [1, 53].
double grid_coordinate(Entropy& entropy, int bits);

/// 0.5 + k 2^-53 with |k| <= most <= 2^51: neighbors of one half, whose differences are exact and tiny.
double near_half_coordinate(Entropy& entropy, std::int64_t most);

/// A 53-bit mantissa and an exponent in [-40, 40].
double wide_coordinate(Entropy& entropy);

/// One of the numbers at the edges of the format: zeros, ones and their neighbors, smallest, largest, powers of two.
double special_coordinate(Entropy& entropy);

/// Any exponent that a double can have, subnormals included; a special one at times.
double extreme_coordinate(Entropy& entropy);

/// The classes above, for inputs that mix them.
enum class CoordinateClass { grid, unit, signed_unit, float32, near_half, wide, special, extreme };

inline constexpr int coordinate_class_count = 8;

double coordinate_of(CoordinateClass which, Entropy& entropy);

}  // namespace plumb

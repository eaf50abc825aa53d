// Which of the two doubles beside a real number stands for it?  Numbers are rounded to the nearest, bounds outward.
//
// Source: IEEE 754-2019, 4.3.
// Cost: none.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// To the largest double not above, to the nearest (ties to even), to the smallest not below.
enum class Rounding : signed char { down = -1, nearest = 0, up = 1 };

/// What rounding the negative number must be, for the number to be rounded so.
constexpr Rounding operator-(Rounding r) { return static_cast<Rounding>(-static_cast<int>(r)); }

}  // namespace plumb

// Overflow and NaN end in the next stage only where the compiler believes that they exist.
// refused: -ffinite-math-only removes
// flags: -ffinite-math-only
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

// The part of -ffast-math that people ask for alone.
// refused: -fassociative-math .* reorders the sums
// flags: -funsafe-math-optimizations
// said by: GCC
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

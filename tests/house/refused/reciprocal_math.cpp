// A quotient by way of a reciprocal is rounded twice.
// refused: -freciprocal-math .* rounds a quotient twice
// flags: -freciprocal-math
// said by: GCC
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

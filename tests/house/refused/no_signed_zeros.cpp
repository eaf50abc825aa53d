// An answer of -0 has the bits of -0.
// refused: -fno-signed-zeros .* changes the bits
// flags: -fno-signed-zeros
// said by: GCC
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

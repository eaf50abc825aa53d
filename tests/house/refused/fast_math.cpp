// -ffast-math takes away what the proofs rest on.
// refused: -ffast-math breaks the proofs
// flags: -ffast-math
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

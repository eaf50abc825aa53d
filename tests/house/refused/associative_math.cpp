// The errors of a sum, which the proofs take apart, are zero where the compiler may reorder it.
// refused: -fassociative-math .* reorders the sums
// flags: -fassociative-math -fno-signed-zeros -fno-trapping-math
// said by: GCC
#include "plumb/predicates.hpp"

plumb::Sign turn(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) { return plumb::orient2d(a, b, c); }

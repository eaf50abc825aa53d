// A NaN in a coordinate that nothing looks at would pass unseen.
// refused: plumb: a formula does not use one of its coordinates
// lines: 12
#include "plumb/predicates.hpp"

plumb::Sign sign(plumb::Point2 p, plumb::Point2 q) {
#ifdef MENDED
  return plumb::sign_of([](auto ax, auto ay, auto bx, auto by) { return ax * by - ay * bx; }, p, q);
#else
  return plumb::sign_of([](auto ax, auto ay, auto bx, auto) { return ax * ay - bx * bx; }, p, q);
#endif
}

// The stages make the lambda anew: it has nothing but its arguments.
// refused: plumb: a polynomial is a formula or a lambda without captures
// lines: 12
#include "plumb/plumb.hpp"

plumb::Sign sign(double x, double y) {
#ifdef MENDED
  return plumb::sign_of([](auto a, auto b, auto k) { return k * a - b * b; }, x, y, 2.5);
#else
  return plumb::sign_of([&](auto a, auto b) { return x * a - b * b; }, x, y);
#endif
}

// A tenth is no double, and no whole number: integers could not carry it.
// refused: plumb: a formula multiplies by whole numbers
// lines: 12
#include "plumb/certify/sign_of.hpp"

plumb::Sign sign(double x, double y) {
#ifdef MENDED
  return plumb::sign_of([](auto a, auto b) { return a - 10.0 * b; }, x, y);
#else
  return plumb::sign_of([](auto a, auto b) { return 0.1 * a - b; }, x, y);
#endif
}

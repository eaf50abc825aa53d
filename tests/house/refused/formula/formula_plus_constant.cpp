// A constant term has no degree: it scales with an argument of its own.
// refused: plumb: a formula adds no constants
// lines: 12
#include "plumb/query.hpp"

plumb::Sign sign(double x, double y) {
#ifdef MENDED
  return plumb::sign_of([](auto a, auto b, auto one) { return a * a + b * b - one * one; }, x, y, 1.0);
#else
  return plumb::sign_of([](auto a, auto b) { return a * a + b * b - 1.0; }, x, y);
#endif
}

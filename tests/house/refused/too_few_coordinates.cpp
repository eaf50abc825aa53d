// A polynomial of three coordinates has no sign at two.
// refused: plumb: the polynomial takes another number of coordinates
// lines: 12
#include "plumb/predicates.hpp"

plumb::Sign sign(double x, double y) {
#ifdef MENDED
  return plumb::sign_of([](auto a, auto b) { return a * b - b * b; }, x, y);
#else
  return plumb::sign_of([](auto a, auto b, auto c) { return a * b - c * c; }, x, y);
#endif
}

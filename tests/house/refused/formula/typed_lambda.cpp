// A lambda of doubles would round: it is run over other numbers.
// refused: plumb: the polynomial takes another number of coordinates
// lines: 12
#include "plumb/predicates.hpp"

plumb::Sign sign(double x, double y) {
#ifdef MENDED
  return plumb::sign_of([](auto a, auto b) { return a * b - b * b; }, x, y);
#else
  return plumb::sign_of([](double a, double b) { return a * b - b * b; }, x, y);
#endif
}

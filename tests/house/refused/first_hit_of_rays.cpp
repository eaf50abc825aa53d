// Two rays hit nothing; what they share is their intersection.
// refused: plumb: first_hit takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Ray3& a, const plumb::Ray3& b) {
#ifdef MENDED
  return plumb::intersection(a, b);
#else
  return plumb::first_hit(a, b);
#endif
}

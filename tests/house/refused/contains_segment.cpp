// A segment is asked by its ends.
// refused: plumb: contains takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Segment3& b) {
#ifdef MENDED
  return plumb::contains(a, b.a);
#else
  return plumb::contains(a, b);
#endif
}

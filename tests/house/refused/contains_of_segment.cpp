// A segment is asked whether it holds points alone.
// refused: plumb: contains takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Segment3& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::contains(a, b.center);
#else
  return plumb::contains(a, b);
#endif
}

// A circle in space is no figure here.
// refused: plumb: intersection takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::relate(a, b);
#else
  return plumb::intersection(a, b);
#endif
}

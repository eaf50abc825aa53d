// A point of the plane has no place in space.
// refused: plumb: distance takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Point2& a, const plumb::Point3& b) {
#ifdef MENDED
  return plumb::distance(a, plumb::Point2{b.x, b.y});
#else
  return plumb::distance(a, b);
#endif
}

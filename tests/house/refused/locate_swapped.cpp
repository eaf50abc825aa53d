// The figure comes first, then the point.
// refused: plumb: locate takes a figure and then a point
#include "plumb/plumb.hpp"

auto ask(const plumb::Point3& p, const plumb::Sphere3& ball) {
#ifdef MENDED
  return plumb::locate(ball, p);
#else
  return plumb::locate(p, ball);
#endif
}

// A point of the plane has no height.
// refused: plumb: orient3d takes four Point3
#include "plumb/predicates.hpp"

auto ask(const plumb::Point3& a, const plumb::Point2& b) {
#ifdef MENDED
  return plumb::orient3d(a, a, a, plumb::Point3{b.x, b.y, 0});
#else
  return plumb::orient3d(a, a, a, b);
#endif
}

// A cylinder has no distance.
// refused: plumb: compare_distance takes
#include "plumb/plumb.hpp"

auto ask(const plumb::Cylinder3& a, const plumb::Point3& b) {
#ifdef MENDED
  return plumb::compare_distance(a.a, b, 3.0);
#else
  return plumb::compare_distance(a, b, 3.0);
#endif
}

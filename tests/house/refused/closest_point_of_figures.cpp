// A point has a closest point, a figure has closest points.
// refused: plumb: closest_point takes
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Aabb3& b) {
#ifdef MENDED
  return plumb::closest_points(a, b);
#else
  return plumb::closest_point(a, b);
#endif
}

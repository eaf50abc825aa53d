// A point of the plane is in no polygon of space.
// refused: plumb: contains takes
#include "plumb/query.hpp"

auto ask(const plumb::Polygon3& polygon, const plumb::Point2& p) {
#ifdef MENDED
  return plumb::contains(polygon, plumb::Point3{p.x, p.y, 0});
#else
  return plumb::contains(polygon, p);
#endif
}

// A vector is no point.
// refused: plumb: convex_hull takes a span or vector of Point2 or Point3
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Vector3>& a) {
#ifdef MENDED
  return plumb::convex_hull(std::vector{plumb::Point3{a[0].x, a[0].y, a[0].z}});
#else
  return plumb::convex_hull(a);
#endif
}

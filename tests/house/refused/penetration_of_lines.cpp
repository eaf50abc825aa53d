// A line is no body.
// refused: plumb: penetration takes two convex bodies
#include "plumb/plumb.hpp"

auto ask(const plumb::Line3& a, const plumb::Aabb3& b) {
#ifdef MENDED
  return plumb::penetration(plumb::Segment3{a.point, a.point}, b);
#else
  return plumb::penetration(a, b);
#endif
}

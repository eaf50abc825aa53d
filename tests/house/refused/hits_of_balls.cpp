// A ball is no ray.
// refused: plumb: hits takes a line, ray or segment
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::intersects(a, b);
#else
  return plumb::hits(a, b);
#endif
}

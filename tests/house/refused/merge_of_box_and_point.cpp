// A box and a point are merged as two boxes.
// refused: plumb: merge takes two bounds
#include "plumb/plumb.hpp"

auto ask(const plumb::Aabb3& a, const plumb::Point3& p) {
#ifdef MENDED
  return plumb::merge(a, plumb::Aabb3{p, p});
#else
  return plumb::merge(a, p);
#endif
}

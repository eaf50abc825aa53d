// A point is no vector.
// refused: plumb: no operator == of a point and a vector
#include "plumb/plumb.hpp"

auto make(const plumb::Point3& p, const plumb::Vector3& v) {
#ifdef MENDED
  return p == plumb::Point3{v.x, v.y, v.z};
#else
  return p == v;
#endif
}

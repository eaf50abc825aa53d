// What is made of points is rounded, and says so.
// refused: plumb: no operator - of points and vectors: rounded_difference
#include "plumb/plumb.hpp"

auto make(const plumb::Point3& p, const plumb::Point3& q) {
#ifdef MENDED
  return plumb::rounded_difference(p, q);
#else
  return p - q;
#endif
}

// A difference of points would be rounded.
// refused: plumb: - has no place .*rounded_difference
#include "plumb/plumb.hpp"

auto ask(const plumb::Point3& a, const plumb::Point3& b) {
#ifdef MENDED
  return plumb::rounded_difference(a, b);
#else
  return a - b;
#endif
}

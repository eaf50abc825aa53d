// A sum would be rounded.
// refused: plumb: [+] has no place .*rounded_sum
#include "plumb/plumb.hpp"

auto ask(const plumb::Point3& a, const plumb::Vector3& v) {
#ifdef MENDED
  return plumb::rounded_sum(a, v);
#else
  return a + v;
#endif
}

// A quotient is rounded, and says so.
// refused: plumb: no operator / of a vector and a number: rounded_multiple
#include "plumb/plumb.hpp"

auto make(const plumb::Vector3& v) {
#ifdef MENDED
  return plumb::rounded_multiple(1.0 / 3, v);
#else
  return v / 3;
#endif
}

// A whole number times a vector is a product of doubles.
// refused: plumb: no operator . of a number and a vector: rounded_multiple
#include "plumb/plumb.hpp"

auto make(const plumb::Vector3& v) {
#ifdef MENDED
  return plumb::rounded_multiple(2, v);
#else
  return 2 * v;
#endif
}

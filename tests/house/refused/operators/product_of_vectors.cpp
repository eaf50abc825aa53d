// Which product is meant?
// refused: plumb: no operator . of two vectors: rounded_dot
#include "plumb/plumb.hpp"

auto make(const plumb::Vector3& v, const plumb::Vector3& w) {
#ifdef MENDED
  return plumb::rounded_dot(v, w);
#else
  return v * w;
#endif
}

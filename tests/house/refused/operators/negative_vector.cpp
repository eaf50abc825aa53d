// The one that is exact has a name as well.
// refused: plumb: no operator - of a vector: negated
#include "plumb/plumb.hpp"

auto make(const plumb::Vector3& v) {
#ifdef MENDED
  return plumb::negated(v);
#else
  return -v;
#endif
}

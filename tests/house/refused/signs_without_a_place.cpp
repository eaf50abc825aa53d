// Many signs need a place to be written to.
// refused: plumb: orient2d takes .* and a span of Sign to write to
#include "plumb/predicates.hpp"

auto ask(std::span<const plumb::Point2> a) {
#ifdef MENDED
  return plumb::orient2d(a[0], a[1], a[2]);
#else
  return plumb::orient2d(a, a, a);
#endif
}

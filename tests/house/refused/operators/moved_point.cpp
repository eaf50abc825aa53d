// What is made of points is rounded, and says so.
// refused: plumb: no operator . of points and vectors: rounded_sum
#include "plumb/plumb.hpp"

auto make(const plumb::Point2& p, const plumb::Vector2& v) {
#ifdef MENDED
  return plumb::rounded_sum(p, v);
#else
  return p + v;
#endif
}

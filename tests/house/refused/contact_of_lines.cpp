// What goes on without an end is no body.
// refused: plumb: contact takes two convex bodies of space
#include "plumb/plumb.hpp"

auto ask(const plumb::Line3& line, const plumb::Sphere3& ball) {
#ifdef MENDED
  return plumb::contact(plumb::Segment3{line.point, {0, 0, 0}}, ball);
#else
  return plumb::contact(line, ball);
#endif
}

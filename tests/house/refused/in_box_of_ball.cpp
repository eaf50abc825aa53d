// What is in a ball is within a radius.
// refused: plumb: in_box takes an index of points or figures and then an Aabb2 or Aabb3
#include "plumb/plumb.hpp"

auto ask(const plumb::KdTree<plumb::Point3>& tree, const plumb::Sphere3& ball) {
#ifdef MENDED
  return plumb::within(tree, ball.center, ball.radius);
#else
  return plumb::in_box(tree, ball);
#endif
}

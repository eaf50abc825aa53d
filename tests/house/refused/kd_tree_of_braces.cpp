// Braces alone do not say of which space.
// refused: plumb: build_kd_tree takes a span or vector of Point2 or Point3
#include "plumb/plumb.hpp"

auto ask() {
#ifdef MENDED
  return plumb::build_kd_tree(std::vector<plumb::Point3>{{0, 0, 0}, {1, 1, 1}});
#else
  return plumb::build_kd_tree({{0, 0, 0}, {1, 1, 1}});
#endif
}

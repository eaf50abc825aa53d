// Braces do not say of which points.
// refused: plumb: build_kd_tree is not told of which points
#include "plumb/plumb.hpp"

auto tree() {
#ifdef MENDED
  return plumb::build_kd_tree(std::vector<plumb::Point3>{{0, 0, 0}, {1, 1, 1}});
#else
  return plumb::build_kd_tree({{0, 0, 0}, {1, 1, 1}});
#endif
}

// Points are searched by their tree.
// refused: plumb: nearest takes an index, .*build_kd_tree
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Point3>& points, const plumb::Point3& p) {
#ifdef MENDED
  return plumb::nearest(plumb::build_kd_tree(points), p);
#else
  return plumb::nearest(points, p);
#endif
}

// A k-d tree is of points.
// refused: plumb: build_kd_tree takes .*of figures build_figure_tree
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Sphere3>& balls, const std::vector<plumb::Point3>& points) {
#ifdef MENDED
  return (void)balls, plumb::build_kd_tree(points);
#else
  return (void)points, plumb::build_kd_tree(balls);
#endif
}

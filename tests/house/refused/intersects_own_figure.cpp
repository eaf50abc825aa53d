// The tables know the figures that docs/add_a_figure.md makes known to them.
// refused: plumb: intersects takes two figures
#include "plumb/plumb.hpp"

struct Wedge {
  std::array<plumb::Point3, 6> corners;
};

auto ask(const Wedge& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::gjk_intersects(plumb::VertexHull3{a.corners}, b);
#else
  return plumb::intersects(a, b);
#endif
}

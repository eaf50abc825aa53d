// What is not the library's is known by its farthest points.
// refused: plumb: gjk takes .*gjk_bounds
#include "plumb/plumb.hpp"

struct Wedge {
  std::array<plumb::Point3, 6> corners;
};

auto ask(const Wedge& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::gjk(plumb::VertexHull3{a.corners}, b);
#else
  return plumb::gjk(a, b);
#endif
}

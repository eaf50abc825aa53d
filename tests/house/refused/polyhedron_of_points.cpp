// A hull says which faces the points have.
// refused: plumb: convex_polyhedron takes .*convex_hull
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Point3>& points) {
#ifdef MENDED
  return plumb::convex_polyhedron(plumb::convex_hull(points), points);
#else
  return plumb::convex_polyhedron(points);
#endif
}

// A mesh is many triangles.
// refused: plumb: closest_points takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& a, const plumb::Point3& b) {
#ifdef MENDED
  return plumb::closest_points(b, plumb::Triangle3{a.vertices[0], a.vertices[1], a.vertices[2]});
#else
  return plumb::closest_points(a, b);
#endif
}

// A mesh is many triangles.
// refused: plumb: intersects takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& a, const plumb::Sphere3& b) {
#ifdef MENDED
  return plumb::intersects(a.vertices[0], b);
#else
  return plumb::intersects(a, b);
#endif
}

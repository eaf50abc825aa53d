// A mesh is many triangles.
// refused: plumb: relate takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& a, const plumb::TriangleMesh& b) {
#ifdef MENDED
  return plumb::relate(plumb::Triangle3{a.vertices[0], a.vertices[1], a.vertices[2]}, b.vertices[0]);
#else
  return plumb::relate(a, b);
#endif
}

// A file has a name.
// refused: plumb: write_mesh takes a path
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& mesh) {
#ifdef MENDED
  return plumb::write_mesh("part.stl", mesh);
#else
  return plumb::write_mesh(mesh);
#endif
}

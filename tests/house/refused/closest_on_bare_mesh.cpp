// A mesh is searched by its tree.
// refused: plumb: closest_on_mesh takes .*build_bvh
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& mesh, const plumb::Point3& p) {
#ifdef MENDED
  return plumb::closest_on_mesh(plumb::build_bvh(mesh), p);
#else
  return plumb::closest_on_mesh(mesh, p);
#endif
}

// A mesh is searched by its tree.
// refused: plumb: intersecting_pairs takes .*build_bvh
#include "plumb/plumb.hpp"

auto ask(const plumb::TriangleMesh& a, const plumb::TriangleMesh& b) {
#ifdef MENDED
  return plumb::intersecting_pairs(plumb::build_bvh(a), plumb::build_bvh(b));
#else
  return plumb::intersecting_pairs(a, b);
#endif
}

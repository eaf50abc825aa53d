// Two meshes have many pairs of triangles.
// refused: plumb: relate takes .*intersecting_pairs
#include "plumb/plumb.hpp"

auto ask(const plumb::Bvh& a, const plumb::Bvh& b) {
#ifdef MENDED
  return plumb::intersecting_pairs(a, b);
#else
  return plumb::relate(a, b);
#endif
}

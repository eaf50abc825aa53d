// The tree comes first, then the ray.
// refused: plumb: first_hit takes a line, ray or segment and then
#include "plumb/plumb.hpp"

auto ask(const plumb::Bvh& mesh, const plumb::Ray3& ray) {
#ifdef MENDED
  return plumb::first_hit(mesh, ray);
#else
  return plumb::first_hit(ray, mesh);
#endif
}

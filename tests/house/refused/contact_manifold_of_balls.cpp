// Balls touch at a point, which closest_points tells.
// refused: plumb: contact_manifold takes convex bodies of space that are not round
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::VertexHull3& b) {
#ifdef MENDED
  return plumb::contact_manifold(plumb::VertexHull3{{&a.center, 1}}, b);
#else
  return plumb::contact_manifold(a, b);
#endif
}

// The triangle comes first, then the point.
// refused: plumb: barycentric takes a segment, triangle or tetrahedron and then a point
#include "plumb/plumb.hpp"

auto ask(const plumb::Point3& p, const plumb::Triangle3& triangle) {
#ifdef MENDED
  return plumb::barycentric(triangle, p);
#else
  return plumb::barycentric(p, triangle);
#endif
}

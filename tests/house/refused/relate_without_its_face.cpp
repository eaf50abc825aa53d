// The figures alone do not answer: the sentence names the face.
// refused: plumb: relate takes .*plumb/query.hpp
#include "plumb/figure.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Aabb3& b) {
#ifdef MENDED
  return plumb::contains(b, a.center);
#else
  return plumb::relate(a, b);
#endif
}

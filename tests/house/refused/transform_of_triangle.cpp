// A figure stands under a pose without being rounded.
// refused: plumb: transform takes a bound
#include "plumb/plumb.hpp"

auto ask(const plumb::Triangle3& a, const plumb::Pose& pose) {
#ifdef MENDED
  return plumb::relate(plumb::Posed{a, pose}, a);
#else
  return plumb::transform(a, pose);
#endif
}

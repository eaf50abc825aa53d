// The direction comes first.
// refused: plumb: maximize takes .*maximize.direction, halfspaces
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Halfspace3>& planes, const plumb::Vector3& v) {
#ifdef MENDED
  return plumb::maximize(v, planes);
#else
  return plumb::maximize(planes, v);
#endif
}

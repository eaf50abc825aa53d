// Nothing moves.
// refused: plumb: first_contact_time takes
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Aabb3& b) {
#ifdef MENDED
  return plumb::first_contact_time(plumb::Translating<plumb::Sphere3>{a, {1, 0, 0}}, b);
#else
  return plumb::first_contact_time(a, b);
#endif
}

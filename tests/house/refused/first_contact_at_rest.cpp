// Nothing moves.
// refused: plumb: first_contact takes
// lines: 12
#include "plumb/plumb.hpp"

auto ask(const plumb::Sphere3& a, const plumb::Point3& b) {
#ifdef MENDED
  return plumb::first_contact(plumb::Translating<plumb::Sphere3>{a, {1, 0, 0}}, b);
#else
  return plumb::first_contact(a, b);
#endif
}

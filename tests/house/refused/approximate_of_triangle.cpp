// What is given in doubles is not approximated.
// refused: plumb: approximate takes what is known exactly
#include "plumb/plumb.hpp"

auto ask(const plumb::Triangle3& t) {
#ifdef MENDED
  return plumb::approximate(plumb::Posed{t.a, plumb::identity_pose});
#else
  return plumb::approximate(t);
#endif
}

// Undecided is no sign, least of all zero.
// refused: cannot convert|could not convert|no viable conversion
#include "plumb/arith/sign.hpp"

plumb::Sign taken(plumb::Unsure<plumb::Sign> turn) {
#ifdef MENDED
  return turn.value();
#else
  return turn;
#endif
}

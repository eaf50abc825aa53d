// Is it decided, or is it positive?  A bool would not say which.
// refused: could not convert|cannot convert|is not contextually convertible
#include "plumb/arith/sign.hpp"

bool decided(plumb::Unsure<plumb::Sign> turn) {
#ifdef MENDED
  if (turn.certain()) return true;
#else
  if (turn) return true;
#endif
  return false;
}

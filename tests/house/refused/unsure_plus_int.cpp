// An answer that may be missing is no number.
// refused: no match for|invalid operands
#include "plumb/arith/sign.hpp"

int left_turns(plumb::Unsure<plumb::Sign> turn, int so_far) {
#ifdef MENDED
  return turn.certain() && turn.value() == plumb::Sign::positive ? so_far + 1 : so_far;
#else
  return turn + so_far;
#endif
}

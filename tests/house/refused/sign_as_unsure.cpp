// A sign becomes an answer only where it is said to be one: a stage cannot claim certainty by a slip.
// refused: could not convert|cannot convert|no viable conversion
#include "plumb/arith/sign.hpp"

plumb::Unsure<plumb::Sign> stage() {
#ifdef MENDED
  return plumb::Unsure<plumb::Sign>(plumb::Sign::zero);
#else
  return plumb::Sign::zero;
#endif
}

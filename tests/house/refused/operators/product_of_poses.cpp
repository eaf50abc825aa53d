// Poses are composed by name, and rounded.
// refused: plumb: no operator . of poses: rounded_composition
#include "plumb/plumb.hpp"

auto make(const plumb::Pose& a, const plumb::Pose& b) {
#ifdef MENDED
  return plumb::rounded_composition(a, b);
#else
  return a * b;
#endif
}

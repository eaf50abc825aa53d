// Three points make a turn.
// refused: plumb: the polynomial takes another number of coordinates
// lines: 12
#include "plumb/predicates.hpp"

plumb::Sign sign(plumb::Point2 p, plumb::Point2 q) {
#ifdef MENDED
  return plumb::sign_of(plumb::predicates::Orient2d{}, p, q, p);
#else
  return plumb::sign_of(plumb::predicates::Orient2d{}, p, q);
#endif
}

// Many cases at once need a place for their signs.
// refused: plumb: sign_of takes points, vectors, numbers
// lines: 12
#include "plumb/predicates.hpp"

plumb::Sign sign(std::span<const plumb::Point2> p) {
#ifdef MENDED
  return plumb::sign_of(plumb::predicates::Orient2d{}, p[0], p[1], p[2]);
#else
  return plumb::sign_of(plumb::predicates::Orient2d{}, p, p, p);
#endif
}

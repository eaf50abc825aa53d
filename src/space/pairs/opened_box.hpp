// Which points overlap a box: those between its sides, and of an axis along which it is flat those on it?
#pragma once

#include <cmath>

#include "plumb/figure/basic/box.hpp"

namespace plumb::space {

/// The closed box of the doubles that are strictly between the ends, and those alone; where both are the same, of that
/// one.  Inverted where there are none.
inline void open_ends(double& low, double& high) {
  if (!(low < high)) return;
  const double from = std::nextafter(low, high), to = std::nextafter(high, low);
  low = from, high = to;
}

/// A point p, as the box from p to p, overlaps the box where this one holds it, as doubles are all that p can be.
inline Aabb2 opened(Aabb2 box) {
  open_ends(box.min.x, box.max.x), open_ends(box.min.y, box.max.y);
  return box;
}
inline Aabb3 opened(Aabb3 box) {
  open_ends(box.min.x, box.max.x), open_ends(box.min.y, box.max.y), open_ends(box.min.z, box.max.z);
  return box;
}

}  // namespace plumb::space

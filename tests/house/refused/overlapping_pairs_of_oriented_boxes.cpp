// Boxes along the axes are sorted, others are not.
// refused: plumb: overlapping_pairs takes
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Obb3>& boxes) {
#ifdef MENDED
  return plumb::overlapping_pairs(std::vector{plumb::fit_aabb(boxes[0]), plumb::fit_aabb(boxes[1])});
#else
  return plumb::overlapping_pairs(boxes);
#endif
}

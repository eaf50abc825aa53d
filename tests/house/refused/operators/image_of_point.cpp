// The image of a point is rounded, and says so.
// refused: plumb: no operator . of poses: .*rounded_image
#include "plumb/plumb.hpp"

auto make(const plumb::Pose2& pose, const plumb::Point2& p) {
#ifdef MENDED
  return plumb::rounded_image(pose, p);
#else
  return pose * p;
#endif
}

// How do segments join into contours?
//
// Laws: a contour passes each corner once; contours that touch do not cross, where the segments do not.
// Cost: linear in the segments; where more than two meet, they are sorted around their corner.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/section/cut_corners.hpp"
#include "surface/section/cut_segments.hpp"

namespace plumb::surface {

struct CutContour {
  std::vector<std::uint32_t> corners;
  bool closed;
};

/// Also counts the corners in which more than two segments meet.
std::vector<CutContour> join_segments(const CutSegments& cut, const CutCorners& corners, std::uint64_t& touching);

}  // namespace plumb::surface

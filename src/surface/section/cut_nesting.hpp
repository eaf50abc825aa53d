// Which contours turn which way, and which lies in which?
//
// Laws: exact; those of contours that do not cross.  A contour lies in another where its box lies in the other's, and
// the other winds around its first point that is off the other; two that are the same closed curve lie in one another
// by their order, the later in the former.  The parent of a contour is the deepest of those around it.
// Cost: n log n in the corners, and for each pair whose boxes lie in each other a step for each edge of the outer
// contour that lies near the height of a corner of the inner one, right of it, and a logarithm.
#pragma once

#include <span>
#include <vector>

#include "surface/section/cut_contours.hpp"
#include "surface/section/cut_corners.hpp"

namespace plumb::surface {

/// Fills in `turn`, `parent` and `depth` of the contours, whose corners `joined` names.
void nest_contours(std::span<const CutContour> joined, const CutCorners& corners, std::span<Contour> contours);

}  // namespace plumb::surface

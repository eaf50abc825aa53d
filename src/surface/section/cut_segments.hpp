// Slicing: which segments does a plane cut out of triangles, and between which points?
//
// Laws: a triangle with vertices on both sides gives one segment, which has the solid to its left seen from the
// normal's side; corners that are the same point are one; no segment begins where it ends, and none runs against
// another between the same corners.
// Cost: n log n in the triangles that are cut.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/surface/section/section.hpp"
#include "surface/section/cut_plane.hpp"
#include "surface/section/plane_sweep.hpp"

namespace plumb::surface {

struct CutSegments {
  std::vector<SectionCorner> corners;
  std::vector<std::array<std::uint32_t, 2>> segments;  // from corner, to corner
};

/// By the plane, which has this place in the sweep; what is counted goes to `section`.
CutSegments cut_segments(const TriangleMesh& mesh, const CutPlane& plane, const PlaneSweep& sweep, std::size_t place,
                         Section& section);

}  // namespace plumb::surface

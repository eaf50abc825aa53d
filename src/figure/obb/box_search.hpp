// Minimum bounding box (O'Rourke): which frame gives a hull the box of least volume?  Every pair of edges that can lie
// flush in adjacent faces of a box, bounded from below and left out where the bound says so.
//
// A smallest box has two adjacent faces that each hold an edge of the hull (O'Rourke).  For a pair of edges one angle
// is free: the normal n1 turns from one face beside the first edge to the other, and n2 = +-n1 x edge follows.  The
// width along a turning normal is at least that of any fixed pair of vertices, which is a concave function of the
// angle: its values at both ends bound the volume between them, and intervals that this does not exclude are halved.
// Laws: in doubles, hence the smallest up to roundings and up to `precision`; deterministic.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985; Jylanki, "An exact algorithm for finding minimum oriented
// bounding boxes", 2015, for the idea of pairs; RTCD 4.4.3.
// Cost: quadratic in the edges whose widths are small.
#pragma once

#include <array>

#include "figure/hull/model.hpp"

namespace plumb::figure::frame {

struct FoundBox {
  std::array<Vector3, 3> axes;  // orthonormal
  double volume;                // of the localized hull
};

/// The best box that has `direction` for an axis: its other axes by calipers around the silhouette.
FoundBox box_along(const HullModel& model, const Vector3& direction);

/// Each axis kept in turn while the others turn about it, as long as that pays.
FoundBox turned_about_axes(const HullModel& model, FoundBox box);

/// The best of all pairs of edges.
FoundBox smallest_box(const HullModel& model, FoundBox start);

}  // namespace plumb::figure::frame

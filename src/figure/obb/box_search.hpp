// Minimum bounding box (O'Rourke): which frame gives a hull the box of least volume, and how small can any be?  Every
// pair of edges that can lie flush in adjacent faces of a box, bounded from below and left out where the bound says so.
//
// A smallest box has two adjacent faces that each hold an edge of the hull (O'Rourke).  So its normals n1 and n2 are on
// two arcs of figure/obb/flush_arcs.hpp, perpendicular to each other.  For n1 between a0 and a1 and n2 between b0 and b1
// the widths along n1, n2 and n1 x n2 are at least those of any fixed pairs of vertices, which are least at a0 or a1, at
// b0 or b1, and at one of the four products ai x bj: normals between are sums of these with weights that add up to one
// at least.  What this does not exclude, figure/obb/flush_volume.hpp may; the rest is halved.  Where there are too many
// parts for a fine answer, the search is made again for a coarser one.
// Laws: (1) no box of right angles is smaller than `least`: every bound is rounded outward, with errors that come of
// running the same formula over numbers that carry them.  (2) Deterministic.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985; Jylanki, "An exact algorithm for finding minimum oriented
// bounding boxes", 2015, for the idea of pairs; RTCD 4.4.3.
// Cost: a nanosecond for each pair of edges whose widths are small, 50 for those whose normals can be perpendicular,
// some microseconds where pairs of doubles decide; of parts no more than some ten thousand and some hundred for each arc.
#pragma once

#include <array>

#include "figure/hull/model.hpp"
#include "figure/obb/flush_arcs.hpp"

namespace plumb::figure::frame {

struct FoundBox {
  std::array<Vector3, 3> axes;  // orthonormal
  double volume;                // of the localized hull
};

/// The best box that has `direction` for an axis: its other axes by calipers around the silhouette.
FoundBox box_along(const HullModel& model, const Vector3& direction);

/// Each axis kept in turn while the others turn about it, as long as that pays.
FoundBox turned_about_axes(const HullModel& model, FoundBox box);

struct SearchedBox {
  FoundBox best;
  double least;  // no box is smaller
};

/// The best of all pairs of edges, of which no more parts than `most_parts` are looked at.  The model's vertices are
/// those of the arcs.
SearchedBox smallest_box(const HullModel& model, const FlushArcs& flush, const FoundBox& start, std::size_t most_parts);

}  // namespace plumb::figure::frame

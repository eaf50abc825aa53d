// Into which triangles do faces of one plane and what cuts them divide it?
//
// Laws: (1) pieces overlap nowhere and cover what the faces cover; each lies in every face that it has a point of its
// interior in common with.  (2) No point of the class is on a piece but at its corners, and no chord, edge or crossing.
// (3) Pieces turn counterclockwise seen from above; they are the constrained Delaunay triangulation of the plane's
// view (surface/planar/triangulator.hpp), where cocircular points are ranked lexicographically.
// Source: RTCD 12.5.1; Zhou et al. 2016.
// Cost: pairs of segments whose boxes meet, n log n for the pieces, and each face's pieces.
#pragma once

#include <span>
#include <vector>

#include "surface/solid/plane_classes.hpp"
#include "surface/solid/plane_view.hpp"

namespace plumb::surface {

struct CoveringFace {
  std::uint32_t face;
  bool opposite;  // seen from above it turns clockwise
};

struct PlanePiece {
  TriangleMesh::Triangle corners;  // numbers in the table
  std::span<const CoveringFace> covers;
};

struct PlanePieces {
  std::vector<PlanePiece> pieces;
  std::vector<CoveringFace> covers;  // that pieces refer to
};

/// Puts the points where segments cross in the table.
PlanePieces divide_plane(const FacePool& pool, PointTable& table, const PlaneClass& of, const PlaneView& view);

}  // namespace plumb::surface

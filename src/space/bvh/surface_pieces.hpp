// How is a surface cut into small pieces, though the middle of an edge need not be a double?
//
// A corner of a piece is an exact point of the triangle, of which a box of doubles is known that holds it.  A piece lies
// in the hull of its corners' boxes, so a ball that holds these holds the piece; and the two halves of a piece are all of
// it, exactly.
#pragma once

#include <array>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/space/bvh/bvh.hpp"

namespace plumb::space {

struct SurfacePiece {
  std::array<Aabb3, 3> corners;
  /// What a ball must hold to hold the piece: the corners' boxes' corners; of a box that is a point one.
  [[nodiscard]] std::vector<Point3> points() const;
};

/// Of all triangles, each with a sphere around it that is no larger than asked, but where halving it `most_halvings` times
/// has not made it so.
struct CoveredPieces {
  std::vector<SurfacePiece> pieces;
  std::vector<Sphere3> spheres;
};
CoveredPieces covered_pieces(const Bvh& mesh, double radius, int most_halvings);

/// The eight corners of a box, one of a point.
void add_corners(const Aabb3& box, std::vector<Point3>& points);

}  // namespace plumb::space

// Minimum bounding box: along which normals can a face of a box hold an edge of the hull, and how sure are these
// numbers?
//
// The normals of supporting planes through an edge are an arc of the sphere, from the normal of one face beside it to
// that of the other.  They are cut into arcs of no more than 70 degrees or so.
// Laws: (1) the ends of every arc are within `direction_error`, in each coordinate, of unit vectors that lie on the
// exact arc; the arcs of an edge cover it.  (2) Edges' directions likewise.  (3) The vertices are the points'
// places in some frame whose unit is 2^exponent, each coordinate within `vertex_error`; all are at most one.
// (4) `enclosed` has the exact arcs and edges, and `places` the vertices, to some hundred bits.
// The errors are radii that pairs of doubles carry, not estimates.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985.
// Cost: some microseconds a face; integers for faces whose normal pairs of doubles do not give.
#pragma once

#include <vector>

#include "arith/vec.hpp"
#include "figure/hull/model.hpp"
#include "plumb/arith/ball.hpp"

namespace plumb::figure::frame {

/// No arc is left that turns further than by the angle of this cosine, where directions are sure enough for a search:
/// guesses of what pays.
inline constexpr double most_turn = 0.35, sure_enough = 0x1p-44;

struct FlushArc {
  Vector3 from, to, edge;
  std::uint32_t vertex;  // on the edge
};

struct EnclosedArc {
  arith::Vec<Ball> from, to, edge;
};

struct FlushArcs {
  std::vector<FlushArc> arcs;
  std::vector<EnclosedArc> enclosed;  // as numbered by arcs
  std::vector<arith::Vec<Ball>> places;
  std::vector<Vector3> vertices, normals;  // as numbered by HullModel
  double vertex_error = 0, direction_error = 0;
  int exponent = 0;
  bool are_sure = false;   // sure_enough; only then are the arcs cut
  double hull_volume = 0;  // no more than the hull's

  /// Of a hull of dimension 3.
  FlushArcs(const HullModel& model, std::span<const Point3> vertices);
};

}  // namespace plumb::figure::frame

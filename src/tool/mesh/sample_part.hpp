// What does `plumb check` run on when it is given nothing?  A part as a CAD program might have exported it.
//
// The flange of flange.hpp, turned about two axes by rational rotations (1 - t^2)/(1 + t^2), 2t/(1 + t^2) and moved, so
// that its coordinates are full doubles and its flats are flat only up to rounding; then the defects of real files:
//   64  repeated vertices: the bore was exported as a surface of its own and its edge was not merged
//    6  T-junctions with the vertex exactly on the edge, each closed by a triangle of exactly zero area
//    6  T-junctions with the vertex rounded off the edge, each closed by a sliver of a few ulps
//    3  collapsed edges: 3 more repeated vertices and 6 triangles of exactly zero area
//    1  fin: an edge with three faces
//    1  missing triangle
//    1  cap that is flat up to 2^-36, a fan of 24 triangles
//
// Laws: (1) the counts above, tested as such; (2) the same bits from every compiler: + - * / and sqrt alone.
// Source: RTCD 12.1, 12.2 (what files from the wild hold).
// Cost: about a millisecond.
#pragma once

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::tool {

struct SampleDefects {
  static constexpr int kSeamVertices = 64, kExactJunctions = 6, kRoundedJunctions = 6, kCollapsedEdges = 3;
  static constexpr int kRepeatedVertices = kSeamVertices + kCollapsedEdges;
  static constexpr int kZeroAreaFaces = kExactJunctions + 2 * kCollapsedEdges;
};

TriangleMesh sample_part();

}  // namespace plumb::tool

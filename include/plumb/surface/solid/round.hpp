// Rounding: which mesh of doubles stands for an exact one, and is it sound: closed, wound outward, and free of crossings?
//
//   const RoundedMesh r = round(unite(a, b));
//   if (r.sound) use(r.mesh); else show(r.meeting);        // the exact mesh is still there
//
// Each coordinate becomes its nearest double.  Vertices that become equal are one, triangles that lose their corners or
// cancel one another go.  Where triangles lose their area, cross, touch or turn over, the rounded mesh is resolved
// exactly (surface/solid/boolean.hpp, by the rule `positive`) and rounded again, there to a grid that is twice as coarse
// in each round, up to so many rounds, or until more pairs of triangles meet than the exact mesh has triangles.  Then all of
// the exact mesh is rounded anew, to grids that are 2^8, 2^16 and 2^24 times as coarse as doubles are at its largest
// coordinate, and what comes of it is treated alike: for each of those an eighth of the rounds is kept.
// Laws: (1) where `sound` is true every edge has as many triangles one way as the other, none is without area, no two
// have anything in common but vertices and edges that both name, and the mesh winds once around each point of a solid
// and not around others: all decided exactly, of the mesh as it is told.  (2) No point of the mesh is farther than
// `moved` from the exact mesh's surface: a number that is not below the largest moves of vertices, summed over the
// rounds.  (3) Where no coordinate is rounded, and the mesh is what an operation made, it stays as it is.  (4) Vertices
// and triangles are in the order of an ExactMesh; the same on any number of threads.
// The mesh must be closed and oriented, as operations make it; else InvalidShape is thrown.
// Source: RTCD 2.2.1; Milenkovic 1989 and Hobby 1999 for what rounding does to arrangements.
// Cost: in each round that of a tree and of the mesh's pairs with itself; where one has to be resolved that of arrange.
// Bounded by n^4 signs a round.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb {

struct RoundingOptions {
  std::uint32_t rounds = 24;  // at least one is made
};

struct RoundedMesh {
  TriangleMesh mesh;
  std::vector<SourceFace> sources;  // of each triangle
  bool sound = false;
  double moved = 0;
  std::uint32_t rounds = 0;                           // that were made
  double grid = 0;                                    // the coarsest, a power of two; 0 where there was one round
  std::vector<std::array<std::uint32_t, 2>> meeting;  // triangles of the mesh that cross or touch, where not sound
};

RoundedMesh round(const ExactMesh& mesh, const RoundingOptions& options = {});

}  // namespace plumb

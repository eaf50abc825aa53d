// Which triangles below a tree of wide nodes, as they are or compact, may a ray hit?
//
// Law: those are told that the ray hits at parameters whose keys (ray_slabs.hpp) are at most the limit when their box is
// looked at, each box after those that are nearer and beside it; of those told, some are not hit.
// Source: RTCD 6.3.1, 13.7; Wald, Benthin and Boulos 2008.
// Cost: a pass of lanes for eight boxes, one for as many triangles as a vector has doubles.
#pragma once

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/ray/ray_slabs.hpp"
#include "query/ray/batch_lanes.hpp"

namespace plumb::space {

/// What is done with a triangle.
class TriangleVisitor {
 public:
  /// Whether it is hit for certain, and between which parameters if it is; answers with the limit of keys from now on,
  /// -infinity to stop.
  virtual double visit(std::uint32_t slot, bool certain, double least, double most) = 0;

 protected:
  ~TriangleVisitor() = default;
};

struct AskedRay {
  query::BatchRay ray;
  TriangleVisitor* visitor;
  query::RayDoubts doubts = {};  // of a ray that is not known exactly
};
struct RayTask {
  AskedRay asked;
  RaySlabs::Planes planes;
  double limit;
};

/// So many descend by turns: while one computes, memory brings what the others asked for.
inline constexpr std::size_t rays_together = 16;

/// As each by itself; the order in which the visitors of several are called is not told.  Those that follow one another
/// descend together where they are near and fit.
void visit_triangles(const Bvh& bvh, std::span<const RayTask> tasks, bool are_near = false);
void visit_triangles(const CompactBvh& bvh, std::span<const RayTask> tasks, bool are_near = false);

}  // namespace plumb::space

// How does a posed mesh see a ray, in the numbers in which it was built?
//
//   const Sight sight(mesh);
//   if (const auto seen = sight(ray)) ...      // seen->slabs, seen->ray, seen->doubts
//
// Laws: (1) slabs keep their laws for the mesh's boxes, unposed, and the ray's own parameters.  (2) What lanes compute of
// seen->ray and a triangle of the mesh, unposed, is off by seen->doubts at most from what is exact of that triangle and
// the ray moved back; of which hits and parameters are those of the ray and the posed triangle.  (3) Nothing is seen
// where balls cannot tell the determinant from zero, where the ray has no direction, or where numbers are too far apart
// for a tree to be of use.
// The ray is moved back by the inverse in balls (arith/ball.hpp); the doubts are those that arith/approximate.hpp says of
// the lanes' formulas for corners anywhere in the root's box.
// Source: RTCD 3.2, 5.3.6, 11.4.
// Cost: a microsecond for a mesh, half of it for a ray.
#pragma once

#include <array>
#include <optional>

#include "arith/vec.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/ray/ray_slabs.hpp"
#include "query/ray/batch_lanes.hpp"

namespace plumb::space {

struct SeenRay {
  RaySlabs slabs;
  query::BatchRay ray;
  query::RayDoubts doubts;
};

class Sight {
 public:
  template <class Mesh>
  explicit Sight(const PosedMeshOf<Mesh>& mesh) : Sight(mesh.pose, mesh.bvh.tree.frame, mesh.bvh.tree.box()) {}
  [[nodiscard]] std::optional<SeenRay> operator()(const AnyRay& ray) const;

 private:
  using Balls = arith::Vec<Ball>;
  Sight(const MeshPose& pose, const BoxFrame& frame, const FloatBox3& all);

  Balls translation_;
  BoxFrame frame_;
  FloatBox3 all_;              // the tree's box; of no corners one around nothing
  Aabb3 box_;                  // of all corners, unposed
  std::array<Balls, 3> rows_;  // of the inverse matrix
};

}  // namespace plumb::space

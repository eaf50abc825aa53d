// Bounding volume (AABB), hill climbing: which axis-aligned box holds a convex polyhedron that moves?  Its six extremal
// vertices are kept, and climb.
//
// Laws: (1) the box is that of the exact images of all vertices, rounded outward once, whatever the poses asked before:
// only the time depends on them.  (2) A vertex is left for a neighbor only where the neighbor certainly lies farther;
// where neighbors lie equally far, all that are reached so are looked at, so that no plateau stops the climb.
// A polyhedron without faces throws InvalidShape; NaN and infinities throw NonFinite.
// Source: RTCD 4.2.5.
// Cost: six visits to the neighbors of a vertex where nothing changed.  Bounded by n operations a pose for n
// vertices, none of which is visited twice for one side, on integers as long as the exponents' span.
#pragma once

#include <array>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/pose_view.hpp"

namespace plumb {

class ClimbingAabb {
 public:
  /// The polyhedron must outlive this.
  explicit ClimbingAabb(const ConvexPolyhedron3& polyhedron);

  /// The box under the pose; keeps the vertices that it found.
  Aabb3 operator()(PoseView pose);

  /// Extremal at the last pose: least x, y, z, then greatest x, y, z.
  [[nodiscard]] const std::array<std::uint32_t, 6>& vertices() const { return extremal_; }

 private:
  const ConvexPolyhedron3* polyhedron_;
  std::array<std::uint32_t, 6> extremal_;
};

}  // namespace plumb

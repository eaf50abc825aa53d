// Which tree of boxes does a mesh deserve, for so many questions?  None for a few, a quick one for some, a good one for
// many: measured on the mesh itself.
//
// Laws: (1) every tree is asked the same segments and points, and its answers are compared with those of the first.
// (2) The choice for n rays is the tree of the least build + n * ray, as measured; without a tree each ray looks at all
// triangles (TriangleBatch).  (3) What is asked depends on the mesh alone; times are the least of some runs, by one
// thread.
// Source: RTCD 6.1.2, 6.2; 13.1 (measure first).
// Cost: three builds, and some thousand questions of each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/bvh/build.hpp"

namespace plumb::tool {

struct TreeTimes {
  BvhMethod method;
  double build_ms;
  double ray_ns, nearest_ns;  // of a segment within the mesh's box, of a point in it
  double bytes;               // a triangle
  std::uint64_t contradictions;
};

/// From so many rays on this tree costs least; no method: no tree.
struct TreeChoice {
  double from;
  std::optional<BvhMethod> method;
};

struct TreePlan {
  double ray_ns_without;
  std::vector<TreeTimes> trees;
  bool rays_in_plane = false;                             // the mesh's box is flat, and so all that is asked lies in it
  [[nodiscard]] std::vector<TreeChoice> choices() const;  // from few rays to many, the first from 0
};

/// The builders that are measured, from quick to good.
std::span<const BvhMethod> planned_methods();

/// Of a mesh without triangles: no trees.
TreePlan plan_trees(const TriangleMesh& mesh);

}  // namespace plumb::tool

// Sphere trees: a surface covered by spheres, ever finer from level to level, for rough answers in little time.
//
//   const SphereTree tree = build_sphere_tree(mesh, {.levels = 5});
//   tree.level(2)                                        // some dozens of spheres that hold the whole surface
//   spheres_meet(tree, 2, other, 3)                      // plumb/space/pairs/sphere_levels.hpp
//
// Three ways to cover the surface: by the cells of an octree that meet it, each with a sphere around what of it can be in
// the cell; by pieces of the triangles, halved until they are small; and by candidates around such cells, of which those
// are taken that cover most of the pieces left.
// Laws: (1) every point of every triangle, in real arithmetic, lies in a sphere of each level.  (2) A sphere contains
// those of its children, exactly.  (3) Each contains a point of the surface.  (4) The last level has all spheres that
// have no children.  (5) The tree depends on mesh and options alone.  (6) No triangles, no spheres.
// levels below 1 or above 12, and an index that names no vertex, throw InvalidShape, a vertex that is NaN or infinite
// NonFinite, a sphere that no double holds BeyondDoubles.
// Source: RTCD 6.4.3, 6.4.4, 6.4.5; Hubbard 1995, Quinlan 1994.
// Cost: an exact test of triangle against cell for each cell that may matter, a few microseconds a sphere; 40 bytes a
// sphere.  Bounded by n tests for each cell, of which the options say how many.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb {

struct SphereNode {
  Sphere3 sphere;
  std::uint32_t first_child;  // its number among all nodes
  std::uint32_t children;     // 0 in the last level, and only there
  friend bool operator==(const SphereNode&, const SphereNode&) = default;
};

/// A level after another, the root first.
struct SphereTree {
  std::vector<SphereNode> nodes;
  std::vector<std::uint32_t> begin_of_level;  // and, behind the last, the number of nodes; no triangles: empty

  [[nodiscard]] std::uint32_t levels() const {
    return begin_of_level.empty() ? 0 : static_cast<std::uint32_t>(begin_of_level.size() - 1);
  }
  /// Of the last for a level that there is none of.
  [[nodiscard]] std::span<const SphereNode> level(std::uint32_t k) const {
    if (levels() == 0) return {};
    const std::size_t l = k < levels() ? k : levels() - 1;
    return std::span(nodes).subspan(begin_of_level[l], begin_of_level[l + 1] - begin_of_level[l]);
  }
  friend bool operator==(const SphereTree&, const SphereTree&) = default;
};

enum class SphereCover : unsigned char {
  octree,  // cells of an octree that meet the surface
  pieces,  // parts of triangles; at least a sphere for each triangle
  pruned,  // of candidates those that cover most: as a rule the fewest spheres, and the longest to build
};

struct SphereTreeOptions {
  SphereCover cover = SphereCover::octree;
  /// The finest spheres are those of an octree of so many levels: half as large from one to the next.
  std::uint32_t levels = 5;
};

SphereTree build_sphere_tree(const TriangleMesh& mesh, const SphereTreeOptions& options = {});
SphereTree build_sphere_tree(const Bvh& mesh, const SphereTreeOptions& options = {});

/// Of the exact image; laws 1 to 4 hold of it.  NonFinite for a pose that is NaN or infinite.
SphereTree transform(const SphereTree& tree, const MeshPose& pose);

}  // namespace plumb

// Building a BSP tree: which planes divide these polygons?
//
//   build_bsp(mesh)                                                    // solid leaves of a closed mesh
//   build_bsp(polygons, {.kind = BspKind::leaf_storing, .leaf_size = 8})
//   build_bsp(mesh, {.split_weight = 0.9}).report                      // fewer splits, a deeper tree
//
// Laws: (1) those of bsp_tree.hpp.  (2) Pieces lie in the plane of their node, or, in leaf-storing trees, in the closed
// leaf; they cover their polygons, and no two of a face overlap.  (3) A leaf of a solid-leaf tree is solid exactly
// where locate says of its inner points that they are inside (query/ray/parity.hpp): so for every closed mesh, one that
// crosses itself too.  (4) The same input makes the same tree.  (5) Which plane is chosen is a guess in doubles; what
// lies on which side is exact, and a plane across an axis is taken only where polygons are strictly on both sides.
// Planes of faces alone make a chain of a convex mesh, as deep as it has faces: each has all others behind it.  Where
// planes across the axes are allowed, they are taken while they cut few: 10^5 faces of a ring then are 25 nodes deep.
// report.longest_chain says what is left of chains.
// A face that is not planar or not convex, or that names no vertex, throws InvalidShape with its number, and so does a mesh
// that is not closed where solid leaves are asked for; NaN and infinity throw NonFinite.
// Source: RTCD 8.3.1, 8.3.2, 8.3.3, 8.3.5.
// Cost: an exact sign for each corner of what is at a node; a sign of an edge's end where the corner is on an edge.
// Bounded by n^4 signs of n faces, for n planes may cut a face in n^2 pieces, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb {

enum class BspPlanes : unsigned char { faces, faces_and_axes };

struct BspOptions {
  BspKind kind = BspKind::solid_leaf;
  BspPlanes planes = BspPlanes::faces_and_axes;
  /// What a split costs to what imbalance does: from 0, balance alone, to 1, the fewest splits.
  double split_weight = 0.5;
  /// Faces whose planes are looked at for a node.
  std::size_t candidates = 8;
  /// A leaf-storing tree leaves at most so many pieces together, where planes of theirs are left to part them.
  std::size_t leaf_size = 4;
};

BspTree build_bsp(const TriangleMesh& mesh, const BspOptions& options = {});
/// The polygons are convex.
BspTree build_bsp(const PolygonMesh& mesh, const BspOptions& options = {});

}  // namespace plumb

// Trees of other bounding volumes than boxes with the axes of space: spheres, oriented boxes, k-DOPs, or your own.
//
//   VolumeTree<Sphere3> spheres = build_volume_tree<Sphere3>(bvh);
//   VolumeTree<KDop3> dops = build_volume_tree<KDop3>(bvh, {.k = 18});
//   descend_pairs(spheres, spheres, descend_larger{}, volumes_meet{}, visit);     // as trees of boxes are asked
//
// Nodes, leaves and slots are those of the tree of boxes that it is built from: volume i stands for all that box i
// stands for.  So everything that takes a BoxTree by its nodes (descend.hpp, descend_pairs.hpp) takes a VolumeTree.
// Laws: (1) a node's volume contains every triangle below it, in real arithmetic: fits and merges enclose exactly.  It
// need not contain its children's volumes.  (2) The tree depends on the mesh, its tree and the options, not on execution
// or threads.  (3) Of a mesh that has been moved, the volumes contain the exact images.  (4) No triangles, no nodes.
// A volume that no doubles hold throws BeyondDoubles, as the fit of it does.
// Source: RTCD 6.1.1, 6.1.2, 6.4.1, 6.4.6, 6.5; Gottschalk, Lin and Manocha 1996, Klosowski et al. 1998.
// Cost: linear for axis-aligned boxes, k-DOPs and where volumes are merged; else each corner is looked at once for each
// node above it.  A node is sizeof(Volume) + 8 bytes, and what a k-DOP keeps elsewhere.  Bounded by n operations a
// level, on integers as long as the exponents' span.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/bvh/volume_rules.hpp"

namespace plumb {

template <class Volume>
struct VolumeNode {
  Volume volume;
  std::uint32_t link;  // as in a BoxNode
  std::uint32_t count;

  [[nodiscard]] bool is_leaf() const { return count != 0; }
  /// For descend_larger.
  [[nodiscard]] double size() const { return VolumeRules<Volume>::size(volume); }
  friend bool operator==(const VolumeNode&, const VolumeNode&) = default;
};

template <class Volume>
struct VolumeTree {
  KeptArray<VolumeNode<Volume>> nodes;
};

/// What descend_pairs asks two trees of one kind of volume.
struct volumes_meet {
  template <class Volume>
  bool operator()(const VolumeNode<Volume>& a, const VolumeNode<Volume>& b) const {
    return VolumeRules<Volume>::meet(a.volume, b.volume);
  }
};

/// Over any items: of_leaf(first, count) is a volume around what is in these slots, the others are merged upward.
template <class Volume, std::invocable<std::uint32_t, std::uint32_t> OfLeaf>
VolumeTree<Volume> merged_volume_tree(const BoxTree& tree, const OfLeaf& of_leaf) {
  const std::span<const BoxNode> boxes = tree.nodes.view();
  std::vector<VolumeNode<Volume>> nodes;  // the last first: children before parents
  nodes.reserve(boxes.size());
  for (std::size_t i = boxes.size(); i-- > 0;) {
    const BoxNode& box = boxes[i];
    const auto child = [&](std::size_t k) -> const Volume& { return nodes[boxes.size() - 1 - k].volume; };
    nodes.push_back(
        {box.is_leaf() ? of_leaf(box.link, box.count) : VolumeRules<Volume>::both(child(i + 1), child(i + box.link)),
         box.link, box.count});
  }
  std::vector<VolumeNode<Volume>> in_order;
  in_order.reserve(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) in_order.push_back(std::move(nodes[i]));
  return {std::move(in_order)};
}

/// Of Sphere3, Aabb3, Obb3 or KDop3, around the triangles of the mesh.
template <class Volume>
VolumeTree<Volume> build_volume_tree(const Bvh& mesh, const VolumeOptions& options = {});

/// Around the exact images, from a tree of the mesh as it stands: spheres and oriented boxes are moved, for axis-aligned
/// boxes and k-DOPs the corners are looked at again (RTCD 4.2.4, 4.6.4).  Throws NonFinite for a pose that is NaN or
/// infinite, InvalidShape for a tree that is not one of the mesh.
template <class Volume>
VolumeTree<Volume> posed_volume_tree(const PosedMesh& mesh, const VolumeTree<Volume>& tree,
                                     Execution execution = Execution::parallel);

namespace space {

/// Throws InvalidShape: "posed_volume_tree: tree.nodes[3] is no node of the mesh's tree; ...".
template <class Volume>
void require_tree_of(const char* function, const char* name, const Bvh& mesh, const VolumeTree<Volume>& tree) {
  const std::span<const BoxNode> boxes = mesh.tree.nodes.view();
  const std::span<const VolumeNode<Volume>> nodes = tree.nodes.view();
  const auto refuse = [&](const std::string& what) {
    throw InvalidShape(std::string(function) + ": " + name + what + "; give what build_volume_tree makes of this mesh");
  };
  if (nodes.size() != boxes.size()) {
    refuse(" has " + std::to_string(nodes.size()) + " nodes, but the mesh's tree " + std::to_string(boxes.size()));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].link != boxes[i].link || nodes[i].count != boxes[i].count)
      refuse(".nodes[" + std::to_string(i) + "] is no node of the mesh's tree");
  }
}

}  // namespace space

}  // namespace plumb

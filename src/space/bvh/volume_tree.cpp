// A node's slots are one range, so the corners below it are one range of those of all slots.
#include "plumb/space/bvh/volume_tree.hpp"

#include "space/bvh/moved_ball.hpp"
#include "space/bvh/parts.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t node_block = 64;

/// Three a slot.
std::vector<Point3> corners_of(const Bvh& mesh, Execution execution) {
  std::vector<Point3> corners(3 * mesh.triangles.size());
  const std::span<const Bvh::Corners> triangles = mesh.triangles.view();
  const std::span<const Point3> vertices = mesh.vertices.view();
  for_blocks(execution, triangles.size(), 1 << 14, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t s = from; s < to; ++s) {
      for (std::size_t k = 0; k < 3; ++k) corners[3 * s + k] = vertices[triangles[s][k]];
    }
  });
  return corners;
}

/// The slots below each node.
struct NodeSlots {
  std::uint32_t first, count;
};
std::vector<NodeSlots> slots_below(std::span<const BoxNode> nodes) {
  std::vector<NodeSlots> slots(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const BoxNode& n = nodes[i];
    slots[i] = n.is_leaf() ? NodeSlots{n.link, n.count}
                           : NodeSlots{slots[i + 1].first, slots[i + 1].count + slots[i + n.link].count};
  }
  return slots;
}

/// The least volume of its kind around two that are the least around theirs, so that nothing is lost by merging.
template <class Volume>
constexpr bool merges_without_loss = std::same_as<Volume, Aabb3> || std::same_as<Volume, KDop3>;

/// fit(points) of leaves, in parallel; the others merged upward.
template <class Volume, class Fit>
VolumeTree<Volume> merged_from_leaves(const Bvh& mesh, Execution execution, const Fit& fit) {
  const std::span<const BoxNode> nodes = mesh.tree.nodes.view();
  const std::vector<Point3> corners = corners_of(mesh, execution);
  std::vector<std::uint32_t> leaf_of_slot(mesh.triangles.size());  // by its first slot
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) continue;
    leaf_of_slot[nodes[i].link] = static_cast<std::uint32_t>(leaves.size());
    leaves.push_back(i);
  }
  std::vector<std::optional<Volume>> fitted(leaves.size());
  for_blocks(execution, leaves.size(), node_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t l = from; l < to; ++l) {
      const BoxNode& n = nodes[leaves[l]];
      fitted[l] = fit(std::span(corners).subspan(3 * std::size_t{n.link}, 3 * std::size_t{n.count}));
    }
  });
  return merged_volume_tree<Volume>(
      mesh.tree, [&](std::uint32_t first, std::uint32_t) { return *std::move(fitted[leaf_of_slot[first]]); });
}

template <class Volume, class VolumeOf>
VolumeTree<Volume> of_each_node(std::span<const BoxNode> nodes, Execution execution, const VolumeOf& volume_of) {
  std::vector<VolumeNode<Volume>> all(nodes.size());
  for_blocks(execution, nodes.size(), node_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) all[i] = {volume_of(i), nodes[i].link, nodes[i].count};
  });
  return {std::move(all)};
}

template <class Volume>
VolumeTree<Volume> fitted_tree(const Bvh& mesh, const VolumeOptions& options) {
  const auto fit = [&](std::span<const Point3> points) { return VolumeRules<Volume>::around(points, options); };
  if constexpr (merges_without_loss<Volume>) {
    return merged_from_leaves<Volume>(mesh, options.execution, fit);
  } else {
    if (options.fit == VolumeFit::merged) return merged_from_leaves<Volume>(mesh, options.execution, fit);
    const std::span<const BoxNode> nodes = mesh.tree.nodes.view();
    const std::vector<Point3> corners = corners_of(mesh, options.execution);
    const std::vector<NodeSlots> slots = slots_below(nodes);
    return of_each_node<Volume>(nodes, options.execution, [&](std::size_t i) {
      return fit(std::span(corners).subspan(3 * std::size_t{slots[i].first}, 3 * std::size_t{slots[i].count}));
    });
  }
}

template <class Volume>
VolumeTree<Volume> moved_tree(const PosedMesh& mesh, const VolumeTree<Volume>& tree, Execution execution) {
  constexpr const char* function = "posed_volume_tree";
  require_pose(function, "mesh", mesh.pose);
  require_tree_of(function, "tree", mesh.bvh, tree);
  const PoseView pose = mesh.pose.view();
  const std::span<const BoxNode> nodes = mesh.bvh.tree.nodes.view();
  if constexpr (std::same_as<Volume, Aabb3>) {
    return merged_from_leaves<Volume>(mesh.bvh, execution,
                                      [&](std::span<const Point3> points) { return fit_aabb(points, pose); });
  } else if constexpr (std::same_as<Volume, KDop3>) {
    if (nodes.empty()) return {};
    const Directions3 directions = tree.nodes[0].volume.directions;
    return merged_from_leaves<Volume>(
        mesh.bvh, execution, [&](std::span<const Point3> points) { return fit_k_dop(points, directions, pose); });
  } else if constexpr (std::same_as<Volume, Sphere3>) {
    const BallMover move(function, mesh.pose);
    return of_each_node<Volume>(nodes, execution, [&](std::size_t i) { return move(tree.nodes[i].volume); });
  } else {
    return of_each_node<Volume>(nodes, execution, [&](std::size_t i) { return transform(tree.nodes[i].volume, pose); });
  }
}

}  // namespace
}  // namespace space

template <class Volume>
VolumeTree<Volume> build_volume_tree(const Bvh& mesh, const VolumeOptions& options) {
  return space::fitted_tree<Volume>(mesh, options);
}

template <class Volume>
VolumeTree<Volume> posed_volume_tree(const PosedMesh& mesh, const VolumeTree<Volume>& tree, Execution execution) {
  return space::moved_tree(mesh, tree, execution);
}

template VolumeTree<Sphere3> build_volume_tree(const Bvh&, const VolumeOptions&);
template VolumeTree<Aabb3> build_volume_tree(const Bvh&, const VolumeOptions&);
template VolumeTree<Obb3> build_volume_tree(const Bvh&, const VolumeOptions&);
template VolumeTree<KDop3> build_volume_tree(const Bvh&, const VolumeOptions&);
template VolumeTree<Sphere3> posed_volume_tree(const PosedMesh&, const VolumeTree<Sphere3>&, Execution);
template VolumeTree<Aabb3> posed_volume_tree(const PosedMesh&, const VolumeTree<Aabb3>&, Execution);
template VolumeTree<Obb3> posed_volume_tree(const PosedMesh&, const VolumeTree<Obb3>&, Execution);
template VolumeTree<KDop3> posed_volume_tree(const PosedMesh&, const VolumeTree<KDop3>&, Execution);

}  // namespace plumb

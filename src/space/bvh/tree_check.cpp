#include "space/bvh/tree_check.hpp"

#include <optional>

#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/triangle_part.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t most_halved = 2 * most_slots_of_one;

}  // namespace

bool are_full(const BoxFrame& frame, const Triangle3& triangle, const std::vector<FloatBox3>& boxes) {
  std::vector<Aabb3> later{box_around(triangle.a, triangle.b, triangle.c)};
  std::size_t halved = 0;
  while (!later.empty()) {
    const Aabb3 part = later.back();
    later.pop_back();
    const FloatBox3 box = frame.around(part);
    if (std::ranges::any_of(boxes, [&](const FloatBox3& b) { return holds(b, box); })) continue;
    if (boxes.size() == 1 || ++halved > most_halved) return false;
    const std::optional<Halves> parts = halves(triangle, part);
    if (!parts) return false;
    for (const std::optional<Aabb3>& p : *parts) {
      if (p) later.push_back(*p);
    }
  }
  return true;
}

std::string broken_law(const Bvh& bvh) {
  if (std::string broken = broken_mesh(bvh); !broken.empty()) return broken;
  const std::span<const BoxNode> nodes = bvh.tree.nodes.view();
  const std::span<const Bvh::Corners> triangles = bvh.triangles.view();
  if (nodes.empty() != triangles.empty()) return "it has nodes without triangles, or triangles without nodes";
  // Second children whose turn comes, with their depths: all of them lie behind what was looked at.
  struct Later {
    std::size_t node, parent, depth;
  };
  SlotLists lists;
  if (std::string broken = broken_numbers(bvh, lists); !broken.empty()) return broken;
  std::vector<std::uint32_t> leaf_of(triangles.size());
  std::vector<Later> later;
  if (!nodes.empty()) later.push_back({0, 0, 0});
  std::size_t next = 0, slot = 0;
  while (!later.empty()) {
    const Later now = later.back();
    later.pop_back();
    const std::string where = "node " + std::to_string(now.node);
    if (now.node != next++) return where + " is not where its parent says";
    if (now.depth > most_tree_depth) return where + " lies deeper than a tree may be";
    const BoxNode& node = nodes[now.node];
    if (!holds(nodes[now.parent].box(), node.box())) return where + " is not in its parent's box";
    if (!node.is_leaf()) {
      if (node.link < 2 || node.link >= nodes.size() - now.node) return where + " has a child out of bounds";
      later.push_back({now.node + node.link, now.node, now.depth + 1});
      later.push_back({now.node + 1, now.node, now.depth + 1});
      continue;
    }
    if (node.link != slot || node.count > triangles.size() - slot) return where + " has slots that are not its own";
    for (const std::size_t end = slot + node.count; slot < end; ++slot)
      leaf_of[slot] = static_cast<std::uint32_t>(now.node);
  }
  if (next != nodes.size() || slot != triangles.size()) return "not all of its nodes and triangles are in the tree";
  return broken_boxes(
      bvh, lists, [&](std::uint32_t s) { return nodes[leaf_of[s]].box(); },
      [&](std::uint32_t s) { return "the box of node " + std::to_string(leaf_of[s]); });
}

}  // namespace plumb::space

#include "space/bvh/tree_check.hpp"

#include <algorithm>
#include <cmath>

#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {
namespace {

// What is NaN is in nothing.
bool holds(const BoxNode& node, const FloatBox3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(node.min[k] <= box.min[k]) || !(box.max[k] <= node.max[k])) return false;
  }
  return true;
}

std::string broken_mesh(const Bvh& bvh) {
  const std::span<const Point3> vertices = bvh.vertices.view();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point3& p = vertices[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return "vertex " + std::to_string(i) + " is not finite";
    }
  }
  const std::span<const Bvh::Corners> triangles = bvh.triangles.view();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t last = std::max({triangles[i][0], triangles[i][1], triangles[i][2]});
    if (last >= vertices.size()) {
      return "the triangle in slot " + std::to_string(i) + " names vertex " + std::to_string(last) + " of " +
             std::to_string(vertices.size());
    }
  }
  std::vector<bool> seen(triangles.size());
  for (const std::uint32_t item : bvh.tree.items) {
    if (item >= seen.size() || seen[item]) return "triangle " + std::to_string(item) + " is in two slots or none";
    seen[item] = true;
  }
  return "";
}

}  // namespace

std::string broken_law(const Bvh& bvh) {
  if (std::string broken = broken_mesh(bvh); !broken.empty()) return broken;
  const std::span<const BoxNode> nodes = bvh.tree.nodes.view();
  const std::span<const Bvh::Corners> triangles = bvh.triangles.view();
  if (nodes.empty() != triangles.empty()) return "it has nodes without triangles, or triangles without nodes";
  // Second children whose turn comes, with their depths: all of them lie behind what was looked at.
  struct Later {
    std::size_t node, parent, depth;
  };
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
    if (!holds(nodes[now.parent], node.box())) return where + " is not in its parent's box";
    if (!node.is_leaf()) {
      if (node.link < 2 || node.link >= nodes.size() - now.node) return where + " has a child out of bounds";
      later.push_back({now.node + node.link, now.node, now.depth + 1});
      later.push_back({now.node + 1, now.node, now.depth + 1});
      continue;
    }
    if (node.link != slot || node.count > triangles.size() - slot) return where + " has slots that are not its own";
    for (const std::size_t end = slot + node.count; slot < end; ++slot) {
      if (!holds(node, bvh.tree.frame.around(box_around(triangles[slot], bvh.vertices.view())))) {
        return "the triangle in slot " + std::to_string(slot) + " is not in the box of " + where;
      }
    }
  }
  if (next != nodes.size() || slot != triangles.size()) return "not all of its nodes and triangles are in the tree";
  return "";
}

}  // namespace plumb::space

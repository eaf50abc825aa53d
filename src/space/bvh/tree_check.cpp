#include "space/bvh/tree_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/triangle_part.hpp"

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
  return "";
}

constexpr std::uint32_t in_no_slot = 0xffffffff;

/// Of each triangle its last slot, and of each slot the one before it of the same triangle.
struct SlotLists {
  std::vector<std::uint32_t> last, before;
};

/// Numbers go from 0 on without a gap, and slots of one number have the same corners.
std::string broken_numbers(const Bvh& bvh, SlotLists& lists) {
  const std::span<const std::uint32_t> items = bvh.tree.items.view();
  lists.before.assign(items.size(), in_no_slot);
  std::uint32_t numbers = 0;
  lists.last.assign(items.size(), in_no_slot);
  for (std::uint32_t slot = 0; slot < items.size(); ++slot) {
    const std::uint32_t item = items[slot];
    if (item >= items.size()) return "triangle " + std::to_string(item) + " has a number beyond the slots";
    numbers = std::max(numbers, item + 1);
    lists.before[slot] = std::exchange(lists.last[item], slot);
    if (lists.before[slot] != in_no_slot && bvh.triangles[slot] != bvh.triangles[lists.before[slot]])
      return "triangle " + std::to_string(item) + " has other corners in another slot";
  }
  lists.last.resize(numbers);
  for (std::uint32_t i = 0; i < numbers; ++i) {
    if (lists.last[i] == in_no_slot) return "triangle " + std::to_string(i) + " is in no slot";
  }
  return "";
}

// More than builders make of one triangle: what is in no such tree is not looked for longer.
constexpr std::size_t most_slots_of_one = 256, most_halved = 2 * most_slots_of_one;

/// Do these boxes together hold the triangle?  What is in none of them whole is halved, as those who split triangles do.
bool are_full(const BoxFrame& frame, const Triangle3& triangle, const std::vector<FloatBox3>& boxes) {
  std::vector<Aabb3> later{box_around(triangle.a, triangle.b, triangle.c)};
  std::size_t halved = 0;
  while (!later.empty()) {
    const Aabb3 part = later.back();
    later.pop_back();
    const FloatBox3 box = frame.around(part);
    if (std::ranges::any_of(boxes, [&](const FloatBox3& b) { return holds({b.min, 0, b.max, 1}, box); })) continue;
    if (boxes.size() == 1 || ++halved > most_halved) return false;
    const std::optional<Halves> parts = halves(triangle, part);
    if (!parts) return false;
    for (const std::optional<Aabb3>& p : *parts) {
      if (p) later.push_back(*p);
    }
  }
  return true;
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
    if (!holds(nodes[now.parent], node.box())) return where + " is not in its parent's box";
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
  std::vector<FloatBox3> boxes;
  for (const std::uint32_t last : lists.last) {
    boxes.clear();
    for (std::uint32_t s = last; s != in_no_slot; s = lists.before[s]) boxes.push_back(nodes[leaf_of[s]].box());
    if (boxes.size() > most_slots_of_one || !are_full(bvh.tree.frame, bvh.triangle(last), boxes)) {
      return "the triangle in slot " + std::to_string(last) +
             (boxes.size() == 1 ? " is not in the box of node " + std::to_string(leaf_of[last])
                                : " is not in the boxes of its leaves");
    }
  }
  return "";
}

}  // namespace plumb::space

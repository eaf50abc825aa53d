// Does a tree keep the laws of plumb/space/bvh/box_tree.hpp?  Looked at from outside, comparing floats with doubles.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <string>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space.hpp"

namespace plumb::tree_laws {

/// Is the float, as a number of the frame, at most x?  In rationals.
inline int compare(const BoxFrame& frame, float f, double x) {
  if (std::isinf(f)) return f > 0 ? 1 : -1;
  mpq_class a(static_cast<double>(f)), b(x);
  if (frame.exponent() >= 0) {
    a <<= static_cast<unsigned>(frame.exponent());
  } else {
    b <<= static_cast<unsigned>(-frame.exponent());
  }
  return cmp(a, b);
}

inline bool holds(const BoxFrame& frame, const BoxNode& node, const Aabb3& box) {
  const double low[] = {box.min.x, box.min.y, box.min.z}, high[] = {box.max.x, box.max.y, box.max.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (compare(frame, node.min[k], low[k]) > 0 || compare(frame, node.max[k], high[k]) < 0) return false;
  }
  return true;
}

inline bool holds(const BoxNode& outer, const BoxNode& inner) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (outer.min[k] > inner.min[k] || outer.max[k] < inner.max[k]) return false;
  }
  return true;
}

/// Which law is broken, of a tree whose items have these boxes; nothing where none is.
inline std::string broken(const BoxTree& tree, const std::vector<Aabb3>& boxes, std::uint32_t most_in_leaf) {
  if (boxes.empty()) return tree.nodes.empty() && tree.items.empty() ? "" : "nodes of no items";
  if (tree.items.size() != boxes.size()) return "as many slots as items";
  std::vector<int> seen(boxes.size());
  for (const std::uint32_t item : tree.items) {
    if (item >= boxes.size() || seen[item]++ != 0) return "each item in one slot";
  }
  struct Later {
    std::size_t node, parent, depth;
  };
  std::vector<Later> later{{0, 0, 0}};
  std::size_t next = 0, slot = 0;
  while (!later.empty()) {
    const auto [i, parent, depth] = later.back();
    later.pop_back();
    const std::string where = " at node " + std::to_string(i);
    if (i != next++ || i >= tree.nodes.size()) return "depth-first order" + where;
    const BoxNode& node = tree.nodes[i];
    if (depth > most_tree_depth) return "depth" + where;
    if (!holds(tree.nodes[parent], node)) return "children in their parents" + where;
    if (!node.is_leaf()) {
      later.push_back({i + node.link, i, depth + 1});
      later.push_back({i + 1, i, depth + 1});
      continue;
    }
    if (node.count > most_in_leaf) return "items of a leaf" + where;
    if (node.link != slot) return "slots in order" + where;
    for (slot += node.count; const std::uint32_t item : tree.items.view().subspan(node.link, node.count)) {
      if (!holds(tree.frame, node, boxes[item])) return "item " + std::to_string(item) + " in its box" + where;
    }
  }
  return next == tree.nodes.size() && slot == boxes.size() ? "" : "all nodes and slots reached";
}

inline std::vector<Aabb3> boxes_of(const TriangleMesh& mesh) {
  std::vector<Aabb3> boxes;
  for (const auto& [i, k, l] : mesh.triangles) {
    const Point3 &a = mesh.vertices[i], &b = mesh.vertices[k], &c = mesh.vertices[l];
    boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
  }
  return boxes;
}

}  // namespace plumb::tree_laws

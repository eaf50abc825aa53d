// In which slots are the triangles that pairs name?
//
// Cost: a pass over the slots.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb::space {

/// slot[item]; of a triangle that is in several slots any.
inline std::vector<std::uint32_t> slots_of(const Bvh& bvh) {
  const std::span<const std::uint32_t> items = bvh.tree.items.view();
  std::vector<std::uint32_t> slots(items.size());
  for (std::uint32_t slot = 0; slot < items.size(); ++slot) slots[items[slot]] = slot;
  return slots;
}

/// Throws InvalidShape for a number that names no triangle.
inline void require_pairs(std::span<const TrianglePair> pairs, std::size_t triangles_a, std::size_t triangles_b) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto require = [&](const char* side, std::uint32_t item, std::size_t n) {
      if (item < n) return;
      throw InvalidShape("intersections: pairs[" + std::to_string(i) + "]." + side + " is " + std::to_string(item) +
                         ", but there are " + std::to_string(n) + " triangles");
    };
    require("a", pairs[i].a, triangles_a);
    require("b", pairs[i].b, triangles_b);
  }
}

}  // namespace plumb::space

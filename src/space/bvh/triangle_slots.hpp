// In which slots are a mesh's triangles?  In one each, or in several where they are split.
//
// Cost: a pass over the slots.
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"

namespace plumb::space {

inline std::uint32_t triangles_in(const Bvh& bvh) {
  const std::span<const std::uint32_t> items = bvh.tree.items.view();
  return items.empty() ? 0 : 1 + *std::max_element(items.begin(), items.end());
}

/// Is any in several?
inline bool is_split(const Bvh& bvh) { return triangles_in(bvh) < bvh.tree.items.size(); }

/// slot[triangle]; of one that is in several any.
inline std::vector<std::uint32_t> slots_of(const Bvh& bvh) {
  const std::span<const std::uint32_t> items = bvh.tree.items.view();
  std::vector<std::uint32_t> slots(triangles_in(bvh));
  for (std::uint32_t slot = 0; slot < items.size(); ++slot) slots[items[slot]] = slot;
  return slots;
}

}  // namespace plumb::space

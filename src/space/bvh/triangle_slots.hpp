// In which slots are a mesh's triangles?  In one each, or in several where they are split.
//
// Cost: a pass over the slots.
#pragma once

#include <algorithm>
#include <vector>

#include "space/bvh/slot_triangles.hpp"

namespace plumb::space {

/// Of a Bvh or a CompactBvh.
template <class Mesh>
std::uint32_t triangles_in(const Mesh& bvh) {
  const SlotTriangles triangles(bvh);
  std::uint32_t n = 0;
  for (std::size_t slot = 0; slot < triangles.slots(); ++slot) n = std::max(n, triangles.number(slot) + 1);
  return n;
}

/// Is any in several?
template <class Mesh>
bool is_split(const Mesh& bvh) {
  return triangles_in(bvh) < bvh.slots();
}

/// slot[triangle]; of one that is in several any.
template <class Mesh>
std::vector<std::uint32_t> slots_of(const Mesh& bvh) {
  const SlotTriangles triangles(bvh);
  std::vector<std::uint32_t> slots(triangles_in(bvh));
  for (std::uint32_t slot = 0; slot < triangles.slots(); ++slot) slots[triangles.number(slot)] = slot;
  return slots;
}

}  // namespace plumb::space

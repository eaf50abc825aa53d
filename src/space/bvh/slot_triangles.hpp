// The triangles in a tree's slots, and their numbers, whichever way the mesh is kept; and in which slots is each?  In one,
// or in several where it is split.
//
// Law: triangle(slot) and number(slot) are those of the Bvh or CompactBvh that it was made of, which must outlive it.
// Cost: six words; a load and a mask for each index.  Where each triangle is takes a pass over the slots.
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb::space {

class SlotTriangles {
 public:
  using Point = Point3;

  explicit SlotTriangles(const Bvh& bvh)
      : vertices_(bvh.vertices.data()),
        corners_(reinterpret_cast<const std::byte*>(bvh.triangles.data()), sizeof(std::uint32_t)),
        numbers_(bvh.tree.items.view()),
        slots_(bvh.triangles.size()) {}
  explicit SlotTriangles(const CompactBvh& bvh)
      : vertices_(bvh.vertices.data()),
        corners_(bvh.corners.view()),
        numbers_(bvh.numbers.view()),
        slots_(bvh.slots()) {}

  [[nodiscard]] std::size_t slots() const { return slots_; }
  [[nodiscard]] std::uint32_t number(std::size_t slot) const { return numbers_[slot]; }
  [[nodiscard]] Triangle3 triangle(std::size_t slot) const {
    return {vertices_[corners_[3 * slot]], vertices_[corners_[3 * slot + 1]], vertices_[corners_[3 * slot + 2]]};
  }
  /// As it stands in a source (mesh_source.hpp) of the mesh.
  template <class Source>
  [[nodiscard]] auto of(const Source& source, std::size_t slot) const {
    if constexpr (requires { source.pose; }) {
      return PosedTriangle{triangle(slot), source.pose};
    } else {
      return triangle(slot);
    }
  }
  /// By the name that figures in slots have, whatever they are.
  [[nodiscard]] Triangle3 figure(std::size_t slot) const { return triangle(slot); }

 private:
  const Point3* vertices_;
  PackedView corners_, numbers_;
  std::size_t slots_;
};

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

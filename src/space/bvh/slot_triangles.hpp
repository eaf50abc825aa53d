// The triangles in a tree's slots, and their numbers, whichever way the mesh is kept.
//
// Law: triangle(slot) and number(slot) are those of the Bvh or CompactBvh that it was made of, which must outlive it.
// Cost: six words; a load and a mask for each index.
#pragma once

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"

namespace plumb::space {

class SlotTriangles {
 public:
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

 private:
  const Point3* vertices_;
  PackedView corners_, numbers_;
  std::size_t slots_;
};

}  // namespace plumb::space

// How small can a mesh's tree be?  Eight boxes a node, of one byte a coordinate, and numbers of as few bytes as they need.
//
//   const CompactBvh small = compact(build_bvh(mesh));    // 26 bytes a triangle, vertices included, where a Bvh takes 58
//   first_hit(ray, small), closest_on_mesh(small, p), meeting(small, box)
//
// A node keeps the boxes of its children as steps on a grid of its own: origin[k] + planes[k][i] 2^(step[k] - 149), and
// for max planes[3 + k].  The first `inner` children are the nodes first_node, first_node + 1, ...; of the others, child
// i is a leaf of count[i] slots, which follow on those of the leaf before it, from first_slot on.  A child that is missing
// has no slots.
// Laws: (1) A child's box contains that of the tree it is made of, in real arithmetic, by less than a step on each side;
//       so boxes of triangles are where they should.  (2) Every number of box(i) is exactly a float: grids are no finer
//       than the floats are where they lie.  (3) The grid is the finest of powers of two that has this, and room for all
//       children in 255 steps.  (4) Every slot is in exactly one leaf, of at most most_in_leaf; node 0 is the root, a
//       node's children come after it.  (5) The triangle in a slot is that of its number in the mesh, unchanged; the
//       vertices are as they were.
// A tree whose boxes reach beyond 2^100 in its frame (no builder makes such) throws InvalidShape.
// Source: RTCD 13.4.2; Ylitie, Karras and Laine 2017 for nodes with a grid each.
// Cost: 80 bytes a node, which is 3 a triangle; memory_of says it all.  Made in linear time.  Bounded by n operations.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/packed_numbers.hpp"

namespace plumb {

struct alignas(16) CompactNode {
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t most_in_leaf = 31;  // so that a node's slots are told in a byte
  static constexpr int least_exponent = -149;        // of floats

  std::array<float, 3> origin;
  std::array<std::uint8_t, 3> step;
  std::uint8_t inner;
  std::uint32_t first_node, first_slot;
  std::array<std::uint8_t, width> count;
  std::array<std::array<std::uint8_t, width>, 6> planes;  // min.x, min.y, min.z, max.x, max.y, max.z

  [[nodiscard]] bool has(std::size_t child) const { return child < inner || count[child] != 0; }
  /// Its node, or its first slot.
  [[nodiscard]] std::uint32_t link(std::size_t child) const {
    if (child < inner) return first_node + static_cast<std::uint32_t>(child);
    return first_slot + slots_before()[child];
  }
  /// Of each child, the slots of the leaves before it.
  [[nodiscard]] std::array<std::uint8_t, width> slots_before() const {
    if constexpr (std::endian::native == std::endian::little) {  // a product sums bytes; no sum is beyond one
      return std::bit_cast<std::array<std::uint8_t, width>>(std::bit_cast<std::uint64_t>(count) * 0x0101010101010100);
    }
    std::array<std::uint8_t, width> before{};
    for (std::size_t i = 1; i < width; ++i) before[i] = static_cast<std::uint8_t>(before[i - 1] + count[i - 1]);
    return before;
  }
  [[nodiscard]] double step_size(std::size_t axis) const {
    return std::bit_cast<double>(static_cast<std::uint64_t>(step[axis] + 1023 + least_exponent) << 52);
  }
  /// Exact: sums of few bits, which are floats.
  [[nodiscard]] FloatBox3 box(std::size_t child) const {
    FloatBox3 b;
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = static_cast<double>(origin[k]), size = step_size(k);
      b.min[k] = static_cast<float>(from + planes[k][child] * size);
      b.max[k] = static_cast<float>(from + planes[3 + k][child] * size);
    }
    return b;
  }
  /// All children at once; the planes of those that are missing say nothing.
  [[nodiscard]] WideNode<width> widened() const;
  friend bool operator==(const CompactNode&, const CompactNode&) = default;
};
static_assert(sizeof(CompactNode) == 80);

struct CompactTree {
  /// Of nodes: leaves of 2^31 slots, divided, take nine more than a binary tree has.
  static constexpr std::size_t most_levels = most_tree_depth + 9;
  /// Children that wait at most, depth first: seven on each level.
  static constexpr std::size_t most_waiting = 7 * most_levels + 1;

  KeptArray<CompactNode> nodes;
  BoxFrame frame;
  FloatBox3 root = no_box;

  /// Around all, as BoxTree::box().
  [[nodiscard]] FloatBox3 box() const { return root; }
};

struct CompactBvh {
  CompactTree tree;
  PackedNumbers corners;  // three a slot; indices into vertices
  PackedNumbers numbers;  // of the triangle in a slot
  KeptArray<Point3> vertices;

  [[nodiscard]] std::size_t slots() const { return numbers.size(); }
  [[nodiscard]] std::uint32_t number(std::size_t slot) const { return numbers[slot]; }
  [[nodiscard]] Bvh::Corners corners_of(std::size_t slot) const {
    const PackedView c = corners.view();
    return {c[3 * slot], c[3 * slot + 1], c[3 * slot + 2]};
  }
  [[nodiscard]] Triangle3 triangle(std::size_t slot) const {
    const Bvh::Corners c = corners_of(slot);
    return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  }
};

/// Of the same triangles; the Bvh may go.
CompactBvh compact(const Bvh& bvh);

/// compact(build_bvh(...)): throws as that does.
CompactBvh build_compact_bvh(std::span<const Point3> vertices, std::span<const Bvh::Corners> triangles,
                             const BvhOptions& options = {});
CompactBvh build_compact_bvh(const TriangleMesh& mesh, const BvhOptions& options = {});

/// Bytes of all that it owns or maps; of a tree its nodes alone.
std::size_t memory_of(const CompactTree& tree);
std::size_t memory_of(const CompactBvh& bvh);

}  // namespace plumb

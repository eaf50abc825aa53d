// A mesh, laid out for questions: a tree of boxes, and the triangles in the order of its leaves.
//
//   Bvh bvh = build_bvh(mesh);
//   bvh.triangle(slot), bvh.tree.items[slot]       // a triangle, and its number in the mesh
//
// Laws: (1) those of box_tree.hpp, the items being the triangles.  (2) The corners of the triangle in a slot are those
//       of its number in the mesh, in that order, unchanged; degenerate triangles are kept.  With split_share a number
//       is in several slots.  (3) The mesh may go: nothing refers to it.
// An index that names no vertex throws InvalidShape ("build_bvh: triangles[3][2] is 9, but there are 8 vertices"); a
// vertex that is NaN or infinite NonFinite ("build_bvh: vertices[17].y is nan, ..."), whether a triangle names it or
// not.
// Source: RTCD 6.6.5.
// Cost: memory_of says it; at most 64 bytes a triangle where there are half as many vertices as triangles, as in
// closed meshes.  Nothing is searched.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/space/bvh/build.hpp"
#include "plumb/space/bvh/wide_tree.hpp"

namespace plumb {

struct Bvh {
  using Corners = std::array<std::uint32_t, 3>;
  BoxTree tree;
  KeptArray<Corners> triangles;  // one a slot; indices into vertices
  KeptArray<Point3> vertices;
  WideTree<8> wide;  // of the same tree, for rays

  [[nodiscard]] std::size_t slots() const { return triangles.size(); }
  [[nodiscard]] std::uint32_t number(std::size_t slot) const { return tree.items[slot]; }
  [[nodiscard]] Corners corners_of(std::size_t slot) const { return triangles[slot]; }
  [[nodiscard]] Triangle3 triangle(std::size_t slot) const {
    const Corners& c = triangles[slot];
    return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  }
};

Bvh build_bvh(std::span<const Point3> vertices, std::span<const Bvh::Corners> triangles,
              const BvhOptions& options = {});

Bvh build_bvh(const TriangleMesh& mesh, const BvhOptions& options = {});

/// Makes bvh.wide anew; for who has changed bvh.tree by hand.
void widen(Bvh& bvh, Execution execution = Execution::parallel);

/// Bytes of all that it owns or maps.
std::size_t memory_of(const BoxTree& tree);
std::size_t memory_of(const Bvh& bvh);

}  // namespace plumb

// Which triangles of a mesh does a figure meet, by a tree of any volume?  A ray, a line, a box, a ball, a triangle, a
// convex polyhedron: whatever `intersects` takes beside the volume and beside a triangle.
//
//   meeting(bvh, build_volume_tree<Obb3>(bvh), Ray3{{0, 0, 9}, {0, 0, -1}})
//   meeting(bvh, spheres, Tetrahedron3{a, b, c, d})
//
// Who calls it includes plumb/query.hpp, or those headers of it that have `intersects` of the pairs asked.
// Laws: the numbers, ascending, of exactly those triangles for which intersects(triangle, figure) is true, whatever the
// volumes.  A tree that is not one of the mesh throws InvalidShape, numbers that are no figure throw as intersects does,
// where there is anything to ask.
// Source: RTCD 6.3.1, 6.4.
// Cost: intersects(figure, volume) for each child of a node that is entered, intersects(triangle, figure) for the
// triangles of leaves.  Bounded by n tests of volumes and of triangles, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/query/body/pairs.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/volume_tree.hpp"

namespace plumb {

namespace space {
void make_ascending(std::vector<std::uint32_t>& numbers);
}  // namespace space

template <class Volume, class Shape>
requires(RelatedPair<Shape, Volume>&& RelatedPair<Triangle3, Shape>) std::vector<std::uint32_t> meeting(
    const Bvh& mesh, const VolumeTree<Volume>& volumes, const Shape& figure, std::vector<std::uint32_t> rows = {}) {
  space::require_tree_of("meeting", "volumes", mesh, volumes);
  rows.clear();
  descend(
      volumes, [&](const VolumeNode<Volume>& node) { return intersects(figure, node.volume); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          if (intersects(mesh.triangle(slot), figure)) rows.push_back(mesh.tree.items[slot]);
        }
      });
  space::make_ascending(rows);
  return rows;
}

}  // namespace plumb

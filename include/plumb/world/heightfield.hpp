// Heightfield, terrain: which surface is a grid of heights?  A mesh of two triangles a cell, which stands in a world as
// any other does.
//
//   const Heightfield land{.columns = 513, .heights = heights, .spacing = {2, 2}, .origin = {-512, -512, 0}};
//   world.add(SharedMesh(mesh_of(land)), {.is_static = true});
//   cell_of(land, hit->part.triangle)             // which column and row was hit
//
// Laws: (1) the corner of column i and row j is the point (origin.x + i spacing.x, origin.y + j spacing.y, origin.z +
// heights[j columns + i]), each coordinate rounded once, so that corners of one column have one x, and of one row one y.
// (2) Cells are numbered row by row; the triangles of cell c are 2 c and 2 c + 1, on both sides of the diagonal from its
// first corner to the last, and turn their fronts to positive z where the spacing is positive.  (3) The vertex of a corner
// has the number of its height.
// Fewer than two columns or rows, rows that are not full, a spacing that is zero and more vertices than a mesh may have
// throw InvalidShape; NaN and infinity NonFinite; a coordinate beyond all doubles BeyondDoubles.
// Source: RTCD 2.2.1.
// Cost: linear in the heights; some 36 bytes a cell for the mesh, before its tree.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

struct Heightfield {
  std::size_t columns = 0;
  std::vector<double> heights{};  // row by row
  Vector2 spacing{1, 1};          // from column to column, from row to row
  Point3 origin{0, 0, 0};
};

TriangleMesh mesh_of(const Heightfield& field);

struct HeightfieldCell {
  std::size_t column, row;  // of its first corner
  friend bool operator==(const HeightfieldCell&, const HeightfieldCell&) = default;
};
/// In which cell is a triangle of the mesh?  A number that names none throws InvalidShape.
HeightfieldCell cell_of(const Heightfield& field, std::uint32_t triangle);

}  // namespace plumb

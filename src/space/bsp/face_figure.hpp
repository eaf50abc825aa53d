// Which figure is a face?  A triangle, or a polygon of more corners.
//
// Cost: none of a triangle, a copy of a polygon's corners.
#pragma once

#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb::space {

/// ask(Triangle3) or ask(Polygon3).
template <class Ask>
auto ask_face(const BspTree& tree, std::uint32_t face, const Ask& ask) {
  const std::uint32_t count = tree.mesh.first[face + 1] - tree.mesh.first[face];
  if (count == 3) return ask(Triangle3{tree.vertex(face, 0), tree.vertex(face, 1), tree.vertex(face, 2)});
  Polygon3 polygon;
  for (std::uint32_t i = 0; i < count; ++i) polygon.vertices.push_back(tree.vertex(face, i));
  return ask(polygon);
}

}  // namespace plumb::space

// Which triangles go to a tree in parts?  Those whose boxes are emptiest, as many parts as the budget has.
//
// Laws: (1) the boxes of a triangle's parts contain it together, certainly: they come from halves() of triangle_part.hpp,
//       beginning with its box.  (2) There are at most `share` times as many parts more as there are triangles.  (3) They
//       depend on the mesh and the share alone.
// Source: Stich, Friedrich, Dietrich 2009, Spatial splits in bounding volume hierarchies; that they are cut before the
// tree is built, by a budget: Karras and Aila 2013, Fast parallel construction of high-quality bounding volume
// hierarchies.
// Cost: linear, and some microseconds a part.
#pragma once

#include <span>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "space/bvh/builders.hpp"

namespace plumb::space {

/// Boxes to build a tree of, numbered as they lie, and the triangle of each.
struct SplitItems {
  std::vector<BoxedItem> items;
  std::vector<std::uint32_t> triangles;
};

/// `whole` are the boxes of all.
SplitItems split_items(std::span<const BoxedItem> whole, const BoxFrame& frame, std::span<const Point3> vertices,
                       std::span<const Bvh::Corners> triangles, double share, Execution execution);

/// Of a tree of parts one of triangles: each leaf has those of its parts, each once, ascending.
void join_parts(Built& built, std::span<const std::uint32_t> triangles);

}  // namespace plumb::space

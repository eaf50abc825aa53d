// How does a tree follow what moves?  Its boxes are fitted anew, and parts that have become bad are built anew.
//
//   refit(bvh, moved_vertices);                       // every frame
//   rebuild_parts(bvh, 1.7);                          // now and then
//
// Laws: (1) after either the tree keeps the laws of box_tree.hpp for the vertices as they are now.  (2) refit changes no
//       slot; rebuild_parts changes those below the nodes it rebuilds.  (3) Both give the same for any number of
//       threads.
// A number of vertices that is not the tree's throws UnequalLengths, NaN and infinity NonFinite; nothing is changed then.
// Source: RTCD 6.2.3; for the measure, Lauterbach et al. 2006 (RT-DEFORM).
// Cost: refit a tenth of a build or less; rebuild_parts that of building what is bad.  Bounded by n operations;
// rebuild_parts by the build.
#pragma once

#include <span>

#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

/// The vertices take these places; as many as there are.
void refit(Bvh& bvh, std::span<const Point3> vertices, Execution execution = Execution::parallel);

/// The items' boxes, one for each number in `items`.
void refit(BoxTree& tree, std::span<const Aabb3> boxes, Execution execution = Execution::parallel);

/// Builds anew, by bins, below each node whose children's half areas together are more than `most` times its own: 1 is
/// perfect and 2 the worst; trees as built have 1.2 to 1.5 in the main.  Returns how many triangles were built anew.
std::size_t rebuild_parts(Bvh& bvh, double most, const BvhOptions& options = {});

}  // namespace plumb

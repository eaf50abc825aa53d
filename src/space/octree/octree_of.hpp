// Which tree of cells holds boxes, in the plane or in space?  A quadtree or an octree, for code that is for both.
#pragma once

#include "plumb/space/octree/box_octree.hpp"

namespace plumb::space {

inline BoxOctree octree_of(std::span<const Aabb3> boxes, const BoxOctreeOptions& options) {
  return build_octree(boxes, options);
}
inline BoxQuadtree octree_of(std::span<const Aabb2> boxes, const BoxOctreeOptions& options) {
  return build_quadtree(boxes, options);
}

}  // namespace plumb::space

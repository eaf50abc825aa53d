// How does the surface grow from a tetrahedron to the hull?  Two ways to the same end.
//
// Afterwards no node is above a face.  A node that equals a vertex has handed it the smaller index.  With keep_flat
// every other node on the boundary is in the list Face::flat of one face in whose plane it lies.
#pragma once

#include "figure/hull/hull3_surface.hpp"

namespace plumb::figure::hull3 {

/// Always the farthest point of some face.
void grow_quickhull(Surface& surface, const std::array<Id, 4>& simplex, bool keep_flat);

/// One node after the other in a shuffled order, with a conflict graph of nodes and the faces they are above.
void grow_incrementally(Surface& surface, const std::array<Id, 4>& simplex, bool keep_flat);

/// A node that equals the vertex lets it have the smaller index.
inline void take_index(Node& vertex, const Node& equal) { vertex.index = std::min(vertex.index, equal.index); }

/// Puts the node into the list `flat` of the first of the faces in whose plane it lies, if it lies in one.
inline void keep_if_flat(Surface& surface, std::span<const Id> faces, Id node) {
  for (const Id face : faces) {
    if (surface.side(face, surface.point(node)) != 0) continue;
    surface.nodes()[node].next = surface.faces()[face].flat;
    surface.faces()[face].flat = node;
    return;
  }
}

/// Hands the flat nodes of the visible faces on to the cone, where they are still on the boundary.
inline void hand_on_flat(Surface& surface, std::span<const Id> cone) {
  for (const Id seen : surface.visible()) {
    for (Id q = surface.faces()[seen].flat; q != none;) {
      const Id next = surface.nodes()[q].next;
      keep_if_flat(surface, cone, q);
      q = next;
    }
  }
}

}  // namespace plumb::figure::hull3

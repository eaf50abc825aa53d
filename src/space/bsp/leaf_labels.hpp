// Which leaves are in the solid?  A point of each leaf is located in the mesh.
//
// A point is guessed beside a piece in the leaf's border; that it is in the leaf is proved by going down the tree.  Where no
// double is found there, the piece's center, moved by a rational number, is such a point: it is strictly within
// all planes above, for the piece has no corner beyond them and one within.
// Laws: exact, by the parity of query/ray/parity.hpp.
// Source: RTCD 8.2.3, 5.4.3.
// Cost: a descent of the tree and one of the mesh's box tree; a pass over all faces in rational numbers for a leaf
// without such a double.
#pragma once

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb::space {

/// Sets the bits of solid leaves, and what the report says of leaves.
void label_leaves(BspTree& tree, const TriangleMesh& mesh);

}  // namespace plumb::space

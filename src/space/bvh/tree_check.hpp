// Is this a tree at all?  Looked at before anybody descends what comes from a file.
//
// Cost: linear; a word or two a slot, of a compact tree 25 bytes a node as well.
#pragma once

#include <string>

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"

namespace plumb::space {

/// Which law of box_tree.hpp or bvh.hpp is broken first, in words; empty where none is.
std::string broken_law(const Bvh& bvh);

/// Of compact_tree.hpp: boxes on the way to a leaf contain together the triangles in it, or that and the other leaves of
/// a triangle that is in several.
std::string broken_law(const CompactBvh& bvh);

}  // namespace plumb::space

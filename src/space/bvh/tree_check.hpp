// Is this a tree at all?  Looked at before anybody descends what comes from a file.
//
// Cost: linear; no memory but a stack of a tree's depth.
#pragma once

#include <string>

#include "plumb/space/bvh/bvh.hpp"

namespace plumb::space {

/// Which law of box_tree.hpp or bvh.hpp is broken first, in words; empty where none is.
std::string broken_law(const Bvh& bvh);

}  // namespace plumb::space

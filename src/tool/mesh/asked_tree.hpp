// The tree of a mesh that questions are asked of: built, or kept from another run in the file that --tree names.
//
// Laws: (1) the answers are the same, with the file and without.  (2) A file that is no whole tree throws BvhFileError, and
// the tree of another mesh Error: each triangle is compared, so that none answers for what it is not.
// Source: plumb/space/bvh/tree_file.hpp.
// Cost: that of building, or a third of it.
#pragma once

#include <optional>
#include <string>

#include "plumb/space/bvh/bvh.hpp"
#include "tool/mesh/asked_mesh.hpp"

namespace plumb::tool {

/// `file` is that of --tree, if it is given.
Bvh asked_tree(const AskedMesh& asked, const std::optional<std::string>& file);

}  // namespace plumb::tool

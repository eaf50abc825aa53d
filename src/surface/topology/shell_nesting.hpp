// Which shell lies in which, and which cross by what is seen of them?
//
// Each shell is looked at at places on it: one vertex, or, where it meets another, all of its vertices and the middle of
// each triangle that meets another shell.  From each place a ray along x counts the crossings of every closed shell.
// Laws: 4 and 5 of plumb/surface/topology/shells.hpp.
// Source: RTCD 5.4.3.
// Cost: a descent for each place, and an exact sign for each triangle of a closed shell that its line passes.
#pragma once

#include "plumb/surface/topology/shells.hpp"

namespace plumb::surface {

/// Adds to `crossing`, and sets `parent` and `depth`.  What triangles tell is known: `meets`, `crosses`, and `crossing`,
/// ascending; `at_others` says of each triangle whether it meets another shell.
void nest_shells(const Bvh& bvh, const TriangleMesh& mesh, const std::vector<std::uint8_t>& at_others,
                 Execution execution, Shells& found);

}  // namespace plumb::surface

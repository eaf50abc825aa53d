// Which of what steps left as it was is still there at the end?  A later step may mend it, or take it away.
//
// Laws: (1) what a later step of the same kind, with no smaller a tolerance, looked for again is told by that one alone.
// (2) A hole is there as long as two of its points are ends of open edges; anything, as long as a triangle has its place.
// Where vertices were merged over a distance since, places may have moved, and what was told stays as long as the mesh is
// open, or as it was.
// Cost: n log n for the edges' ends, only where something was left.
#pragma once

#include <span>
#include <vector>

#include "surface/repair/steps.hpp"

namespace plumb::surface {

/// Leaves out of the changes what is no longer left.  `first_change` is, of each step, the number of its first change.
void leave_out_what_was_mended(RepairWork& work, std::span<const RepairStep> steps,
                               std::span<const std::size_t> first_change);

}  // namespace plumb::surface

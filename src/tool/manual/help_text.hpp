// What does the program tell of itself?  The manual pages of `plumb` and its commands, but for their options.
//
// Each command's `manual.cpp` holds its page; here are the program's own, and what several pages say.
// Laws: (1) no line is wider than 80 columns once indented; (2) every predicate of the manifest is listed; (3) every
// example of `plumb sign` prints what its text says.
// Source: none.
// Cost: none.
#pragma once

#include "tool/manual/man_page.hpp"

namespace plumb::tool {

/// Of a command whose status may be 1; `one` says what that means.
std::string exit_status(std::string_view one);
/// The same of a command that makes solids and replaces no file.
std::string exit_status_of_solids(std::string_view one);

/// The variables that every command heeds, and the one that every batch of signs does.
std::string environment();
std::string environment_of_batches();

Manual program_manual();
Manual boolean_manual();
Manual bounds_manual();
Manual bsp_manual();
Manual bvh_manual();
Manual check_manual();
Manual clash_manual();
Manual collect_manual();
Manual completion_manual();
Manual convert_manual();
Manual convex_manual();
Manual closest_manual();
Manual csg_manual();
Manual distance_manual();
Manual fuzz_manual();
Manual help_manual();
Manual hausdorff_manual();
Manual inside_manual();
Manual intersect_manual();
Manual nearest_manual();
Manual pairs_manual();
Manual parts_manual();
Manual plan_manual();
Manual ray_manual();
Manual repair_manual();
Manual replay_manual();
Manual resolve_manual();
Manual section_manual();
Manual sign_manual();
Manual split_manual();
Manual proof_manual();
Manual doctor_manual();

}  // namespace plumb::tool

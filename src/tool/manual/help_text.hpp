// What does the program tell of itself?  The manual pages of `plumb` and its commands, but for their options.
//
// Laws: (1) no line is wider than 80 columns once indented; (2) every predicate of the manifest is listed; (3) every
// example of `plumb sign` prints what its text says.
// (tests).
// Source: none.
// Cost: none.
#pragma once

#include "tool/manual/man_page.hpp"

namespace plumb::tool {

Manual program_manual();
Manual bounds_manual();
Manual chart_manual();
Manual check_manual();
Manual completion_manual();
Manual convert_manual();
Manual fuzz_manual();
Manual help_manual();
Manual plan_manual();
Manual section_manual();
Manual sign_manual();
Manual proof_manual();
Manual stability_manual();
Manual doctor_manual();
Manual vectors_manual();

}  // namespace plumb::tool

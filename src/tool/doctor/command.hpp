// `plumb doctor`: is this machine, and this build, as the proofs assume?
//
// Law: exit code 0 when every assumption holds, 1 when one does not; each that does not is named with its mend.
// Source: docs/proof.md "Assumptions", RTCD 11.2.3.
// Cost: a microsecond.
#pragma once

#include <string>

#include "plumb/certify/environment.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

std::string doctor_report(const Environment& environment, const Style& style);
int run_doctor();

}  // namespace plumb::tool

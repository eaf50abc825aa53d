// `plumb doctor`: is this machine, and this build, as the proofs assume?
//
// Law: exit code 0 when every assumption holds, 1 when one does not; each that does not is named with its mend.  So it is
// of --digest, where the assumption is that the answers are those that stand in the repository.
// Source: docs/proof.md "Assumptions", RTCD 11.2.3.
// Cost: a microsecond; that of the digest in digest.hpp.
#pragma once

#include <optional>
#include <string>

#include "plumb/certify/environment.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

std::string doctor_report(const Environment& environment, const Style& style);

struct DoctorOptions {
  std::optional<std::string> digest;  // "small" or "full"
  unsigned threads = 0;
};
int run_doctor(const DoctorOptions& options);

}  // namespace plumb::tool

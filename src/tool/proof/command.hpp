// `plumb proof`: can a machine check the error bound of a predicate's filter?
//
// Writes the claim for Gappa, of the constant that the filter compares with (certify/proof_script.hpp).
// Laws: (1) Gappa proves what is written (tests); (2) an unknown predicate throws Error, which names those that there
// are; (3) the script is kept as output_files.hpp says.
// Source: docs/proof.md.
// Cost: milliseconds.
#pragma once

#include <optional>
#include <string>

#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct ProofOptions {
  std::string predicate;
  bool every_scale = false;
  bool list = false;
  std::optional<std::string> out;  // none: standard output
};

int run_proof(const ProofOptions& options);

}  // namespace plumb::tool

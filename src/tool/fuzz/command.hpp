// `plumb fuzz`: on which inputs does a function of a foreign library go wrong, and what is the simplest of them?
//
// Laws: (1) exit code 0 where nothing was found, 1 where something was, 2 for bad input, which is refused before
// anything is asked; (2) the same seed, cases, corpus and library give the same text, unless time cut the run short;
// (3) each finding has a line that asks it again; (4) reports and corpus are written whole or not at all.
// Source: RTCD 11.
// Cost: the budget's, and what shrinking takes.
#pragma once

#include "tool/fuzz/options.hpp"

namespace plumb::tool {

/// All that --kind may be but a kind of the user's own, in the order of --list.
std::vector<std::string> kind_names();

int run_fuzz(const FuzzOptions& options);

}  // namespace plumb::tool

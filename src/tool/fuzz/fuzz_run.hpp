// How does a run of `plumb fuzz` go?  The kind's cases, asked of the foreign process, until the budget is spent.
//
// Laws: (1) a case that was not asked counts as none; (2) Ctrl-C ends the asking, and what was found is shrunk and
// reported; a second one ends the program; (3) when the function has crashed or hung too often the run ends, and says
// so.
// Source: none; cost: that of degenerate::check_in_batches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foreign_process.hpp"
#include "plumb/degenerate/check.hpp"

namespace plumb::tool {

struct FuzzRun {
  enum class End : unsigned char { budget, interrupted, exhausted };
  degenerate::Findings findings;
  End end = End::budget;
};

/// Its progress is shown on the terminal; `options.progress` is not used.
FuzzRun fuzz(const degenerate::Kind& kind, ForeignProcess& process, degenerate::CheckOptions options);

/// A sort of failure: its simplest case, and all the generators that came to it.
struct SortOfFailure {
  const degenerate::Finding* simplest;
  std::vector<std::string> generators;
};

/// In the order in which they were found.
std::vector<SortOfFailure> sorts_of_failure(const degenerate::Kind& kind, const degenerate::Findings& findings);

}  // namespace plumb::tool

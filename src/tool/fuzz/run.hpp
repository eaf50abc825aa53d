// How does a run of `plumb fuzz` go?  The kind's cases, asked of the foreign process, until the budget is spent.
//
// Laws: (1) a case that was not asked counts as none; (2) the end of the time and Ctrl-C are heeded within a twentieth
// of a second, or when the call returns that is being made; (3) what was found is then shrunk, for as long again at
// most (ten seconds if that is more) where there is a time, and until the next Ctrl-C; a third one ends the program;
// (4) when the function has crashed or hung too often the run ends, and says so.
// Source: none.
// Cost: that of degenerate::check_in_batches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/degenerate/check.hpp"
#include "tool/fuzz/foreign_process.hpp"

namespace plumb::tool {

struct FuzzRun {
  enum class End : unsigned char { budget, interrupted, exhausted };
  degenerate::Findings findings;
  End end = End::budget;
};

/// Its progress is shown on the terminal; `options.progress` and `options.shrinks` are not used.
FuzzRun fuzz(const degenerate::Kind& kind, ForeignProcess& process, degenerate::CheckOptions options);

/// A sort of failure: its simplest case, and all the generators that came to it.
struct SortOfFailure {
  const degenerate::Finding* simplest;
  std::vector<std::string> generators;
};

/// In the order in which they were found.
std::vector<SortOfFailure> sorts_of_failure(const degenerate::Kind& kind, const degenerate::Findings& findings);

}  // namespace plumb::tool

// Which cases have failed before?  A folder of case files, read before a run, grown after it.
//
// A case file holds case lines, comments (#) and blank lines.  Lines of other kinds are passed over, so one folder may
// serve many functions, and several runs at once.  What is no file, or begins with a dot, is passed over as well.
// Laws: (1) a file that holds anything else is refused, by name and line, before anything is asked; (2) a case is added
// once, in a file of its own that is named by its numbers; (3) all new files arrive or none does.
// Source: none.
// Cost: reading the folder.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumb/degenerate/kind.hpp"

namespace plumb::tool {

/// In the order of the files' names.  Makes the folder where it is missing; throws Error.
std::vector<degenerate::Numbers> read_corpus(const std::string& folder, const degenerate::Kind& kind);

/// How many of them were new.
std::size_t grow_corpus(const std::string& folder, const degenerate::Kind& kind,
                        std::span<const degenerate::Numbers> cases);

}  // namespace plumb::tool

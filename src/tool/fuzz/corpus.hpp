// Which cases have failed before?  A folder of case files, read before a run, grown after it.
//
// A case file holds case lines, comments (#) and blank lines.  Lines of other kinds are passed over, so one folder may
// serve many functions, and several runs at once.  What is no file, or begins with a dot, is passed over as well.
// Laws: (1) a file that holds anything else is refused, by name and line, before anything is asked; (2) a case is added
// once, in a file of its own that is named by its numbers.
// Source: none.
// Cost: reading the folder.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumb/degenerate/kind.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::tool {

/// In the order of the files' names.  Makes the folder where it is missing; throws Error.
std::vector<degenerate::Numbers> read_corpus(const std::string& folder, const degenerate::Kind& kind);

/// The files of those that are not in the folder yet; nothing is written.
std::vector<NamedText> new_cases(const std::string& folder, const degenerate::Kind& kind,
                                 std::span<const degenerate::Numbers> cases);

}  // namespace plumb::tool

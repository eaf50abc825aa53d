// How does a report of many files arrive?  Whole or not at all, and among files that are others'.
//
// Laws: (1) files are kept as output_files.hpp says, also where the reader of standard output leaves; (2) what cannot
// be written is an Error that names the file, and leaves nothing behind, nor anything of an older report half replaced
// by it; (3) of the files that are in the folder a report replaces or removes only those of an older report of its
// command, which a list in the folder names (".plumb-chart-files"): what is not on it is somebody's own, and a report
// that needs its name is refused.
// Source: none.
// Cost: that of writing the files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tool/terminal/output_files.hpp"

namespace plumb::tool {

struct NamedText {
  std::string name, text;
};

/// Proves that the folder can be written to, or made where it is missing (its parent must be there), and leaves
/// nothing; throws Error.
void require_folder(const std::string& folder);

/// The same, for a report of this command ("chart") with files of these names, as far as they are known.
void require_report_folder(const std::string& folder, std::string_view command, const std::vector<std::string>& names);

/// A report, in the place of the command's one that was there; with it, or not at all, the files `beside` it, whose
/// folders are made as this one is.
void write_report(const std::string& folder, std::string_view command, std::vector<NamedText> files,
                  std::vector<PathAndText> beside = {}, std::vector<std::filesystem::path> folders_beside = {});

}  // namespace plumb::tool

// How does a report of many files arrive?  Whole or not at all.
//
// Laws: (1) files are kept as output_files.hpp says; (2) what cannot be written is an Error that names the file, and
// leaves nothing behind, nor anything of an older report half replaced by it.
// Source: none; cost: that of writing the files.
#pragma once

#include <string>
#include <vector>

namespace plumb::tool {

struct NamedText {
  std::string name, text;
};

/// Makes the folder where it is missing (its parent must be there) and proves that it can be written to; throws Error.
void require_folder(const std::string& folder);

void write_folder(const std::string& folder, const std::vector<NamedText>& files);

}  // namespace plumb::tool

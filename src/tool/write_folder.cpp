#include "write_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "output_files.hpp"
#include "plumb/arith/error.hpp"
#include "terminal.hpp"

namespace plumb::tool {

namespace fs = std::filesystem;

void require_folder(const std::string& folder) try {
  fs::create_directory(folder);
  probe_file(fs::path(folder) / "report");  // some systems' rights promise what is not so
} catch (const std::system_error& e) {
  throw Error(fmt::format("cannot write into {}: {}", printable(folder), e.code().message()));
}

void write_folder(const std::string& folder, const std::vector<NamedText>& files) {
  std::vector<PathAndText> all;
  for (const NamedText& file : files) all.push_back({fs::path(folder) / file.name, file.text});
  keep_files(all);
}

}  // namespace plumb::tool

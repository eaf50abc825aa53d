#include "tool/fuzz/corpus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "degenerate/fields.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/paste.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

using degenerate::Kind;
using degenerate::Numbers;

constexpr std::size_t kLongestLine = 1 << 20, kLongestReason = 200;

[[noreturn]] void refuse(const fs::path& file, std::size_t line, std::string_view why) {
  throw Error(
      fmt::format("{}:{}: {}; a case file holds lines such as 'orient2d 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 "
                  "0x1p+0', and comments (#)",
                  printable(file.string()), line, printable(why.substr(0, kLongestReason))));
}

/// A case, a comment, or a case of another kind; else it throws.
void read_line(const Kind& kind, const std::string& line, std::vector<Numbers>& cases) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string::npos || line[begin] == '#') return;
  if (std::optional<Numbers> numbers = parse_case(kind, line)) return cases.push_back(std::move(*numbers));
  const std::string name = line.substr(begin, line.find_first_of(" \t\r", begin) - begin);
  if (degenerate::find_kind(name) == nullptr) throw Error(fmt::format("'{}' is no kind of case", name.substr(0, 40)));
}

void read_file(const Kind& kind, const fs::path& path, std::vector<Numbers>& cases) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(fmt::format("cannot read {}: {}", printable(path.string()), std::strerror(errno)));
  std::size_t number = 1;
  for (std::string line; std::getline(in, line); ++number) {
    if (line.size() > kLongestLine || line.find('\0') != std::string::npos) refuse(path, number, "this is no text");
    try {
      read_line(kind, line, cases);
    } catch (const Error& e) {
      refuse(path, number, e.what());
    }
  }
  if (in.bad()) throw Error(fmt::format("cannot read {}: {}", printable(path.string()), std::strerror(errno)));
}

std::string file_name(const Kind& kind, const Numbers& numbers) {
  return fmt::format("{}-{:016x}.case", kind.name, degenerate::fingerprint(numbers));
}

}  // namespace

std::vector<Numbers> read_corpus(const std::string& folder, const Kind& kind) {
  require_folder(folder);
  if (!fs::exists(folder)) return {};  // made when there is something to add
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') && entry.is_regular_file()) files.push_back(entry.path());
  }
  if (error) throw Error(fmt::format("cannot read {}: {}", printable(folder), error.message()));
  std::ranges::sort(files);
  std::vector<Numbers> cases;
  for (const fs::path& file : files) read_file(kind, file, cases);
  return cases;
}

std::vector<NamedText> new_cases(const std::string& folder, const Kind& kind, std::span<const Numbers> cases) {
  std::vector<NamedText> files;
  for (const Numbers& numbers : cases) {
    std::string name = file_name(kind, numbers);
    const bool known = fs::exists(fs::path(folder) / name) || std::ranges::count(files, name, &NamedText::name) > 0;
    if (!known) files.push_back({std::move(name), case_line(kind, numbers) + "\n"});
  }
  return files;
}

}  // namespace plumb::tool

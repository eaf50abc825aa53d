#include "tool/terminal/write_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "plumb/arith/error.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

std::string list_of(std::string_view command) { return fmt::format(".plumb-{}-files", command); }

/// Of an older report; only names of this folder's own files, whatever the list says.
std::set<std::string> files_of_older(const fs::path& folder, std::string_view command) {
  std::set<std::string> names;
  std::ifstream list(folder / list_of(command));
  for (std::string name; std::getline(list, name);) {
    std::error_code error;
    const bool plain = !name.empty() && fs::path(name).filename() == name;
    if (plain && fs::is_regular_file(fs::symlink_status(folder / name, error))) names.insert(name);
  }
  return names;
}

void require_own(const fs::path& folder, const std::string& name, const std::set<std::string>& own) {
  if (own.contains(name) || !fs::exists(fs::symlink_status(folder / name))) return;
  throw Error(
      fmt::format("{} is there already and is none of an older report's files; give another folder, or remove it",
                  printable((folder / name).string())));
}

void require_none_of(const std::vector<PathAndText>& others, const fs::path& path) {
  const auto place = [](const fs::path& p) { return fs::weakly_canonical(fs::absolute(surface::target_of(p))); };
  for (const PathAndText& other : others) {
    if (place(other.path) == place(path))
      throw Error(fmt::format("{} would be the same output twice; give another name", printable(other.path.string())));
  }
}

}  // namespace

void require_folder(const std::string& folder) try {
  probe_folder(folder);
  outlive_reader();
} catch (const std::system_error& e) {
  throw Error(fmt::format("cannot write into {}: {}", printable(folder), e.code().message()));
}

void require_report_folder(const std::string& folder, std::string_view command, const std::vector<std::string>& names) {
  require_folder(folder);
  const std::set<std::string> own = files_of_older(folder, command);
  for (const std::string& name : names) require_own(folder, name, own);
}

void write_report(const std::string& folder, std::string_view command, std::vector<NamedText> files,
                  std::vector<PathAndText> beside, std::vector<fs::path> folders_beside) {
  std::set<std::string> stale = files_of_older(folder, command);
  for (const std::string& name : stale) require_none_of(beside, fs::path(folder) / name);
  std::string list;
  for (const NamedText& file : files) {
    require_own(folder, file.name, stale);
    require_none_of(beside, fs::path(folder) / file.name);
    list += file.name + '\n';
  }
  for (const NamedText& file : files) stale.erase(file.name);
  files.push_back({list_of(command), std::move(list)});
  for (const NamedText& file : files) beside.push_back({fs::path(folder) / file.name, file.text});
  std::vector<fs::path> gone;  // named now: once the files are kept, nothing may fail
  for (const std::string& name : stale) gone.push_back(fs::path(folder) / name);
  flush_output();  // what cannot be said is no success either
  folders_beside.emplace_back(folder);
  keep_files(beside, folders_beside);
  std::error_code ignored;
  for (const fs::path& path : gone) fs::remove(path, ignored);
}

}  // namespace plumb::tool

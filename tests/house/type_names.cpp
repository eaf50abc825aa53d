#include "house/type_names.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace plumb::house {
namespace {

namespace fs = std::filesystem;

struct TypeName {
  std::string name;  // empty for a line that names no type
  bool is_alias = false;
};

/// What a line at the left margin defines, as clang-format writes it.
TypeName named_type(std::string_view line) {
  constexpr std::string_view alias = "using ";
  if (line.starts_with(alias)) {
    const std::size_t end = line.find(" = ");
    if (end == std::string_view::npos) return {};
    return {std::string(line.substr(alias.size(), end - alias.size())), true};
  }
  const auto starts = {"struct ", "class ", "enum ", "union "};
  if (std::none_of(starts.begin(), starts.end(), [&](const char* start) { return line.starts_with(start); })) return {};
  std::size_t end = line.find(" {");
  if (end == std::string_view::npos) return {};  // declared only
  line = line.substr(0, end);
  if (end = line.find(" : "); end != std::string_view::npos) line = line.substr(0, end);
  if (line.ends_with(" final")) line.remove_suffix(6);
  line.remove_prefix(line.rfind(' ') + 1);
  const bool is_name = !line.empty() && line.find_first_of("<>:()[]") == std::string_view::npos;  // else specialized
  return {is_name ? std::string(line) : std::string(), false};
}

/// The namespaces around a line, from the outermost; those without a name are empty.
class Namespaces {
 public:
  /// Returns whether the line opens or closes one.
  bool follow(std::string_view line) {
    constexpr std::string_view start = "namespace ";
    if (line.starts_with("inline ")) line.remove_prefix(7);
    if (line.starts_with("}  // namespace")) {
      if (!open_.empty()) open_.pop_back();
      return true;
    }
    if (!line.starts_with(start) || !line.ends_with("{")) return false;
    line = line.substr(start.size(), line.size() - start.size() - 1);
    open_.emplace_back(line.substr(0, line.find(' ')));
    return true;
  }
  /// The names, and the folder where one of them has no name.
  [[nodiscard]] std::string scope(const std::string& folder) const {
    std::string scope, room;
    for (const std::string& name : open_) {
      if (name.empty()) {
        room = " of " + folder;
      } else {
        scope += "::" + name;
      }
    }
    return scope + room;
  }

 private:
  std::vector<std::string> open_;
};

}  // namespace

std::vector<Breach> types_named_twice(const fs::path& tree) {
  struct Known {
    std::string file;
    bool is_alias;
  };
  std::map<std::string, Known> known;
  std::vector<Breach> out;
  const auto read = [&](const fs::path& path) {
    const std::string file = fs::relative(path, tree).generic_string();
    std::ifstream in(path);
    Namespaces namespaces;
    int chosen = 0;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("#if")) ++chosen;
      if (line.starts_with("#endif")) --chosen;
      if (namespaces.follow(line) || chosen > 0) continue;
      const auto [name, is_alias] = named_type(line);
      if (name.empty()) continue;
      const std::string scope = namespaces.scope(fs::path(file).parent_path().generic_string());
      const auto [first, is_new] = known.try_emplace(scope + ": " + name, Known{file, is_alias});
      if (is_new || (is_alias && first->second.is_alias)) continue;
      out.push_back({file, "names a type " + name + ", as does " + first->second.file});
    }
  };
  std::vector<fs::path> paths;
  for (const char* top : {"include", "predicates", "src"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".hpp" || extension == ".cpp") paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths) read(path);
  return out;
}

}  // namespace plumb::house

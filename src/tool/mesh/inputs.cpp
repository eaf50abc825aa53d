#include "tool/mesh/inputs.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& folder, const std::string& text) {
  throw MeshFileError(MeshFileProblem::unreadable, folder, std::nullopt, std::nullopt, text);
}

bool ends_like_a_mesh(fs::path path) {
  if (path.extension() == ".gz" || path.extension() == ".GZ") path = path.stem();
  return format_by_extension(path).has_value();
}

void walk(const fs::path& folder, MeshInputs& found) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(*at);
  if (error) {
    found.passed_over.push_back(folder.string() + " (" + error.message() + ")");
    return;
  }
  std::ranges::sort(entries, {}, [](const fs::directory_entry& e) { return e.path(); });
  for (const fs::directory_entry& entry : entries) {
    std::error_code ignored;
    const bool is_folder = entry.is_directory(ignored);
    if (is_folder && !entry.is_symlink(ignored)) {
      walk(entry.path(), found);
    } else {
      const bool mesh = !is_folder && ends_like_a_mesh(entry.path());
      (mesh ? found.files : found.passed_over).push_back(entry.path().string());
    }
  }
}

std::string standard_input() {
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  errno = 0;
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), stdin)) bytes.append(chunk.data(), got);
  if (std::ferror(stdin) != 0) throw Error(std::string("cannot read standard input: ") + std::strerror(errno));
  return bytes;
}

}  // namespace

MeshInputs mesh_inputs(const std::string& argument) {
  std::error_code error;
  if (argument == "-" || !fs::is_directory(argument, error)) return {{argument}, {}};
  fs::directory_iterator readable(argument, error);
  if (error) fail(argument, "cannot be read: " + error.message() + "; check its permissions");
  MeshInputs found;
  walk(argument, found);
  if (found.files.empty())
    fail(argument, "this folder holds no mesh, expected files that end like one (.obj, .stl, .3mf); name another");
  return found;
}

PolygonMesh read_input(const std::string& file, LoadReport* report, const ReadOptions& options) {
  if (file != "-") return read_polygon_mesh(file, report, options);
  return parse_mesh(standard_input(), std::filesystem::path(name_of_input(file)), report, options);
}

std::string name_of_input(const std::string& file) { return file == "-" ? "standard input" : file; }

}  // namespace plumb::tool

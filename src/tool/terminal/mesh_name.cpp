#include "tool/terminal/mesh_name.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "plumb/surface/file/mesh_file.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 22> mesh_endings{
    ".obj", ".off", ".stl", ".ply", ".gltf", ".glb", ".3mf",   ".amf", ".step", ".stp", ".iges",
    ".igs", ".dae", ".fbx", ".3ds", ".wrl",  ".x3d", ".blend", ".msh", ".vtk",  ".vtp", ".mesh"};
constexpr std::array<std::string_view, 5> packed_endings{".gz", ".bz2", ".xz", ".zst", ".zip"};
constexpr std::array<std::string_view, 4> mesh_beginnings{"glTF", "PK\x03\x04", "\x1f\x8b", "ISO-10303-21"};

std::string ending(const fs::path& path) {
  std::string text = path.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

template <class List>
bool holds(const List& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

/// A binary STL says how many triangles follow, and has just so many bytes.
bool is_binary_stl(std::string_view head, std::uintmax_t size) {
  constexpr std::size_t count_begin = 80, count_end = 84, triangle = 50;
  if (head.size() < count_end) return false;
  std::uintmax_t count = 0;
  for (std::size_t k = count_end; k-- > count_begin;) count = count << 8 | static_cast<unsigned char>(head[k]);
  return size == count_end + triangle * count;
}

bool is_mesh_content(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  std::string head(4096, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return format_by_content(head).has_value() || is_binary_stl(head, fs::file_size(path, error)) ||
         std::ranges::any_of(mesh_beginnings, [&](std::string_view b) { return head.starts_with(b); });
}

}  // namespace

bool is_mesh_name(const std::string& path) {
  const std::string last = ending(path);
  return holds(mesh_endings, last) ||
         (holds(packed_endings, last) && holds(mesh_endings, ending(fs::path(path).stem())));
}

std::string why_mesh(const std::string& path) {
  if (is_mesh_name(path)) return "is the name of a mesh";
  return is_mesh_content(path) ? "is a mesh by its content, or may be a packed one" : "";
}

}  // namespace plumb::tool

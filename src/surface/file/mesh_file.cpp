#include "plumb/surface/file/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "surface/file/mesh_failure.hpp"
#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb {
namespace {

std::string error_text(std::string_view file, std::optional<std::uint64_t> line, std::optional<std::uint64_t> byte,
                       const std::string& text) {
  std::string place(file);
  if (line) place.append(":").append(std::to_string(*line));
  if (byte) place.append(": byte ").append(std::to_string(*byte));
  return place + ": " + text;
}

// A word of the language that only OBJ speaks.
bool is_obj_word(std::string_view word) {
  constexpr std::array<std::string_view, 14> words{"v", "vt", "vn", "vp", "f",      "fo",     "l",
                                                   "p", "o",  "g",  "s",  "mtllib", "usemtl", "usemap"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

MeshFileError::MeshFileError(MeshFileProblem what_kind, std::string_view in_file, std::optional<std::uint64_t> in_line,
                             std::optional<std::uint64_t> in_byte, const std::string& text)
    : Error(error_text(in_file, in_line, in_byte, text)),
      problem(what_kind),
      file(in_file),
      line(in_line),
      byte(in_byte) {}

std::string_view name_of(MeshFormat format) {
  constexpr std::array<std::string_view, 6> names{"OBJ", "OFF", "STL", "PLY", "3MF", "glTF"};
  return names[static_cast<std::size_t>(format)];
}

std::string_view name_of(MeshEncoding encoding) {
  constexpr std::array<std::string_view, 3> names{"ASCII", "binary little endian", "binary big endian"};
  return names[static_cast<std::size_t>(encoding)];
}

std::optional<MeshFormat> format_by_extension(const std::string& path) {
  const std::string extension = surface::lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".stl") return MeshFormat::stl;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".3mf") return MeshFormat::three_mf;
  if (extension == ".gltf" || extension == ".glb") return MeshFormat::gltf;
  return std::nullopt;
}

std::optional<MeshFormat> format_by_content(std::string_view bytes) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return MeshFormat::ply;
  if (surface::is_binary_stl(bytes)) return MeshFormat::stl;
  if (bytes.starts_with("PK\3\4") || bytes.starts_with("PK\5\6")) return MeshFormat::three_mf;
  if (bytes.starts_with("glTF")) return MeshFormat::gltf;
  const std::string_view head = bytes.substr(0, 4096);
  if (head.find('\0') != std::string_view::npos) return std::nullopt;
  surface::TextLines lines(head, "", {.comments = true});
  if (!lines.next_line()) return std::nullopt;
  const std::string_view word = lines.next_token();
  if (word.starts_with('{') && bytes.find("\"asset\"") != std::string_view::npos) return MeshFormat::gltf;
  if (surface::off_header(word)) return MeshFormat::off;
  if (surface::lower_case(word) == "solid") return MeshFormat::stl;
  if (is_obj_word(word)) return MeshFormat::obj;
  return std::nullopt;
}

std::optional<MeshFormat> recognize_format(const std::string& path, std::string_view bytes) {
  const auto found = format_by_content(bytes);
  return found ? found : format_by_extension(path);
}

namespace surface {

std::string in_quotes(std::string_view found) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : found.substr(0, longest)) text += c >= ' ' && c <= '~' && c != '"' ? c : '?';
  return text + (found.size() > longest ? "...\"" : "\"");
}

void fail_at_line(MeshFileProblem problem, std::string_view file, std::uint64_t line, const std::string& text) {
  throw MeshFileError(problem, file, line, std::nullopt, text);
}

void fail_at_byte(MeshFileProblem problem, std::string_view file, std::uint64_t byte, const std::string& text) {
  throw MeshFileError(problem, file, std::nullopt, byte, text);
}

void fail_at_file(MeshFileProblem problem, std::string_view file, const std::string& text) {
  throw MeshFileError(problem, file, std::nullopt, std::nullopt, text);
}

}  // namespace surface
}  // namespace plumb

// What does the header of a PLY file promise?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/file/mesh_file.hpp"

namespace plumb::surface {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::uint64_t size_of(PlyType type) {
  constexpr std::uint64_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  enum class Role { ignored, x, y, z, corners, strip };
  std::string name;
  PlyType type = PlyType::int8;
  std::optional<PlyType> count_type;  // of a list
  Role role = Role::ignored;
  std::string entry;  // what errors call a value of it: "coordinate x"
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  [[nodiscard]] bool has_lists() const;
  [[nodiscard]] std::uint64_t size() const;  // in bytes, without the lists
};

struct PlyHeader {
  MeshEncoding encoding = MeshEncoding::ascii;
  std::vector<PlyElement> elements;
  std::uint64_t vertices = 0;
  std::uint64_t first_line = 1;  // of the data
  std::size_t size = 0;          // in bytes, with the line end of end_header
};

/// Fails unless there is an element `vertex` with x, y and z.
PlyHeader read_ply_header(std::string_view bytes, std::string_view file);

}  // namespace plumb::surface

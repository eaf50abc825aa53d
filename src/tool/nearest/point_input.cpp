#include "tool/nearest/point_input.hpp"

#include <utility>

namespace plumb::tool {
namespace {

constexpr std::array<std::string_view, 2> plane_columns{"x", "y"};
constexpr std::array<std::string_view, 3> space_columns{"x", "y", "z"};

}  // namespace

PointInput read_point_file(const std::string& file, const ReadOptions& reading, const OutputFiles& outputs) {
  TableOrMesh read =
      read_table_or_mesh(file, {"a point", "points", plane_columns, space_columns, true}, reading, outputs);
  PointInput input;
  input.name = name_of_input(file);
  if (read.mesh) {
    input.space = read.mesh->mesh.vertices;
    input.mesh = std::move(read.mesh);
    return input;
  }
  const NumberTable& table = read.table;
  input.is_planar = table.columns == plane_columns.size();
  input.inexact = table.inexact;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::span<const double> x = table[i];
    if (input.is_planar) {
      input.plane.push_back({x[0], x[1]});
    } else {
      input.space.push_back({x[0], x[1], x[2]});
    }
  }
  return input;
}

}  // namespace plumb::tool

#include "tool/pairs/box_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/arith/error.hpp"

namespace plumb::tool {
namespace {

constexpr std::array<std::string_view, 4> plane_bounds{"min x", "min y", "max x", "max y"};
constexpr std::array<std::string_view, 6> space_bounds{"min x", "min y", "min z", "max x", "max y", "max z"};

void require_upright(const NumberTable& table, std::size_t row) {
  const std::span<const double> x = table[row];
  const std::size_t axes = x.size() / 2;
  for (std::size_t k = 0; k < axes; ++k) {
    if (x[k] <= x[k + axes]) continue;
    const std::string_view axis = std::string_view("xyz").substr(k, 1);
    throw Error(fmt::format("{0}: min {1} {2} is above max {1} {3}; a row has every min, then every max",
                            table.place_of(row), axis, x[k], x[k + axes]));
  }
}

Aabb3 box_of(const Point3& a, const Point3& b, const Point3& c) {
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

}  // namespace

BoxInput read_boxes(const std::string& file, const ReadOptions& reading, const OutputFiles& outputs) {
  TableOrMesh read = read_table_or_mesh(file, {"a box", "boxes", plane_bounds, space_bounds}, reading, outputs);
  BoxInput input;
  input.name = name_of_input(file);
  if (read.mesh) {
    const TriangleMesh& mesh = read.mesh->mesh;
    for (const auto& [a, b, c] : mesh.triangles)
      input.space.push_back(box_of(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
    input.mesh = std::move(read.mesh);
    return input;
  }
  const NumberTable& table = read.table;
  input.is_planar = table.columns == plane_bounds.size();
  input.inexact = table.inexact;
  for (std::size_t i = 0; i < table.size(); ++i) {
    require_upright(table, i);
    const std::span<const double> x = table[i];
    if (input.is_planar) {
      input.plane.push_back({{x[0], x[1]}, {x[2], x[3]}});
    } else {
      input.space.push_back({{x[0], x[1], x[2]}, {x[3], x[4], x[5]}});
    }
  }
  return input;
}

}  // namespace plumb::tool

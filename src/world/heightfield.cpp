#include "plumb/world/heightfield.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

void require_rows(const char* function, const Heightfield& field) {
  const std::size_t n = field.heights.size();
  if (field.columns < 2 || n < 2 * field.columns || n % field.columns != 0) {
    throw InvalidShape(std::string(function) + ": " + std::to_string(n) + " heights in " +
                       std::to_string(field.columns) +
                       " columns; a heightfield has two columns and two full rows at least");
  }
  if (n > std::numeric_limits<std::uint32_t>::max() / 2) {  // two triangles a cell
    throw InvalidShape(std::string(function) + ": " + std::to_string(n) +
                       " heights; a mesh has fewer triangles than two a height");
  }
}

void require_numbers(const Heightfield& field) {
  const auto require_finite = [](double x, const std::string& name) {
    if (!std::isfinite(x)) throw NonFinite("mesh_of: " + name + " is not a real number; give a finite double");
  };
  require_finite(field.spacing.x, "spacing.x");
  require_finite(field.spacing.y, "spacing.y");
  if (field.spacing.x == 0 || field.spacing.y == 0) throw InvalidShape("mesh_of: spacing is zero; give another");
  for (const double x : {field.origin.x, field.origin.y, field.origin.z}) require_finite(x, "origin");
  for (std::size_t i = 0; i < field.heights.size(); ++i)
    if (!std::isfinite(field.heights[i])) require_finite(field.heights[i], "heights[" + std::to_string(i) + "]");
}

/// Rounded once.
double grid_line(double origin, double spacing, std::size_t number) {
  const double x = std::fma(spacing, static_cast<double>(number), origin);
  if (!std::isfinite(x)) throw BeyondDoubles("mesh_of: line " + std::to_string(number) + " is beyond all doubles");
  return x;
}

}  // namespace

TriangleMesh mesh_of(const Heightfield& field) {
  require_rows("mesh_of", field);
  require_numbers(field);
  const std::size_t columns = field.columns, rows = field.heights.size() / columns;
  TriangleMesh mesh;
  mesh.vertices.reserve(field.heights.size());
  mesh.triangles.reserve(2 * (columns - 1) * (rows - 1));
  std::vector<double> x(columns);
  for (std::size_t i = 0; i < columns; ++i) x[i] = grid_line(field.origin.x, field.spacing.x, i);
  for (std::size_t j = 0; j < rows; ++j) {
    const double y = grid_line(field.origin.y, field.spacing.y, j);
    for (std::size_t i = 0; i < columns; ++i) {
      const double z = field.origin.z + field.heights[j * columns + i];
      if (!std::isfinite(z)) throw BeyondDoubles("mesh_of: a height above the origin is beyond all doubles");
      mesh.vertices.push_back({x[i], y, z});
    }
  }
  const auto corner = [&](std::size_t i, std::size_t j) { return static_cast<std::uint32_t>(j * columns + i); };
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return mesh;
}

HeightfieldCell cell_of(const Heightfield& field, std::uint32_t triangle) {
  require_rows("cell_of", field);
  const std::size_t across = field.columns - 1, cell = triangle / 2;
  if (cell >= across * (field.heights.size() / field.columns - 1)) {
    throw InvalidShape("cell_of: the heightfield has no triangle " + std::to_string(triangle));
  }
  return {cell % across, cell / across};
}

}  // namespace plumb

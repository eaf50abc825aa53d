#include "plumb/space/grid/cell_grid.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "space/grid/cell_place.hpp"
#include "space/grid/checked_grid.hpp"

namespace plumb {
namespace {

template <class Grid, class Point>
auto cell_in_grid(const Grid& grid, const Point& p) {
  figure::require_finite_parts<Point>("cell_of", {"p"}, p);
  space::require_grid("cell_of", grid);
  const auto origin = coordinates(grid.origin), size = coordinates(grid.size), at = coordinates(p);
  std::array<std::int64_t, origin.size()> cell;
  for (std::size_t a = 0; a < cell.size(); ++a) {
    const std::int64_t i = space::place_of(space::PlaceOfNumber{}, at[a], origin[a], size[a]).index;
    cell[a] = std::clamp(i, -most_cell, most_cell);
  }
  return cell;
}

}  // namespace

Cell2 cell_of(const CellGrid2& grid, const Point2& p) { return cell_in_grid(grid, p); }
Cell3 cell_of(const CellGrid3& grid, const Point3& p) { return cell_in_grid(grid, p); }

}  // namespace plumb

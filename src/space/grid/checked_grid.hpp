// Is this a grid?  Finite, with cells of some size.
#pragma once

#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/space/grid/cell_grid.hpp"

namespace plumb::space {

/// Throws NonFinite and InvalidShape, naming the function.
template <class Grid>
void require_grid(std::string_view function, const Grid& grid) {
  const auto size = coordinates(grid.size);
  figure::require_finite_parts<decltype(grid.origin), decltype(grid.size)>(function, {"grid.origin", "grid.size"},
                                                                           grid.origin, grid.size);
  for (std::size_t a = 0; a < size.size(); ++a) {
    if (size[a] > 0) continue;
    throw InvalidShape(std::string(function) + ": grid.size." + "xyz"[a] + " is not above zero, but cells need a size");
  }
}

}  // namespace plumb::space

// Broad phase (uniform grids): how large are cells to be, for these boxes?
//
//   const CellSize chosen = choose_cell_size(std::span<const Aabb3>(boxes));
//
// Cells much smaller than a box hold it many times; cells much larger hold many boxes that do not meet.  So the size is
// about twice the mean extent of a box, and no less than what holds one box on average.
// Laws: (1) a power of two: a coordinate over it is exact, so the cell of a coordinate is, too.  (2) It depends on the
// boxes alone.  Any size is right: boxes that overlap share a cell, because the number of a cell grows with the
// coordinate; it is a guess of what is fast.
// Boxes that are empty, NaN or infinite throw InvalidShape or NonFinite, by name.
// Source: RTCD 7.1.1.
// Cost: some ns a box.  Nothing is searched: the boxes are passed through once.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "plumb/figure/basic/box.hpp"

namespace plumb {

/// Extents are the largest of a box along an axis.
struct CellSize {
  double size;
  double mean_extent, largest_extent;
  double spacing;  // the edge of a cube (square) that holds one box on average; infinite beyond all doubles
  friend bool operator==(const CellSize&, const CellSize&) = default;
};

CellSize choose_cell_size(std::span<const Aabb2> boxes);
CellSize choose_cell_size(std::span<const Aabb3> boxes);

struct GridOptions {
  std::optional<double> cell_size = {};            // nothing: what choose_cell_size says of the boxes
  std::size_t most_memory = std::size_t{1} << 30;  // bytes; a grid that would take more throws Error
};

}  // namespace plumb

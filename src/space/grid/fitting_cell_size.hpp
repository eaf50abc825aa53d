// How much larger than chosen must cells be, so that boxes do not reach into too many and not too many are empty?
//
// A guess of what is fast and takes little memory: any size is right.
// Source: RTCD 7.1.1.
// Cost: a pass over the boxes, and one more for each time that cells are doubled because boxes reach into too many.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "space/grid/grid_boxes.hpp"

namespace plumb::space {

/// More cells than these for each box are not made unasked: they would be empty.
inline constexpr double most_cells_a_box = 4, few_cells = 64;

/// Around all; of boxes that are sound, at least one.
template <class Box>
Box box_around(std::span<const Box> boxes) {
  Box all = boxes.front();
  const auto take = [](double& low, double& high, double from, double to) {
    low = from < low ? from : low, high = to > high ? to : high;
  };
  for (const Box& b : boxes) {
    take(all.min.x, all.max.x, b.min.x, b.max.x);
    take(all.min.y, all.max.y, b.min.y, b.max.y);
    if constexpr (axes_of<Box> == 3) take(all.min.z, all.max.z, b.min.z, b.max.z);
  }
  return all;
}

/// `size`, doubled until there are no more than these cells a box; a table of cells has none that are empty.
template <class Box>
double fitting_cell_size(const std::string& function, std::span<const Box> boxes, double size, bool is_table) {
  constexpr std::size_t n = axes_of<Box>;
  if (boxes.empty()) return size;
  const auto count = static_cast<double>(boxes.size());
  const Box all = box_around(boxes);
  const auto has_too_many = [&](double per_size) {
    if (!is_table && cell_count(cells_of(all, per_size)) > most_cells_a_box * count + few_cells) return true;
    double entries = 0;
    for (const Box& b : boxes) entries += cell_count(cells_of(b, per_size));
    return entries > 8.0 * n * count;
  };
  while (size < 0x1p1023 && has_too_many(per_cell_size(function, size))) size *= 2;
  return size;
}

}  // namespace plumb::space

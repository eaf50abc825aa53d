// Hierarchical grid: at which level is a box?  The one whose cells are just as large as it needs.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "plumb/space/grid/detail/cell_span.hpp"

namespace plumb::space {

/// Cells of level e are of size 2^e.
inline double per_level_size(int level) {
  // 2^-level; its exponent as doubles keep it, which subnormal ones do not.
  return level < 1023 ? std::bit_cast<double>(static_cast<std::uint64_t>(1023 - level) << 52) : std::ldexp(1, -level);
}

inline constexpr int least_level = -1000, most_level = 1023;

template <std::size_t n>
struct PlaceInLevels {
  int level;
  CellSpan<n> span;  // no more than two cells along each axis
};

/// The lowest level, from a guess on, at which the box reaches into two cells at most on each axis, by the numbers of
/// the cells themselves; and at which these numbers are below 2^30.
template <class Box>
PlaceInLevels<axes_of<Box>> place_in_levels(const Box& box, int at_least) {
  constexpr std::size_t n = axes_of<Box>;
  double extent = 0, size = 0;
  const auto look = [&](double from, double to) {
    extent = std::max(extent, to * 0.5 - from * 0.5);
    size = std::max({size, std::abs(from), std::abs(to)});
  };
  look(box.min.x, box.max.x);
  look(box.min.y, box.max.y);
  if constexpr (n == 3) look(box.min.z, box.max.z);
  int level = std::max(least_level, at_least);
  if (extent > 0) level = std::max(level, std::ilogb(extent));
  if (size > 0) level = std::max(level, std::ilogb(size) - 28);
  while (true) {
    const CellSpan<n> span = cells_of(box, per_level_size(level));
    bool fits = true;
    for (std::size_t k = 0; k < n; ++k) fits &= span.last[k] - span.first[k] <= 1;
    if (fits) return {level, span};
    ++level;
  }
}

}  // namespace plumb::space

// Which boxes of a grid of levels overlap?  What HierarchicalGrid and RowColumnGrid have in common: where its cells are.
//
// Source: RTCD 7.2.1.
// Cost: that of level_join.hpp.
#pragma once

#include "plumb/space/grid/detail/size_level.hpp"
#include "space/grid/level_join.hpp"

namespace plumb::space {

/// Levels are those of place_in_levels, or higher ones.
template <class Box>
std::vector<BoxPair> pairs_of_levels(const BoxPairOptions& options, std::span<const SweptBox<Box>> boxes,
                                     std::span<const int> levels, std::vector<BoxPair> rows) {
  constexpr std::size_t n = axes_of<Box>;
  return LevelJoin<Box>(options.execution, boxes, levels)
      .pairs(
          options.touching,
          [](const SweptBox<Box>& b, int level) {
            const double per_size = per_level_size(level);
            RowNumber<n> row{cell_number(b.box.min.y, per_size)};
            if constexpr (n == 3) row[1] = cell_number(b.box.min.z, per_size);
            return row;
          },
          std::move(rows));
}
template <class Box>
std::vector<BoxPair> pairs_of_levels(const BoxPairOptions& options, const std::vector<SweptBox<Box>>& boxes,
                                     const std::vector<int>& levels, std::vector<BoxPair> rows) {
  return pairs_of_levels(options, std::span<const SweptBox<Box>>(boxes), std::span<const int>(levels), std::move(rows));
}

}  // namespace plumb::space

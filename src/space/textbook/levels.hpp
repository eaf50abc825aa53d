// At which level of cells is a box?  The one whose cells are just as large as it needs; what grids of levels share.
//
// Source: RTCD 7.2.1.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "space/textbook/level_join.hpp"
#include "space/textbook/scheme.hpp"

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
  friend bool operator==(const PlaceInLevels&, const PlaceInLevels&) = default;
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

template <class Box>
class GridLevels {
 public:
  static constexpr std::size_t n = axes_of<Box>;

  GridLevels(const AskedFunction& asked, int least) : least_(least) {
    if (least <= most_level) return;
    throw InvalidShape(asked.text() + ": options.least_level is " + std::to_string(least) +
                       ", but it must not be above 1023");
  }

  [[nodiscard]] PlaceInLevels<n> place_in(const Box& box) const { return place_in_levels(box, least_); }
  static int level_of(const auto& place) { return place.level; }
  static RowNumber<n> row_of(const SweptBox<Box>& b, const auto&, int level) {
    const double per_size = per_level_size(level);
    RowNumber<n> row{cell_number(b.box.min.y, per_size)};
    if constexpr (n == 3) row[1] = cell_number(b.box.min.z, per_size);
    return row;
  }

 private:
  int least_;
};

/// Of levels in ascending order, each with its number as `level`, the first that is not below.
template <class Levels>
auto level_at(Levels& levels, int level) {
  return std::lower_bound(levels.begin(), levels.end(), level,
                          [](const auto& l, int wanted) { return l.level < wanted; });
}

}  // namespace plumb::space

// Which cells does a box reach into?  Numbers of cells that grow with the coordinate.
//
// floor(x / size) of a size that is a power of two is exact.  Of other sizes the product with the reciprocal is
// rounded; it still grows with x, and that is all that pairs need: boxes overlap on an axis where min_a <= max_b and
// min_b <= max_a, and then so do the numbers of their cells.  For the same reason numbers end at most_number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/space/pairs/float_boxes.hpp"

namespace plumb::space {

inline constexpr double most_number = 0x1p30;

inline std::int32_t cell_number(double x, double per_size) {
  const double v = x * per_size;
  const double within = v > -most_number ? (v < most_number ? v : most_number) : -most_number;
  const auto toward_zero = static_cast<std::int32_t>(within);
  return toward_zero - (within < toward_zero ? 1 : 0);
}

template <std::size_t n>
using CellNumber = std::array<std::int32_t, n>;

template <std::size_t n>
struct CellSpan {
  CellNumber<n> first, last;
  friend bool operator==(const CellSpan&, const CellSpan&) = default;
};

inline CellSpan<2> cells_of(const Aabb2& b, double per_size) {
  return {{cell_number(b.min.x, per_size), cell_number(b.min.y, per_size)},
          {cell_number(b.max.x, per_size), cell_number(b.max.y, per_size)}};
}
inline CellSpan<3> cells_of(const Aabb3& b, double per_size) {
  return {{cell_number(b.min.x, per_size), cell_number(b.min.y, per_size), cell_number(b.min.z, per_size)},
          {cell_number(b.max.x, per_size), cell_number(b.max.y, per_size), cell_number(b.max.z, per_size)}};
}

}  // namespace plumb::space

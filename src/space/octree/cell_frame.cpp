#include "plumb/space/octree/cell_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/finite_parts.hpp"
#include "space/octree/box_sides.hpp"

namespace plumb {
namespace {

/// x / 2^n, rounded down, where that takes no more than 52 bits.
bool rounds_down(double x, int n, double& down) {
  if (x == 0) {
    down = 0;
    return true;
  }
  const int exponent = std::ilogb(x);
  if (exponent - n > 51) return false;
  down = exponent < n ? (x < 0 ? -1 : 0) : std::floor(std::ldexp(x, -n));
  return true;
}

}  // namespace

template <std::size_t D>
CellFrame<D>::CellFrame(const Box& held) {
  space::check_cell_box("CellFrame", "held", held);
  const auto low = coordinates(held.min), high = coordinates(held.max);
  int n = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;  // of the least double
  const auto fits = [&] {
    for (std::size_t axis = 0; axis < D; ++axis) {
      double from, to;
      if (!rounds_down(low[axis], n, from) || !rounds_down(high[axis], n, to) || to - from > last) return false;
      first_[axis] = from;
    }
    return true;
  };
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const double x : {low[axis], high[axis]}) {
      if (x != 0) n = std::max(n, std::ilogb(x) - 51);
    }
  }
  while (!fits()) ++n;
  unit_ = std::ldexp(1.0, n);
  const int half = -n / 2;
  scale_ = std::ldexp(1.0, half);
  more_scale_ = std::ldexp(1.0, -n - half);
}

template class CellFrame<2>;
template class CellFrame<3>;

}  // namespace plumb

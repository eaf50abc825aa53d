#include "plumb/space/grid/cell_size.hpp"

#include <algorithm>
#include <cmath>

#include "space/grid/grid_boxes.hpp"

namespace plumb {
namespace {

/// Numbers are a quarter of what they stand for, so that no difference of two overflows.
constexpr double part = 0.25;

template <class Box>
CellSize chosen_size(std::span<const Box> boxes) {
  constexpr std::size_t n = space::axes_of<Box>;
  space::require_grid_boxes("choose_cell_size", boxes);
  if (boxes.empty()) return {1, 0, 0, 0};
  const auto count = static_cast<double>(boxes.size());
  double sum = 0, most = 0;
  std::array<double, n> low = coordinates(boxes[0].min), high = coordinates(boxes[0].max);
  for (const Box& box : boxes) {
    const auto min = coordinates(box.min), max = coordinates(box.max);
    double extent = 0;
    for (std::size_t k = 0; k < n; ++k) {
      extent = std::max(extent, max[k] * part - min[k] * part);
      low[k] = std::min(low[k], min[k]), high[k] = std::max(high[k], max[k]);
    }
    sum += extent / count;
    most = std::max(most, extent);
  }
  double logarithm = -std::log2(count);  // of the volume for each box
  int axes = 0;                          // along which they do not all lie in one plane
  for (std::size_t k = 0; k < n; ++k) {
    if (low[k] == high[k]) continue;
    logarithm += std::log2(high[k] * part - low[k] * part);
    ++axes;
  }
  const double spacing = axes == 0 ? 0 : std::exp2(logarithm / axes);
  // Twice the mean, and cells of one box or so.
  const double wanted = std::max(2 * sum, spacing);
  const int exponent = wanted > 0 ? std::clamp(static_cast<int>(std::lround(std::log2(wanted))) + 2, -1000, 1000) : 0;
  const double mean = std::min(sum, most);  // rounding
  return {std::ldexp(1, exponent), mean / part, most / part, spacing / part};
}

}  // namespace

CellSize choose_cell_size(std::span<const Aabb2> boxes) { return chosen_size(boxes); }
CellSize choose_cell_size(std::span<const Aabb3> boxes) { return chosen_size(boxes); }

}  // namespace plumb

#include "plumb/degenerate/moves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "plumb/degenerate/ulps.hpp"

namespace plumb {

namespace {

// Scales the coordinates first, first + stride, ...
void scale_slice(std::span<double> coordinates, std::size_t first, std::size_t stride, Entropy& entropy) {
  int lowest = 1024, highest = -1075;
  for (std::size_t i = first; i < coordinates.size(); i += stride) {
    lowest = std::min(lowest, lowest_exponent(coordinates[i]));
    highest = std::max(highest, highest_exponent(coordinates[i]));
  }
  if (lowest > highest) return;  // zeros only
  const int down = -1074 - lowest, up = 1023 - highest;
  int by = 0;
  switch (entropy.below(3)) {
    case 0:
      by = static_cast<int>(std::clamp<std::int64_t>(entropy.within(1024), down, up));
      break;
    case 1:
      by = std::min(up, down + static_cast<int>(entropy.below(64)));
      break;
    default:
      by = std::max(down, up - static_cast<int>(entropy.below(64)));
      break;
  }
  for (std::size_t i = first; i < coordinates.size(); i += stride) coordinates[i] = std::ldexp(coordinates[i], by);
}

}  // namespace

void move_by_ulps(std::span<double> coordinates, int most_moves, int most_ulps, Entropy& entropy) {
  if (coordinates.empty()) return;
  const std::uint64_t moves = 1 + entropy.below(static_cast<std::uint64_t>(most_moves));
  for (std::uint64_t move = 0; move < moves; ++move) {
    double& x = coordinates[entropy.below(coordinates.size())];
    const auto steps = 1 + static_cast<std::int64_t>(entropy.below(static_cast<std::uint64_t>(most_ulps)));
    x = moved_by_ulps(x, entropy.coin() ? -steps : steps);
  }
}

void repeat_points(std::span<double> coordinates, int dimension, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  const std::size_t count = coordinates.size() / stride;
  if (count < 2) return;
  // Sharing comes first: what is made equal by the last step stays equal.
  for (std::uint64_t steps = entropy.below(count); steps > 0; --steps) {
    const std::size_t from = entropy.below(count) * stride, to = entropy.below(count) * stride;
    const std::size_t axis = entropy.below(stride);
    switch (entropy.below(4)) {
      case 0:
        std::copy_n(&coordinates[from], stride, &coordinates[to]);
        break;
      case 1:
        coordinates[to + axis] = coordinates[from + axis];
        break;
      case 2:
        coordinates[to + axis] = -coordinates[from + axis];
        break;
      default:
        coordinates[to + axis] = coordinates[from + axis] = 0.0;
        break;
    }
  }
  const std::size_t from = entropy.below(count);
  const std::size_t to = (from + 1 + entropy.below(count - 1)) % count;
  std::copy_n(&coordinates[from * stride], stride, &coordinates[to * stride]);
  for (std::size_t axis = 0; axis < stride; ++axis) {
    double& x = coordinates[to * stride + axis];
    if (x == 0 && entropy.coin()) x = -x;
  }
}

void scale_exactly(std::span<double> coordinates, Entropy& entropy) { scale_slice(coordinates, 0, 1, entropy); }

void scale_axes_exactly(std::span<double> coordinates, int dimension, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  for (std::size_t axis = 0; axis < stride; ++axis) scale_slice(coordinates, axis, stride, entropy);
}

void permute_axes(std::span<double> coordinates, int dimension, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  const std::size_t turn = entropy.below(stride);
  const bool swap = entropy.coin();
  for (std::size_t first = 0; first + stride <= coordinates.size(); first += stride) {
    const auto point = coordinates.subspan(first, stride);
    std::rotate(point.begin(), point.begin() + static_cast<std::ptrdiff_t>(turn), point.end());
    if (swap) std::swap(point[0], point[1]);
  }
}

void permute_points(std::span<double> coordinates, int dimension, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  for (std::size_t left = coordinates.size() / stride; left > 1; --left) {
    const auto last = coordinates.subspan((left - 1) * stride, stride);
    const std::size_t back = entropy.below(left);  // 0: stays where it is
    std::swap_ranges(last.begin(), last.end(), &coordinates[(left - 1 - back) * stride]);
  }
}

}  // namespace plumb

#include "space/broad_phase/sweep_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace plumb::space {
namespace {

// Nanoseconds, on the machine of docs/measurements.md: a copy of a box in a column, 16 boxes compared, a column.
constexpr double of_copy = 14, of_compared = 3.5, of_column = 60;

constexpr std::array<std::uint32_t, 27> divisions{1,  2,  3,  4,  5,   6,   8,   10,  12,  16,  20,  24,  32,  40,
                                                  48, 64, 80, 96, 128, 160, 192, 256, 320, 384, 512, 768, 1024};

struct Division {
  double copies = 1;  // of a box
  double shared = 1;  // strips that two boxes have in common, on the average
};

Division divide(std::span<const SampledBox> sample, std::size_t axis, std::uint32_t strips) {
  std::vector<std::uint32_t> inside(strips);
  const auto strip = [&](float x) {
    return std::min(static_cast<std::uint32_t>(x * static_cast<float>(strips)), strips - 1);
  };
  std::size_t copies = 0;
  for (const SampledBox& b : sample) {
    for (std::uint32_t s = strip(b.low[axis]), last = strip(b.high[axis]); s <= last; ++s) ++inside[s], ++copies;
  }
  double pairs = 0;
  for (const double here : inside) pairs += here * (here - 1);
  const auto m = static_cast<double>(sample.size());
  return {static_cast<double>(copies) / m, pairs / (m * (m - 1))};
}

/// Which part of all pairs overlaps along the axis?
double overlapping_share(std::span<const SampledBox> sample, std::size_t axis) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const float low = sample[i].low[axis], high = sample[i].high[axis];
    for (std::size_t j = 0; j < i; ++j) {
      pairs += static_cast<std::size_t>(low <= sample[j].high[axis] && sample[j].low[axis] <= high);
    }
  }
  const auto m = static_cast<double>(sample.size());
  return static_cast<double>(pairs) / (m * (m - 1) / 2);
}

}  // namespace

SweepPlan plan_sweep(std::span<const SampledBox> sample, std::size_t n) {
  SweepPlan plan;
  if (sample.size() < 2) return plan;
  std::array<double, 3> share{};
  for (std::size_t k = 0; k < 3; ++k) share[k] = overlapping_share(sample, k);
  std::sort(plan.order.begin(), plan.order.end(),
            [&](std::size_t a, std::size_t b) { return share[a] < share[b] || (share[a] == share[b] && a < b); });
  const auto boxes = static_cast<double>(n);
  std::array<std::vector<Division>, 2> by;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const std::uint32_t strips : divisions) {
      by[k].push_back(divide(sample, plan.order[k + 1], strips));
      if (strips > n || by[k].back().copies > 8) break;
    }
  }
  double least = 0;
  for (std::size_t i = 0; i < by[0].size(); ++i) {
    for (std::size_t j = 0; j < by[1].size(); ++j) {
      const double copies = by[0][i].copies * by[1][j].copies;
      const double windows = boxes * boxes / 2 * share[plan.order[0]] * by[0][i].shared * by[1][j].shared;
      const double columns = static_cast<double>(divisions[i]) * static_cast<double>(divisions[j]);
      const double cost = boxes * copies * of_copy + windows / 16 * of_compared + columns * of_column;
      if ((i != 0 || j != 0) && !(cost < least)) continue;
      least = cost;
      plan.columns = {divisions[i], divisions[j]};
      plan.windows = windows, plan.copies = copies;
    }
  }
  return plan;
}

}  // namespace plumb::space

// What can be counted in a sample of boxes, before a method is chosen?
//
// A guess throughout, from at most 512 boxes, taken evenly from all; nothing is decided by it but what is tried first.
// Source: RTCD 7.1.1.
// Cost: some passes over the boxes for the bounds and the size of cells, and 1 ms for the pairs of the sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "plumb/space/broad_phase/choose_index.hpp"
#include "space/broad_phase/index_costs.hpp"
#include "space/broad_phase/swept_columns.hpp"
#include "space/grid/fitting_cell_size.hpp"

namespace plumb::space {

struct CountedBoxes {
  BoxTraits traits;
  Counts counts{};

  double& operator[](CountedThing what) { return counts[static_cast<std::size_t>(what)]; }
};

/// The longest edges, halved, of which 5 of 100 are below the first number and above the second.
template <class Box>
double ratio_of_sizes(const std::vector<Box>& sample) {
  std::vector<double> edges;
  for (const Box& b : sample) {
    const auto x = numbers_of(b);
    double longest = 0;
    for (std::size_t k = 0; k < axes_of<Box>; ++k) longest = std::max(longest, x[k + axes_of<Box>] * 0.5 - x[k] * 0.5);
    edges.push_back(longest);
  }
  std::sort(edges.begin(), edges.end());
  constexpr std::size_t but_one_of = 20;  // a guess: beyond these ends are what a few odd boxes are
  const double small = edges[edges.size() / but_one_of], large = edges[edges.size() - 1 - edges.size() / but_one_of];
  return large > small ? large / small : 1;
}

/// How many times as often two boxes have their middles in one of 8 x 8 (x 8) cells as if all were spread evenly.
template <class Box>
double crowding(const std::vector<Box>& sample, const SetBounds& bounds) {
  constexpr double cells_along = 8;
  std::vector<double> inside(8 * 8 * 8);
  double cells = 1;
  for (std::size_t k = 0; k < axes_of<Box>; ++k) cells *= bounds.min[k] < bounds.max[k] ? cells_along : 1.0;
  for (const Box& b : sample) {
    const auto x = numbers_of(b);
    std::size_t cell = 0;
    for (std::size_t k = 0; k < axes_of<Box>; ++k) {
      const double from = bounds.min[k] * 0.5, to = bounds.max[k] * 0.5;
      const double middle = x[k] * 0.25 + x[k + axes_of<Box>] * 0.25;
      const double at = to > from ? (middle - from) / (to - from) * cells_along : 0;
      cell = cell * 8 + static_cast<std::size_t>(std::clamp(at, 0.0, cells_along - 1));
    }
    ++inside[cell];
  }
  double together = 0;
  for (const double here : inside) together += here * (here - 1);
  const auto m = static_cast<double>(sample.size());
  return sample.size() < 2 ? 1 : together / (m * (m - 1)) * cells;
}

/// Of boxes that are checked.
template <class Box>
CountedBoxes count_boxes(std::span<const Box> boxes, double moving_share) {
  constexpr std::size_t most = 512, axes = axes_of<Box>;
  const std::size_t n = boxes.size(), m = std::min(n, most);
  CountedBoxes of;
  of.traits.count = n;
  of.traits.dimensions = static_cast<int>(axes);
  of.traits.moving_share = moving_share;
  const auto all = static_cast<double>(n);
  of[CountedThing::once] = 1;
  of[CountedThing::moved] = moving_share;
  of[CountedThing::boxes] = all / 1000;
  of[CountedThing::copies] = of[CountedThing::swept_copies] = 1;
  if (n < 2) return of;
  of[CountedThing::doublings] = std::log2(all);

  std::vector<Box> sample;
  for (std::size_t i = 0; i < m; ++i) sample.push_back(boxes[i * n / m]);
  SetBounds bounds;
  (void)find_bounds(boxes, bounds);
  of.traits.size_ratio = ratio_of_sizes(sample);
  of.traits.clustering = crowding(sample, bounds);

  const BoxSet<Box> set{boxes};
  const SweepPlan plan = place_sweep(set, bounds).plan;
  of[CountedThing::swept_copies] = plan.copies;
  of[CountedThing::swept_windows] = plan.windows / all;
  of[CountedThing::moved_windows] = moving_share * of[CountedThing::swept_windows];

  const double size = fitting_cell_size("choose_index", boxes, choose_cell_size(boxes).size, false);
  const double per_size = per_cell_size("choose_index", size);
  std::vector<CellSpan<axes>> spans;
  double copies = 0;
  for (const Box& b : sample) {
    spans.push_back(cells_of(b, per_size));
    copies += cell_count(spans.back());
  }
  const std::size_t axis = widest_axis(BoxSet<Box>{sample}, bounds);
  double pairs = 0, windows = 0, mates = 0;
  for (std::size_t i = 0; i < m; ++i) {
    const auto x = numbers_of(sample[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const auto y = numbers_of(sample[j]);
      pairs += boxes_meet(sample[i], sample[j], true) ? 1 : 0;
      windows += x[axis] <= y[axis + axes] && y[axis] <= x[axis + axes] ? 1 : 0;
      double shared = 1;
      for (std::size_t k = 0; k < axes; ++k) {
        const double from = std::max(spans[i].first[k], spans[j].first[k]);
        shared *= std::max(0.0, std::min(spans[i].last[k], spans[j].last[k]) - from + 1);
      }
      mates += shared;
    }
  }
  const auto sampled = static_cast<double>(m);
  const double to_all = (all - 1) / (sampled * (sampled - 1));  // so many boxes come after one for each pair here
  of[CountedThing::pairs] = pairs * to_all;
  of[CountedThing::windows] = windows * to_all;
  of[CountedThing::mates] = mates * to_all;
  of[CountedThing::copies] = copies / sampled;
  of.traits.pairs = of[CountedThing::pairs];
  return of;
}

}  // namespace plumb::space

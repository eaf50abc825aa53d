#include "plumb/space/broad_phase/choose_index.hpp"

#include <algorithm>
#include <string>

#include "plumb/arith/error.hpp"
#include "space/broad_phase/box_counts.hpp"
#include "space/broad_phase/measured_index.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace {

template <class Box>
IndexChoice chosen_index(std::span<const Box> boxes, const ChooseIndexOptions& options) {
  if (!(options.moving_share >= 0 && options.moving_share <= 1)) {
    throw InvalidShape("choose_index: options.moving_share is " + std::to_string(options.moving_share) +
                       ", but it must lie from 0 to 1");
  }
  space::check_boxes("choose_index", "boxes", boxes);
  const space::CountedBoxes counted = space::count_boxes(boxes, options.moving_share);
  IndexChoice choice{counted.traits, {}};
  for (const space::MethodCosts& of : space::method_costs()) {
    if (of.is_kept && (options.moving_share == 0 || space::axes_of<Box> == 2)) continue;
    const double predicted = space::predicted_cost(of, counted.counts);
    const auto same = std::find_if(choice.costs.begin(), choice.costs.end(), [&](const IndexCost& cost) {
      return cost.method == of.method && cost.is_kept == of.is_kept;
    });
    if (same == choice.costs.end()) {
      choice.costs.push_back({of.method, of.is_kept, predicted, {}});
    } else {
      same->predicted = std::min(same->predicted, predicted);
    }
  }
  std::stable_sort(choice.costs.begin(), choice.costs.end(),
                   [](const IndexCost& x, const IndexCost& y) { return x.predicted < y.predicted; });
  if (!options.measure || boxes.empty()) return choice;
  const auto n = static_cast<double>(boxes.size());
  for (IndexCost& cost : choice.costs) {
    if (cost.predicted * n > options.most_milliseconds * 1e6) continue;
    if constexpr (space::axes_of<Box> == 3) {
      if (cost.is_kept) {
        cost.measured = space::measured_nanoseconds_kept(cost.method, boxes, options.moving_share) / n;
        continue;
      }
    }
    cost.measured = space::measured_nanoseconds(cost.method, boxes) / n;
  }
  return choice;
}

}  // namespace

std::optional<IndexCost> IndexChoice::fastest() const {
  std::optional<IndexCost> least;
  for (const IndexCost& cost : costs) {
    if (cost.measured && (!least || *cost.measured < *least->measured)) least = cost;
  }
  return least;
}

IndexChoice choose_index(std::span<const Aabb2> boxes, const ChooseIndexOptions& options) {
  return chosen_index(boxes, options);
}
IndexChoice choose_index(std::span<const Aabb3> boxes, const ChooseIndexOptions& options) {
  return chosen_index(boxes, options);
}

}  // namespace plumb

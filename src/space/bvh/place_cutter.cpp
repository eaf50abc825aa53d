#include "space/bvh/place_cutter.hpp"

#include <algorithm>
#include <bit>

namespace plumb::space {

bool must_halve(const SlotRange& range, std::uint32_t most_in_leaf) {
  const std::uint32_t leaves = (range.size() - 1) / most_in_leaf;  // beside one
  return range.depth + static_cast<std::uint32_t>(std::bit_width(leaves)) >= most_tree_depth;
}

// Sorted, not by nth_element: the order on each side is then the same by every standard library.
void halve_along(std::size_t axis, std::span<BoxedItem> items) {
  std::sort(items.begin(), items.end(), [axis](const BoxedItem& a, const BoxedItem& b) {
    const float x = a.twice_middle(axis), y = b.twice_middle(axis);
    return x < y || (x == y && a.item < b.item);
  });
}

std::size_t longest_axis(const Extent& extent) {
  const Lanes side = extent.high - extent.low;
  std::size_t axis = side[1] > side[0] ? 1 : 0;
  return side[2] > side[axis] ? 2 : axis;
}

bool PlaceCutter::cut(const SlotRange& range, std::array<SlotRange, 2>& parts) const {
  if (range.size() <= std::min(options_.most_in_leaf, most_without_areas)) return false;
  const auto middle =
      range.begin + static_cast<std::uint32_t>(first_items(items_.subspan(range.begin, range.size()), range.depth));
  parts[0] = {range.begin, middle, range.depth + 1};
  parts[1] = {middle, range.end, range.depth + 1};
  return true;
}

std::size_t PlaceCutter::first_items(std::span<BoxedItem> items, std::uint32_t depth) const {
  Extent box, middles;
  for (const BoxedItem& item : items) {
    const Lanes middle = twice_middle(item.low(), item.high());
    box.take(item.low(), item.high());
    middles.take(middle, middle);
  }
  const bool by_space = options_.method == BvhMethod::spatial_median;
  const std::size_t axis = longest_axis(by_space ? box : middles);
  if (options_.method != BvhMethod::object_median &&
      !must_halve({0, static_cast<std::uint32_t>(items.size()), depth}, 1)) {
    double place = static_cast<double>(box.low[axis]) + static_cast<double>(box.high[axis]);
    if (!by_space) {
      double sum = 0;
      for (const BoxedItem& item : items) sum += static_cast<double>(item.twice_middle(axis));
      place = sum / static_cast<double>(items.size());
    }
    const auto at = std::stable_partition(items.begin(), items.end(), [&](const BoxedItem& item) {
      return static_cast<double>(item.twice_middle(axis)) < place;
    });
    if (at != items.begin() && at != items.end()) return static_cast<std::size_t>(at - items.begin());
  }
  halve_along(axis, items);
  return items.size() / 2;
}

}  // namespace plumb::space

#include "space/bvh/sweep_cutter.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "space/bvh/place_cutter.hpp"

namespace plumb::space {

SweepLists::SweepLists(std::span<const BoxedItem> all, const BvhOptions& o)
    : items(all), other(all.size()), behind(all.size()), first(all.size()), options(o) {
  for_blocks(options.execution, 3, 1, [&](std::size_t axis, std::size_t, std::size_t) {
    sorted[axis].resize(items.size());
    std::iota(sorted[axis].begin(), sorted[axis].end(), 0u);
    std::sort(sorted[axis].begin(), sorted[axis].end(), [&](std::uint32_t a, std::uint32_t b) {
      const float x = items[a].twice_middle(axis), y = items[b].twice_middle(axis);
      return x < y || (x == y && a < b);
    });
  });
}

bool SweepCutter::cut(const SlotRange& range, std::array<SlotRange, 2>& parts) const {
  const std::uint32_t n = range.size();
  if (n == 1) return false;
  const std::span<const BoxedItem> items = lists_.items;
  float least = std::numeric_limits<float>::infinity(), area = 0;
  std::size_t axis = 0;
  std::uint32_t middle = range.begin + n / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<std::uint32_t>& list = lists_.sorted[k];
    Extent box;
    for (std::uint32_t i = range.end; i-- > range.begin;) {
      box.take(items[list[i]].low(), items[list[i]].high());
      lists_.behind[i] = half_area(box);
    }
    area = lists_.behind[range.begin];
    box = Extent();
    for (std::uint32_t i = range.begin; i + 1 < range.end; ++i) {
      box.take(items[list[i]].low(), items[list[i]].high());
      const float cost = half_area(box) * static_cast<float>(i + 1 - range.begin) +
                         lists_.behind[i + 1] * static_cast<float>(range.end - i - 1);
      if (cost < least) {
        least = cost;
        axis = k;
        middle = i + 1;
      }
    }
  }
  const BvhOptions& options = lists_.options;
  const float as_leaf = options.item_cost * static_cast<float>(n) * area;
  if (n <= options.most_in_leaf && !(area + options.item_cost * least < as_leaf)) return false;
  if (must_halve(range, options.most_in_leaf)) middle = range.begin + n / 2;

  const std::vector<std::uint32_t>& chosen = lists_.sorted[axis];
  for (std::uint32_t i = range.begin; i < range.end; ++i) lists_.first[chosen[i]] = i < middle ? 1 : 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == axis) continue;
    std::vector<std::uint32_t>& list = lists_.sorted[k];
    std::uint32_t front = range.begin, back = range.begin;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const std::uint32_t item = list[i], is_first = lists_.first[item];
      list[front] = item;
      lists_.other[back] = item;
      front += is_first;
      back += 1 - is_first;
    }
    std::copy_n(lists_.other.begin() + range.begin, back - range.begin, list.begin() + front);
  }
  parts[0] = {range.begin, middle, range.depth + 1};
  parts[1] = {middle, range.end, range.depth + 1};
  return true;
}

}  // namespace plumb::space

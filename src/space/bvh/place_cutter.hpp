// Cutting at one place along the longest axis: at the median item, at the mean of the middles, or half way.
//
// Source: RTCD 6.2.1.
// Cost: linear in a range for a cut.
#pragma once

#include <span>

#include "space/bvh/grown_tree.hpp"

namespace plumb::space {

class PlaceCutter {
 public:
  PlaceCutter(std::span<BoxedItem> items, const BvhOptions& options) : items_(items), options_(options) {}

  bool cut(const SlotRange& range, std::array<SlotRange, 2>& parts) const;

 private:
  [[nodiscard]] std::size_t first_items(std::span<BoxedItem> items, std::uint32_t depth) const;

  std::span<BoxedItem> items_;
  BvhOptions options_;
};

/// Must what is left of the depth go to halves, so that leaves are reached in time?
bool must_halve(const SlotRange& range, std::uint32_t most_in_leaf);

/// Half of the items, by their middles along an axis, before the others; equal ones by their numbers.
void halve_along(std::size_t axis, std::span<BoxedItem> items);

std::size_t longest_axis(const Extent& extent);

}  // namespace plumb::space

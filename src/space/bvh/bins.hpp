// Where is a range of items best cut in two?  By bins along each axis, and the surface-area heuristic.
//
// Laws: the answer is that of the items as a set; bins of parts, merged in one order, are the bins of all.
// Source: Wald 2007, On fast construction of SAH-based bounding volume hierarchies.
// Cost: a few nanoseconds an item; for each cut looked at (three times the bins less one) two areas.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "space/bvh/boxed_item.hpp"

namespace plumb::space {

/// Bins between the least and the greatest middle along each axis; none along an axis without extent.
class BinScale {
 public:
  BinScale(const Extent& middles, std::size_t items) : base_(middles.low) {
    count_ = static_cast<std::uint32_t>(std::min<std::size_t>(16, 4 + items / 20));
    const Lanes range = middles.high - middles.low;
    // A little less than the count, so that rounding never reaches it.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // What is flatter has no bins: a guess, which shapes the tree and decides nothing.
      if (range[axis] > 1e-30F) scale_[axis] = 0.999F * static_cast<float>(count_) / range[axis];
    }
  }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] bool has(std::size_t axis) const { return scale_[axis] != 0; }

  [[nodiscard]] IntLanes bins_of(Lanes twice_middles) const {
    return __builtin_convertvector((twice_middles - base_) * scale_, IntLanes);
  }
  [[nodiscard]] std::uint32_t bin_of(const BoxedItem& item, std::size_t axis) const {
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>((item.twice_middle(axis) - base_[axis]) * scale_[axis]));
  }

 private:
  std::uint32_t count_;
  Lanes base_, scale_ = {};
};

/// The items of lower bins along the axis go first.
struct BinCut {
  float cost;  // areas times items
  std::size_t axis;
  std::uint32_t bin;
  std::uint32_t first_items;
  Extent first, second;  // the boxes
};

class Bins {
 public:
  void clear(std::uint32_t count) {
    count_ = count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill_n(box_[axis].begin(), count, Extent());
      std::fill_n(items_[axis].begin(), count, 0u);
    }
  }

  void take(const BinScale& scale, std::span<const BoxedItem> items) {
    for (const BoxedItem& item : items) {
      const Lanes low = item.low(), high = item.high();
      const IntLanes bin = scale.bins_of(twice_middle(low, high));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto b = static_cast<std::size_t>(bin[axis]);
        box_[axis][b].take(low, high);
        ++items_[axis][b];
      }
    }
  }

  void merge(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t b = 0; b < count_; ++b) {
        box_[axis][b].take(other.box_[axis][b]);
        items_[axis][b] += other.items_[axis][b];
      }
    }
  }

  /// How many items lie in lower bins.
  [[nodiscard]] std::uint32_t items_below(std::size_t axis, std::uint32_t bin) const {
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < bin; ++b) sum += items_[axis][b];
    return sum;
  }

  /// None where all items are in one bin of each axis.
  [[nodiscard]] std::optional<BinCut> best(const BinScale& scale) const {
    std::optional<BinCut> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (scale.has(axis)) improve(best, axis);
    }
    if (!best) return best;
    for (std::size_t b = 0; b < count_; ++b) (b < best->bin ? best->first : best->second).take(box_[best->axis][b]);
    return best;
  }

 private:
  static constexpr std::size_t most = 16;

  void improve(std::optional<BinCut>& best, std::size_t axis) const {
    std::array<float, most> behind;  // area times items of bins b, b + 1, ...
    Extent box;
    std::uint32_t items = 0;
    for (std::size_t b = count_ - 1; b > 0; --b) {
      box.take(box_[axis][b]);
      items += items_[axis][b];
      behind[b] = items == 0 ? -1 : half_area(box) * static_cast<float>(items);
    }
    box = Extent();
    items = 0;
    for (std::uint32_t b = 1; b < count_; ++b) {
      box.take(box_[axis][b - 1]);
      items += items_[axis][b - 1];
      if (items == 0 || behind[b] < 0) continue;
      const float cost = half_area(box) * static_cast<float>(items) + behind[b];
      if (!best || cost < best->cost) best = BinCut{cost, axis, b, items, Extent(), Extent()};
    }
  }

  std::uint32_t count_ = 0;
  std::array<std::array<Extent, most>, 3> box_;
  std::array<std::array<std::uint32_t, most>, 3> items_;
};

}  // namespace plumb::space

// Where is a range of items best cut in two?  By bins along each axis, and the surface-area heuristic.
//
// Laws: the answer is that of the items as a set; bins of parts, merged in one order, are the bins of all.
// Source: Wald 2007, On fast construction of SAH-based bounding volume hierarchies.
// Cost: a few nanoseconds an item; for each cut looked at (three times the bins less one) two areas.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>

#include "space/bvh/boxed_item.hpp"

namespace plumb::space {

/// Bins between the least and the greatest middle along each axis; none along an axis without extent.
class BinScale {
 public:
  BinScale(const Extent& middles, std::size_t items) : base_(middles.low) {
    count_ = static_cast<std::uint32_t>(std::min<std::size_t>(most, least + items / items_a_bin));
    const Lanes range = middles.high - middles.low;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (range[axis] > flat_spread) scale_[axis] = below_count * static_cast<float>(count_) / range[axis];
    }
  }

  static constexpr std::size_t most = 16;

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
  // Guesses: few items need few bins, and more than the most no better cuts.
  static constexpr std::size_t least = 4, items_a_bin = 20;
  static constexpr float below_count = 0.999F;  // so that rounding never reaches the count

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
    for (std::size_t axis = 0; axis < 3; ++axis) std::fill_n(box_[axis].begin(), count, Extent());
    std::fill_n(items_.begin(), count, Counts{});
  }

  void take(const BinScale& scale, std::span<const BoxedItem> items) {
    for (const BoxedItem& item : items) take(scale, item);
  }

  void merge(const Bins& other) {
    for (std::size_t b = 0; b < count_; ++b) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box_[axis][b].take(other.box_[axis][b]);
        items_[b][axis] += other.items_[b][axis];
      }
    }
  }

  /// How many items lie in lower bins.
  [[nodiscard]] std::uint32_t items_below(std::size_t axis, std::uint32_t bin) const {
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < bin; ++b) sum += items_[b][axis];
    return sum;
  }

  /// None where all items are in one bin of each axis.
  [[nodiscard]] std::optional<BinCut> best(const BinScale& scale) const {
    constexpr float infinity = Extent::infinity;
    std::array<Lanes, most> behind;  // area times items of bins b, b + 1, ...: of the three axes; infinite for none
    Swept sum;
    for (std::size_t b = count_ - 1; b > 0; --b) behind[b] = sum.take(*this, b);
    sum = Swept();
    Lanes least = {infinity, infinity, infinity, infinity};
    IntLanes at{}, first_items{};
    for (std::uint32_t b = 1; b < count_; ++b) {
      const Lanes cost = sum.take(*this, b - 1) + behind[b];
      const IntLanes better = cost < least;
      least = better ? cost : least;
      at = better ? IntLanes{} + static_cast<std::int32_t>(b) : at;
      first_items = better ? sum.items : first_items;
    }
    std::size_t axis = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      if (scale.has(k) && least[k] < (axis == 3 ? infinity : least[axis])) axis = k;
    }
    if (axis == 3) return std::nullopt;
    BinCut best{
        least[axis], axis,    static_cast<std::uint32_t>(at[axis]), static_cast<std::uint32_t>(first_items[axis]),
        Extent(),    Extent()};
    for (std::size_t b = 0; b < count_; ++b) (b < best.bin ? best.first : best.second).take(box_[axis][b]);
    return best;
  }

 private:
  void take(const BinScale& scale, const BoxedItem& item) {
    const Lanes low = item.low(), high = item.high();
    const IntLanes bin = scale.bins_of(twice_middle(low, high));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t b = static_cast<std::uint32_t>(bin[axis]);
      box_[axis][b].take(low, high);
      ++items_[b][axis];
    }
  }

  static constexpr std::size_t most = BinScale::most;
  using Counts = std::array<std::uint32_t, 4>;  // of the three axes

  // What lies in bins one after the other, of the three axes at once.
  struct Swept {
    std::array<Extent, 3> box;
    IntLanes items{};

    // Area times items with those of another bin; infinite where there are none.
    Lanes take(const Bins& bins, std::size_t b) {
      IntLanes more;
      std::memcpy(&more, bins.items_[b].data(), sizeof more);
      items += more;
      std::array<Lanes, 3> side;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box[axis].take(bins.box_[axis][b]);
        side[axis] = box[axis].high - box[axis].low;
      }
      const Lanes xy = __builtin_shufflevector(side[0], side[1], 0, 4, 1, 5),
                  z = __builtin_shufflevector(side[0], side[1], 2, 6, 2, 6);
      const Lanes x = __builtin_shufflevector(xy, side[2], 0, 1, 4, 4),
                  y = __builtin_shufflevector(xy, side[2], 2, 3, 5, 5),
                  last = __builtin_shufflevector(z, side[2], 0, 1, 6, 6);
      const Lanes area = x * (y + last) + y * last;
      // All items on this side: whatever is said, the other side has none.
      const Lanes cost = area * __builtin_convertvector(items, Lanes);
      constexpr float infinity = Extent::infinity;
      return items == 0 ? Lanes{infinity, infinity, infinity, infinity} : cost;
    }
  };

  std::uint32_t count_ = 0;
  std::array<std::array<Extent, most>, 3> box_;
  std::array<Counts, most> items_;
};

}  // namespace plumb::space

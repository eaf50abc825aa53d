// How is a range of items cut in two?  By the best cut between bins; in halves where there is none or depth runs out.
//
// A cut copies a range from one of two arrays to the other, so that it takes no unforeseeable branch: first items from
// its front, second ones from its back.  The place of an item depends on no thread.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "space/bvh/bins.hpp"
#include "space/bvh/builders.hpp"
#include "space/bvh/grown_tree.hpp"

namespace plumb::space {

struct ItemRange : SlotRange {
  std::uint32_t array = 0;  // of the two: where its items are
  Extent box, middles;      // the middles doubled
};

/// What the cutters of all threads work on, each on ranges of its own.
struct CutArrays {
  std::array<std::vector<BoxedItem>, 2> items;
  BvhOptions options;

  CutArrays(std::vector<BoxedItem> all, const BvhOptions& o) : options(o) {
    items[1].resize(all.size());
    items[0] = std::move(all);
  }
  [[nodiscard]] std::span<BoxedItem> of(const ItemRange& range) {
    return std::span<BoxedItem>(items[range.array]).subspan(range.begin, range.size());
  }
  /// All items, in the first array.
  [[nodiscard]] ItemRange whole() const;
};

class ItemCutter {
 public:
  explicit ItemCutter(CutArrays& arrays) : arrays_(arrays), bins_(1) {}

  /// False where the range is best a leaf.
  bool cut(const ItemRange& range, std::array<ItemRange, 2>& parts);

 private:
  std::optional<BinCut> best_cut(const ItemRange& range, const BinScale& scale);
  void halve(const ItemRange& range, bool sorted, std::array<ItemRange, 2>& parts);
  void cut_at(const BinCut& at, const BinScale& scale, const ItemRange& range, std::array<ItemRange, 2>& parts);

  CutArrays& arrays_;
  std::vector<Bins> bins_;  // of each block
  Bins sum_;
};

}  // namespace plumb::space

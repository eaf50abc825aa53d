#include "space/bvh/item_cutter.hpp"

#include "space/bvh/parts.hpp"
#include "space/bvh/place_cutter.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t cut_block = 1 << 13;

struct BoxAndMiddles {
  Extent box, middles;
};

BoxAndMiddles extents(std::span<const BoxedItem> items) {
  BoxAndMiddles e;
  for (const BoxedItem& item : items) {
    const Lanes low = item.low(), high = item.high(), middle = twice_middle(low, high);
    e.box.take(low, high);
    e.middles.take(middle, middle);
  }
  return e;
}

/// Of the first and second items.
using Sides = std::array<Extent, 2>;

// Copies items to to[first] and onward, or to to[second] and backward; returns where their middles lie.  Places are
// chosen by masks: a compiler would make a jump of a condition, which nobody can foresee.
Sides copy_apart(const BinCut& at, const BinScale& scale, std::span<const BoxedItem> items, BoxedItem* to,
                 std::size_t first, std::size_t second) {
  const Extent nowhere;
  Sides middles;
  for (const BoxedItem& item : items) {
    const std::size_t is_first = scale.bin_of(item, at.axis) < at.bin ? 1 : 0, none_or_all = std::size_t{0} - is_first;
    to[second ^ ((first ^ second) & none_or_all)] = item;
    first += is_first;
    second -= 1 - is_first;
    const Lanes middle = twice_middle(item.low(), item.high());
    const IntLanes mask = IntLanes{} + static_cast<std::int32_t>(none_or_all);
    middles[0].take(mask ? middle : nowhere.low, mask ? middle : nowhere.high);
    middles[1].take(mask ? nowhere.low : middle, mask ? nowhere.high : middle);
  }
  return middles;
}

}  // namespace

ItemRange CutArrays::whole() const {
  const std::span<const BoxedItem> all(items[0]);
  std::vector<BoxAndMiddles> parts(blocks_of(all.size(), cut_block));
  for_blocks(options.execution, all.size(), cut_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    parts[b] = extents(all.subspan(from, to - from));
  });
  ItemRange range;
  range.begin = 0;
  range.end = static_cast<std::uint32_t>(all.size());
  for (const BoxAndMiddles& part : parts) {
    range.box.take(part.box);
    range.middles.take(part.middles);
  }
  return range;
}

bool ItemCutter::cut(const ItemRange& range, std::array<ItemRange, 2>& parts) {
  const std::uint32_t n = range.size();
  const BvhOptions& options = arrays_.options;
  // Two parts cost a node at least.
  if (n == 1 || (n <= options.most_in_leaf && options.item_cost * static_cast<float>(n) <= 1)) return false;
  const BinScale scale(range.middles, n);
  const std::optional<BinCut> best = best_cut(range, scale);
  if (n <= options.most_in_leaf) {
    if (!best) return false;
    const float area = half_area(range.box);
    if (!(area + options.item_cost * best->cost < options.item_cost * static_cast<float>(n) * area)) return false;
  }
  parts[0] = parts[1] = range;
  parts[0].depth = parts[1].depth = range.depth + 1;
  const bool deep = must_halve(range, options.most_in_leaf);
  if (!best || deep) {
    halve(range, deep, parts);
  } else {
    cut_at(*best, scale, range, parts);
  }
  return true;
}

std::optional<BinCut> ItemCutter::best_cut(const ItemRange& range, const BinScale& scale) {
  const std::span<const BoxedItem> items = arrays_.of(range);
  if (items.size() <= most_grown_by_one) {
    bins_[0].clear(scale.count());
    bins_[0].take(scale, items);
    return bins_[0].best(scale);
  }
  const std::size_t blocks = blocks_of(items.size(), cut_block);
  if (bins_.size() < blocks) bins_.resize(blocks);
  for_blocks(arrays_.options.execution, items.size(), cut_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    bins_[b].clear(scale.count());
    bins_[b].take(scale, items.subspan(from, to - from));
  });
  sum_ = bins_[0];
  for (std::size_t b = 1; b < blocks; ++b) sum_.merge(bins_[b]);
  return sum_.best(scale);
}

void ItemCutter::halve(const ItemRange& range, bool sorted, std::array<ItemRange, 2>& parts) {
  if (sorted) halve_along(longest_axis(range.middles), arrays_.of(range));
  const std::uint32_t half = range.size() / 2;
  parts[0].end = parts[1].begin = range.begin + half;
  for (ItemRange& part : parts) {
    const BoxAndMiddles e = extents(arrays_.of(part));
    part.box = e.box;
    part.middles = e.middles;
  }
}

void ItemCutter::cut_at(const BinCut& at, const BinScale& scale, const ItemRange& range,
                        std::array<ItemRange, 2>& parts) {
  const std::span<const BoxedItem> items = arrays_.of(range);
  parts[0].array = parts[1].array = 1 - range.array;
  const std::span<BoxedItem> to = arrays_.of(parts[0]);
  parts[0].end = parts[1].begin = range.begin + at.first_items;
  parts[0].box = at.first;
  parts[1].box = at.second;
  if (items.size() <= most_grown_by_one) {
    const Sides middles = copy_apart(at, scale, items, to.data(), 0, to.size() - 1);
    for (std::size_t side : {0u, 1u}) parts[side].middles = middles[side];
    return;
  }
  const std::size_t blocks = blocks_of(items.size(), cut_block);
  std::vector<std::size_t> first_before(blocks);
  for (std::size_t b = 1; b < blocks; ++b)
    first_before[b] = first_before[b - 1] + bins_[b - 1].items_below(at.axis, at.bin);
  std::vector<Sides> middles(blocks);
  for_blocks(arrays_.options.execution, items.size(), cut_block,
             [&](std::size_t b, std::size_t from, std::size_t until) {
               middles[b] = copy_apart(at, scale, items.subspan(from, until - from), to.data(), first_before[b],
                                       to.size() - 1 - (from - first_before[b]));
             });
  for (std::size_t side : {0u, 1u}) {
    parts[side].middles = Extent();
    for (const Sides& block : middles) parts[side].middles.take(block[side]);
  }
}

}  // namespace plumb::space

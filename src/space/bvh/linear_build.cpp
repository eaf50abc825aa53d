// By Morton codes: items are sorted along a curve through space, and cut where its cells are.
//
// Codes of 32 bits and halves of what has one code: no leaf is deeper than 32 + 31.
#include <bit>

#include "space/bvh/builders.hpp"
#include "space/bvh/grown_tree.hpp"
#include "space/bvh/morton_code.hpp"
#include "space/bvh/radix_sort.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t sort_block = 1 << 14;

/// Of codes in the upper halves of keys, sorted.
class CodeCutter {
 public:
  CodeCutter(std::span<const std::uint64_t> keys, std::uint32_t most_in_leaf)
      : keys_(keys), most_(std::min(most_in_leaf, most_without_areas)) {}

  bool cut(const SlotRange& range, std::array<SlotRange, 2>& parts) const {
    if (range.size() <= most_) return false;
    std::uint32_t middle = range.begin + range.size() / 2;
    const auto code = [&](std::uint32_t i) { return static_cast<std::uint32_t>(keys_[i] >> 32); };
    const std::uint32_t differ = code(range.begin) ^ code(range.end - 1);
    if (differ != 0) {
      const std::uint32_t bit = std::bit_floor(differ);
      std::uint32_t low = range.begin, high = range.end - 1;  // without the bit, with it
      while (high - low > 1) {
        const std::uint32_t between = low + (high - low) / 2;
        ((code(between) & bit) != 0 ? high : low) = between;
      }
      middle = high;
    }
    parts[0] = {range.begin, middle, range.depth + 1};
    parts[1] = {middle, range.end, range.depth + 1};
    return true;
  }

 private:
  std::span<const std::uint64_t> keys_;
  std::uint32_t most_;
};

// Codes in the upper halves, indices in the lower, sorted.
std::vector<std::uint64_t> sorted_codes(Execution execution, std::span<const BoxedItem> items) {
  const std::size_t n = items.size();
  std::vector<Extent> parts(blocks_of(n, sort_block));
  for_blocks(execution, n, sort_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Lanes middle = twice_middle(items[i].low(), items[i].high());
      parts[b].take(middle, middle);
    }
  });
  Extent middles;
  for (const Extent& part : parts) middles.take(part);
  const MortonCoder coder(middles);
  std::vector<std::uint64_t> keys(n);
  for_blocks(execution, n, sort_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      keys[i] = std::uint64_t{coder.code(twice_middle(items[i].low(), items[i].high()))} << 32 | i;
  });
  radix_sort_upper(execution, keys);
  return keys;
}

}  // namespace

std::vector<std::uint32_t> morton_order(Execution execution, std::span<const BoxedItem> items) {
  std::vector<std::uint32_t> order;
  for (const std::uint64_t key : sorted_codes(execution, items)) order.push_back(static_cast<std::uint32_t>(key));
  return order;
}

Built build_linear(const std::vector<BoxedItem>& items, const BvhOptions& options) {
  const std::vector<std::uint64_t> keys = sorted_codes(options.execution, items);
  Built built;
  built.items.resize(items.size());
  const auto leaf = [&](const SlotRange& range) {
    Extent box;
    for (std::uint32_t slot = range.begin; slot < range.end; ++slot) {
      const BoxedItem& item = items[static_cast<std::uint32_t>(keys[slot])];
      box.take(item.low(), item.high());
      built.items[slot] = item.item;
    }
    return box;
  };
  built.nodes = grow(
      options.execution, SlotRange{0, static_cast<std::uint32_t>(items.size())},
      [&] { return CodeCutter(keys, options.most_in_leaf); }, leaf);
  return built;
}

}  // namespace plumb::space

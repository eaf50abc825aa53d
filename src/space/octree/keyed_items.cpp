#include "space/octree/keyed_items.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "space/bvh/blocks.hpp"

namespace plumb::space {
namespace {

constexpr unsigned digit_bits = 11;
constexpr std::size_t digits = 1 << digit_bits;
constexpr std::size_t digit_block = 1 << 15;

/// By three digits, least first; stable.  Digits that all have in common are passed over.
void sort_by_digits(Execution execution, std::span<KeyedItem> items, std::span<KeyedItem> room,
                    const std::array<unsigned, 3>& shifts) {
  std::vector<std::array<std::uint32_t, digits>> counts(blocks_of(items.size(), digit_block));
  std::span<KeyedItem> from = items, to = room;
  for (const unsigned shift : shifts) {
    const auto digit = [shift](std::uint64_t key) { return key >> shift & (digits - 1); };
    for_blocks(execution, from.size(), digit_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      counts[b].fill(0);
      for (std::size_t i = begin; i < end; ++i) ++counts[b][digit(from[i].key)];
    });
    std::size_t in_common = 0;
    for (const auto& count : counts) in_common += count[digit(from[0].key)];
    if (in_common == from.size()) continue;
    std::uint32_t before = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      for (auto& count : counts) before += std::exchange(count[d], before);
    }
    for_blocks(execution, from.size(), digit_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) to[counts[b][digit(from[i].key)]++] = from[i];
    });
    std::swap(from, to);
  }
  if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
}

}  // namespace

void sort_by_key(Execution execution, std::vector<KeyedItem>& items) {
  if (items.empty()) return;
  constexpr unsigned told_apart = 64 - 3 * digit_bits;
  constexpr std::size_t few = 256;
  std::vector<KeyedItem> room(items.size());
  sort_by_digits(execution, items, room, {31, 42, 53});
  for (std::size_t begin = 0; begin < items.size();) {
    std::size_t end = begin + 1;
    while (end < items.size() && items[end].key >> told_apart == items[begin].key >> told_apart) ++end;
    const std::span<KeyedItem> run = std::span(items).subspan(begin, end - begin);
    if (run.size() > few) {
      sort_by_digits(execution, run, std::span(room).subspan(begin, run.size()), {0, 11, 20});
    } else if (run.size() > 1) {
      const auto before = [](const KeyedItem& a, const KeyedItem& b) {
        return a.key != b.key ? a.key < b.key : a.item < b.item;
      };
      std::sort(run.begin(), run.end(), before);
    }
    begin = end;
  }
}

}  // namespace plumb::space

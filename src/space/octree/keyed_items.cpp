#include "space/octree/keyed_items.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

constexpr unsigned digit_bits = 11;
constexpr std::size_t digits = 1 << digit_bits;
constexpr std::size_t digit_block = 1 << 15;

/// By these digits, least first; stable.  Digits that all have in common are passed over.  Are they in `room` then?
bool sort_by_digits(Execution execution, std::span<KeyedItem> items, std::span<KeyedItem> room,
                    std::span<const unsigned> shifts) {
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
  return from.data() != items.data();
}

}  // namespace

void sort_by_key(Execution execution, std::span<KeyedItem> items) {
  if (items.empty()) return;
  // So many of the upper bits that few keys have them in common, and then what these do not tell apart.
  constexpr std::size_t few_items = std::size_t{1} << 17, few = 256;
  constexpr std::array<unsigned, 3> upper{31, 42, 53};
  constexpr std::array<unsigned, 4> lower{0, 11, 22, 31};
  const bool two = items.size() <= few_items;
  const unsigned told_apart = upper[two ? 1 : 0];
  const auto place = std::make_unique_for_overwrite<KeyedItem[]>(items.size());
  const std::span<KeyedItem> room(place.get(), items.size());
  if (sort_by_digits(execution, items, room, std::span(upper).subspan(two ? 1 : 0)))
    std::copy(room.begin(), room.end(), items.begin());
  for (std::size_t begin = 0; begin < items.size();) {
    std::size_t end = begin + 1;
    while (end < items.size() && items[end].key >> told_apart == items[begin].key >> told_apart) ++end;
    const std::span<KeyedItem> run = items.subspan(begin, end - begin), aside = room.subspan(begin, end - begin);
    if (run.size() > few) {
      if (sort_by_digits(execution, run, aside, std::span(lower).first(two ? 4 : 3))) {
        std::copy(aside.begin(), aside.end(), run.begin());
      }
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

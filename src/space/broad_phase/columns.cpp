#include "space/broad_phase/columns.hpp"

#include <utility>

#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t column_block = 1 << 15;

/// Strips from and up to on both axes.
struct Reach {
  std::uint32_t from1, to1, from2, to2;
  [[nodiscard]] std::size_t copies() const { return std::size_t{to1 - from1 + 1} * (to2 - from2 + 1); }
};
Reach reach_of(const OrdinalBox& b, const std::array<std::uint32_t, 2>& strips) {
  return {strip_of(b.low[1], strips[0]), strip_of(b.high[1], strips[0]), strip_of(b.low[2], strips[1]),
          strip_of(b.high[2], strips[1])};
}

/// False, and nothing is made, where there are too many copies.
bool divide(Execution execution, std::span<const OrdinalBox> boxes, const std::array<std::uint32_t, 2>& strips,
            Columns& columns) {
  const std::size_t n = boxes.size(), most_copies = most_copies_of(n), count = std::size_t{strips[0]} * strips[1];
  const std::size_t blocks = blocks_of(n, column_block);
  std::vector<std::uint32_t> counts(blocks * count);
  std::vector<std::size_t> copies(blocks);
  for_blocks(execution, n, column_block, [&](std::size_t block, std::size_t from, std::size_t to) {
    std::uint32_t* const here = counts.data() + block * count;
    std::size_t made = 0;
    for (std::size_t i = from; i < to; ++i) {
      const Reach r = reach_of(boxes[i], strips);
      if ((made += r.copies()) > most_copies) break;
      for (std::uint32_t s = r.from1; s <= r.to1; ++s) {
        for (std::uint32_t t = r.from2; t <= r.to2; ++t) ++here[std::size_t{s} * strips[1] + t];
      }
    }
    copies[block] = made;
  });
  std::size_t all = 0;
  for (const std::size_t c : copies) all += c;
  if (all > most_copies) return false;
  columns.begin.resize(count + 1);
  std::uint32_t before = 0;
  for (std::size_t c = 0; c < count; ++c) {
    columns.begin[c] = before;
    for (std::size_t b = 0; b < blocks; ++b) before += std::exchange(counts[b * count + c], before);
  }
  columns.begin[count] = before;
  columns.boxes = std::make_unique_for_overwrite<OrdinalBox[]>(before);
  for_blocks(execution, n, column_block, [&](std::size_t block, std::size_t from, std::size_t to) {
    std::uint32_t* const next = counts.data() + block * count;
    for (std::size_t i = from; i < to; ++i) {
      const OrdinalBox& b = boxes[i];
      const Reach r = reach_of(b, strips);
      for (std::uint32_t s = r.from1; s <= r.to1; ++s) {
        for (std::uint32_t t = r.from2; t <= r.to2; ++t) {
          OrdinalBox& copy = columns.boxes[next[std::size_t{s} * strips[1] + t]++];
          copy = b;
          copy.marks |= (s != r.from1 ? 1 : 0) | (t != r.from2 ? 2 : 0);
        }
      }
    }
  });
  return true;
}

}  // namespace

Columns divide_into_columns(Execution execution, std::span<const OrdinalBox> boxes,
                            std::array<std::uint32_t, 2>& strips) {
  Columns columns;
  while (!divide(execution, boxes, strips, columns)) {
    for (std::uint32_t& s : strips) s = (s + 1) / 2;
  }
  return columns;
}

}  // namespace plumb::space

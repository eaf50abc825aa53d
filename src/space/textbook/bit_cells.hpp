// Implicit grid: a box has a bit in each row, column and layer that it reaches into; whole words are intersected.
//
// Source: RTCD 7.1.5.
#pragma once

#include <bit>

#include "space/bvh/parts.hpp"
#include "space/textbook/bit_rows.hpp"
#include "space/textbook/scheme.hpp"

namespace plumb::space {

inline std::size_t checked_rows(const AskedFunction& asked, std::size_t rows) {
  if (std::has_single_bit(rows) && rows <= std::size_t{1} << 30) return rows;
  throw InvalidShape(asked.text() + ": options.rows is " + std::to_string(rows) +
                     ", but it must be a power of two up to 2^30");
}

template <class Box>
class BitCells {
 public:
  static constexpr std::size_t n = axes_of<Box>;
  using Place = CellSpan<n>;
  using Stored = StoredBoxes<Box, Place>;

  BitCells(const AskedFunction& asked, const BoxStoreOptions<Box>& options)
      : row_count_(options.rows),
        most_memory_(options.most_memory),
        per_size_(per_cell_size(asked.text(), options.cell_size, "cell_size")),
        bits_(checked_rows(asked, options.rows)) {}

  [[nodiscard]] Place place_of(const Box& box) const { return cells_of(box, per_size_); }
  void make_room(const AskedFunction& asked, std::uint32_t handle, const Place&) {
    if (handle < bits_.slots()) return;
    const std::size_t slots = std::bit_ceil(std::size_t{handle} + 1);
    asked.require_memory(BitRows<n>::memory_of(row_count_, slots), most_memory_, "choose fewer rows");
    bits_.reserve(slots);
  }
  void put(std::uint32_t handle, const Place& span) { bits_.set(handle, span, true); }
  void take(std::uint32_t handle, const Place& span) { bits_.set(handle, span, false); }

  template <class Visit>
  void visit_near(const Box& box, bool, const Stored& stored, const Visit& visit) const {
    std::vector<std::uint64_t> both, one;
    bits_.for_common(place_of(box), 0, stored.boxes.numbers(), both, one,
                     [&](std::size_t i) { visit(static_cast<std::uint32_t>(i)); });
  }

  std::vector<BoxPair> pairs(const BoxPairOptions& options, const Stored& stored) const {
    std::vector<BoxPair> rows;
    const std::size_t all = stored.boxes.numbers();
    std::vector<std::vector<BoxPair>> found(blocks_of(all, boxes_in_part));
    for_blocks(options.execution, all, boxes_in_part, [&](std::size_t part, std::size_t from, std::size_t to) {
      std::vector<std::uint64_t> both, one;
      for (std::size_t i = from; i < to; ++i) {
        const auto a = static_cast<std::uint32_t>(i);
        if (!stored.boxes.contains(a)) continue;
        bits_.for_common(stored.places[a], i + 1, all, both, one, [&](std::size_t j) {
          const auto b = static_cast<std::uint32_t>(j);
          if (is_pair(stored.boxes[a], stored.boxes[b], options.touching)) found[part].push_back({a, b});
        });
      }
    });
    for (const auto& f : found) rows.insert(rows.end(), f.begin(), f.end());
    return rows;
  }

  static std::size_t parts() { return 1; }
  [[nodiscard]] std::size_t memory() const { return bits_.memory(); }

 private:
  std::size_t row_count_, most_memory_;
  double per_size_;
  BitRows<n> bits_;
};

}  // namespace plumb::space

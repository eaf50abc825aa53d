// Implicit grid: which boxes may reach into these rows, columns and layers?  A bit for each box in each of them.
//
// Nothing is kept of a cell: what reaches into it is in the bits of its row, its column and its layer, all three.  Rows
// are numbered modulo a power of two, so they go on without end; what meets only modulo it is left to the exact test.
// Source: RTCD 7.1.5.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/space/grid/detail/cell_span.hpp"

namespace plumb::space {

template <std::size_t n>
class BitRows {
 public:
  /// The number of rows along each axis, a power of two.
  explicit BitRows(std::size_t rows) : rows_(rows) {}

  [[nodiscard]] std::size_t slots() const { return words_ * 64; }
  [[nodiscard]] std::size_t memory() const { return bits_.size() * sizeof(std::uint64_t); }
  /// Of so many slots.
  [[nodiscard]] static double memory_of(std::size_t rows, std::size_t slots) {
    return static_cast<double>(n * rows) * static_cast<double>((slots + 63) / 64) * sizeof(std::uint64_t);
  }

  /// At least so many slots, none fewer than before.
  void reserve(std::size_t slots) {
    if (slots <= this->slots()) return;
    const std::size_t words = std::bit_ceil((slots + 63) / 64);
    std::vector<std::uint64_t> bits(n * rows_ * words, 0);
    for (std::size_t row = 0; row < n * rows_; ++row) {
      for (std::size_t w = 0; w < words_; ++w) bits[row * words + w] = bits_[row * words_ + w];
    }
    bits_.swap(bits);
    words_ = words;
  }

  void set(std::size_t slot, const CellSpan<n>& span, bool value) {
    for (std::size_t axis = 0; axis < n; ++axis) {
      for_rows(axis, span, [&](std::size_t row) {
        std::uint64_t& word = bits_[row * words_ + slot / 64];
        const std::uint64_t bit = std::uint64_t{1} << slot % 64;
        word = value ? word | bit : word & ~bit;
      });
    }
  }

  /// Calls visit(slot) for each, from a slot on, of which a bit is set along every axis; `both` and `one` are scratch.
  template <class Visit>
  void for_common(const CellSpan<n>& span, std::size_t from, std::size_t to, std::vector<std::uint64_t>& both,
                  std::vector<std::uint64_t>& one, const Visit& visit) const {
    const std::size_t begin = from / 64, end = (to + 63) / 64;
    if (begin >= end) return;
    both.resize(words_), one.resize(words_);
    for (std::size_t axis = 0; axis < n; ++axis) {
      std::uint64_t* const any = axis == 0 ? both.data() : one.data();
      bool first = true;
      for_rows(axis, span, [&](std::size_t row) {
        const std::uint64_t* const bits = bits_.data() + row * words_;
        if (first) {
          for (std::size_t w = begin; w < end; ++w) any[w] = bits[w];
        } else {
          for (std::size_t w = begin; w < end; ++w) any[w] |= bits[w];
        }
        first = false;
      });
      if (axis == 0) continue;
      for (std::size_t w = begin; w < end; ++w) both[w] &= one[w];
    }
    both[begin] &= ~std::uint64_t{0} << from % 64;
    for (std::size_t w = begin; w < end; ++w) {
      for (std::uint64_t rest = both[w]; rest != 0; rest &= rest - 1) {
        visit(w * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
      }
    }
  }

 private:
  template <class Visit>
  void for_rows(std::size_t axis, const CellSpan<n>& span, const Visit& visit) const {
    const std::int64_t first = span.first[axis], count = span.last[axis] - first + 1;
    const auto rows = static_cast<std::int64_t>(rows_);
    for (std::int64_t i = 0; i < (count < rows ? count : rows); ++i) {
      visit(axis * rows_ + static_cast<std::size_t>((first + i) & (rows - 1)));
    }
  }

  std::size_t rows_, words_ = 0;     // words of a row
  std::vector<std::uint64_t> bits_;  // row by row, axis by axis
};

}  // namespace plumb::space

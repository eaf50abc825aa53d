// Broad phase (self-join of a hierarchical grid, of a loose octree): which boxes overlap, of those that lie in cells of
// levels?  Level by level and row by row: each level's boxes with one another and with all of the lower levels.
//
// A box is in the cell of its level that has its min, and reaches no farther than the next along each axis.  So what it
// overlaps at its own level lies in its row of cells along x or in one beside it; and where it is put into cells of a
// higher level, as large ones as there are, the same holds there.  Rows are swept along x.
// Laws: (1) pairs are those of box_pair.hpp, of the boxes' numbers; they ascend by a, then by b.  (2) All that is asked
// of cells is that their numbers never fall as coordinates grow, and that no box reaches beyond the next cell.
// Source: RTCD 7.2.1, 7.5.2.
// Cost: a sort by x, and for each level that has a box two of all that are no higher; then some ns for each box that
// starts within another in rows that lie beside one another.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "space/pairs/pairs_in_order.hpp"
#include "space/pairs/swept_lists.hpp"

namespace plumb::space {

/// Of a cell, without the number along x: that along y, and in space that along z before it.
template <std::size_t n>
using RowNumber = std::array<std::int64_t, n - 1>;

template <class Box>
class LevelJoin {
 public:
  static constexpr std::size_t n = axes_of<Box>;

  /// Of boxes without an order, levels beside them; the larger a level, the larger its cells.
  LevelJoin(Execution execution, std::span<const SweptBox<Box>> boxes, std::span<const int> levels)
      : execution_(execution) {
    boxes_.reserve(boxes.size()), level_of_.reserve(boxes.size());
    for (const std::uint32_t i : order_of_starts(execution, boxes)) {
      boxes_.push_back(boxes[i]), level_of_.push_back(levels[i]);
      numbers_ = std::max<std::size_t>(numbers_, boxes[i].number + std::size_t{1});
    }
    for (const int level : levels) {  // of which there are few
      const auto at = std::lower_bound(levels_.begin(), levels_.end(), level);
      if (at == levels_.end() || *at != level) levels_.insert(at, level);
    }
  }

  /// row_of(box, level): where its min lies in cells of that level, which is not below its own.
  template <class RowOf>
  std::vector<BoxPair> pairs(bool touching, const RowOf& row_of, std::vector<BoxPair> rows) {
    return touching ? pairs_of<true>(row_of, std::move(rows)) : pairs_of<false>(row_of, std::move(rows));
  }

 private:
  struct Row {
    std::uint64_t key;
    std::size_t begin;
  };
  struct Rows {
    std::vector<SweptBox<Box>> boxes;  // row by row, each in the order of x
    std::vector<Row> rows;             // and one behind the last

    [[nodiscard]] std::span<const SweptBox<Box>> operator[](std::size_t row) const {
      return {boxes.data() + rows[row].begin, rows[row + 1].begin - rows[row].begin};
    }
    [[nodiscard]] std::size_t size() const { return rows.size() - 1; }
  };
  struct Placed {
    std::uint64_t key;
    std::uint32_t at;  // in boxes_
  };
  static constexpr std::size_t row_block = 64;

  /// A number for each row.  Those of the rows before and behind it differ by one; along z by `width`.
  struct Keys {
    RowNumber<n> least;
    std::uint64_t width;

    std::uint64_t operator()(const RowNumber<n>& row) const {
      std::uint64_t key = 0;
      if constexpr (n == 3) key = static_cast<std::uint64_t>(row[1] - least[1] + 1) * width;
      return key + static_cast<std::uint64_t>(row[0] - least[0] + 1);
    }
  };

  Rows rows_of(std::vector<Placed>& placed, std::uint64_t most_key) const {
    constexpr std::size_t few = 512;
    if (placed.size() < few) {
      std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.key < b.key; });
    } else {
      std::vector<Placed> room(placed.size());
      radix_sort(execution_, placed.size(), static_cast<int>(std::bit_width(most_key) + 10) / 11, placed, room,
                 [](const Placed& p) { return p.key; });
    }
    Rows rows;
    rows.boxes.reserve(placed.size());
    for (const Placed& p : placed) {
      if (rows.rows.empty() || rows.rows.back().key != p.key) rows.rows.push_back({p.key, rows.boxes.size()});
      rows.boxes.push_back(boxes_[p.at]);
    }
    rows.rows.push_back({std::numeric_limits<std::uint64_t>::max(), placed.size()});
    return rows;
  }

  /// A place in the rows that moves on with the keys that are asked for, which ascend.
  class Cursor {
   public:
    explicit Cursor(const Rows& rows) : rows_(rows) {}
    /// visit(row) of those whose keys are from low to high.
    template <class Visit>
    void between(std::uint64_t low, std::uint64_t high, const Visit& visit) {
      const auto first = rows_.rows.begin();
      if (is_new_) {
        const auto below = [](const Row& row, std::uint64_t key) { return row.key < key; };
        at_ = static_cast<std::size_t>(std::lower_bound(first, rows_.rows.end() - 1, low, below) - first);
        is_new_ = false;
      }
      while (rows_.rows[at_].key < low) ++at_;
      for (std::size_t row = at_; row < rows_.size() && rows_.rows[row].key <= high; ++row) visit(row);
    }

   private:
    const Rows& rows_;
    std::size_t at_ = 0;
    bool is_new_ = true;
  };

  template <bool touching, class RowOf>
  std::vector<BoxPair> pairs_of(const RowOf& row_of, std::vector<BoxPair> rows) {
    for (const int level : levels_) join<touching>(level, row_of);
    return pairs_in_order(found_, numbers_, std::move(rows));
  }

  /// Of boxes of this level with one another and with those of lower ones.
  template <bool touching, class RowOf>
  void join(int level, const RowOf& row_of) {
    std::vector<RowNumber<n>> numbers(boxes_.size());
    RowNumber<n> least{}, most{};
    bool is_first = true;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (level_of_[i] > level) continue;
      numbers[i] = row_of(boxes_[i], level);
      for (std::size_t k = 0; k + 1 < n; ++k) {
        least[k] = is_first ? numbers[i][k] : std::min(least[k], numbers[i][k]);
        most[k] = is_first ? numbers[i][k] : std::max(most[k], numbers[i][k]);
      }
      is_first = false;
    }
    const Keys key_of{least, static_cast<std::uint64_t>(most[0] - least[0]) + 3};
    std::vector<Placed> own, lower;
    own.reserve(boxes_.size()), lower.reserve(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (level_of_[i] > level) continue;
      (level_of_[i] == level ? own : lower).push_back({key_of(numbers[i]), static_cast<std::uint32_t>(i)});
    }
    const std::uint64_t most_key = key_of(most), width = key_of.width;
    const Rows owns = rows_of(own, most_key), lowers = rows_of(lower, most_key);
    by_rows(owns, [&](std::size_t from, std::size_t to, const auto& take) {
      Cursor beside(owns), behind(owns);
      for (std::size_t row = from; row < to; ++row) {
        const auto with = [&](std::size_t other) { sweep_between<touching, 0>(owns[row], owns[other], take); };
        const std::uint64_t key = owns.rows[row].key;
        sweep_within<touching, 0>(owns[row], take);
        beside.between(key + 1, key + 1, with);
        if constexpr (n == 3) behind.between(key + width - 1, key + width + 1, with);
      }
    });
    by_rows(lowers, [&](std::size_t from, std::size_t to, const auto& take) {
      Cursor before(owns), beside(owns), behind(owns);
      for (std::size_t row = from; row < to; ++row) {
        const auto with = [&](std::size_t other) { sweep_between<touching, 0>(lowers[row], owns[other], take); };
        const std::uint64_t key = lowers.rows[row].key;
        if constexpr (n == 3) before.between(key - width - 1, key - width + 1, with);
        beside.between(key - 1, key + 1, with);
        if constexpr (n == 3) behind.between(key + width - 1, key + width + 1, with);
      }
    });
  }

  /// work(from, to, take) of rows, block by block.
  template <class Work>
  void by_rows(const Rows& rows, const Work& work) {
    const std::size_t before = found_.size();
    found_.resize(before + blocks_of(rows.size(), row_block));
    for_blocks(execution_, rows.size(), row_block, [&](std::size_t b, std::size_t from, std::size_t to) {
      std::vector<BoxPair>& pairs = found_[before + b];
      work(from, to, [&](std::uint32_t i, std::uint32_t j) { pairs.push_back({std::min(i, j), std::max(i, j)}); });
    });
  }

  Execution execution_;
  std::vector<SweptBox<Box>> boxes_;  // in the order of x
  std::vector<int> level_of_;
  std::vector<int> levels_;  // that have a box, ascending
  std::size_t numbers_ = 0;
  std::vector<std::vector<BoxPair>> found_;
};

}  // namespace plumb::space

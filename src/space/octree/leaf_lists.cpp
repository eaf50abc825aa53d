#include "space/octree/leaf_lists.hpp"

#include <algorithm>
#include <numeric>

#include "plumb/arith/error.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t list_block = 1 << 6;
constexpr std::size_t most_growth = 2;

template <std::size_t D>
using ChildCounts = std::array<std::uint32_t, std::size_t{1} << D>;

/// The items of a level's cells, one list after the other; nodes count theirs from there until all levels are cut.
using Lists = std::vector<std::uint32_t>;

template <std::size_t D>
class LeafLists {
 public:
  LeafLists(std::span<const PlaceRange<D>> boxes, const BoxOctreeOptions& options, CellTree<D>& tree)
      : boxes_(boxes),
        options_(options),
        tree_(tree),
        most_(options.most_references * static_cast<double>(boxes.size())) {}

  void list() {
    const unsigned deepest = std::min(options_.most_depth, CellFrame<D>::levels);
    tree_.nodes = {{1, 0, no_cell, 0, static_cast<std::uint32_t>(boxes_.size())}};
    levels_.emplace_back(boxes_.size());
    std::iota(levels_[0].begin(), levels_[0].end(), 0u);
    first_of_level_ = {0};
    references_ = boxes_.size();
    for (unsigned level = 0; level < deepest; ++level) {
      if (!cut(level)) break;
    }
    gather();
  }

 private:
  /// Cuts what is to be cut of a level's cells; was anything?
  bool cut(unsigned level) {
    const std::size_t first = first_of_level_[level], n = tree_.nodes.size() - first;
    std::vector<ChildCounts<D>> counts(n);
    for_blocks(options_.execution, n, list_block, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) counts[i] = counts_of(level, tree_.nodes[first + i]);
    });
    std::vector<std::uint32_t> begins(n);
    std::size_t total = 0, cells = tree_.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      CellNode& cell = tree_.nodes[first + i];
      const std::size_t sum = std::accumulate(counts[i].begin(), counts[i].end(), std::size_t{0});
      if (sum == 0 || static_cast<double>(references_ + sum - cell.count()) > most_) continue;
      references_ += sum - cell.count();
      begins[i] = static_cast<std::uint32_t>(total);
      total += sum;
      cell.children = static_cast<std::uint32_t>(cells);
      cells += children;
    }
    if (cells == tree_.nodes.size()) return false;
    if (cells >= no_cell || total >= no_cell) {
      throw InvalidShape("build_octree: more than 2^32 - 2 cells or references; lower options.most_references");
    }
    first_of_level_.push_back(tree_.nodes.size());
    tree_.nodes.resize(cells);
    Lists& next = levels_.emplace_back(total);
    for_blocks(options_.execution, n, list_block, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        if (!tree_.nodes[first + i].is_leaf()) fill(level, first + i, begins[i], counts[i], next);
      }
    });
    return true;
  }

  /// Of its children; all zero where it is not to be cut.
  ChildCounts<D> counts_of(unsigned level, const CellNode& cell) const {
    ChildCounts<D> counts{};
    if (cell.count() <= options_.most_in_leaf) return counts;
    each_child_of_item(level, cell, [&](std::uint32_t, std::size_t c) { ++counts[c]; });
    const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    return sum > most_growth * cell.count() ? ChildCounts<D>{} : counts;
  }

  void fill(unsigned level, std::size_t node, std::uint32_t begin, const ChildCounts<D>& counts, Lists& next) {
    const CellNode cell = tree_.nodes[node];
    ChildCounts<D> at;
    for (std::size_t c = 0; c < children; ++c) {
      at[c] = begin;
      tree_.nodes[cell.children + c] = {cell.code << D | c, 0, static_cast<std::uint32_t>(node), begin,
                                        begin + counts[c]};
      begin += counts[c];
    }
    each_child_of_item(level, cell, [&](std::uint32_t item, std::size_t c) { next[at[c]++] = item; });
  }

  template <class Take>
  void each_child_of_item(unsigned level, const CellNode& cell, const Take& take) const {
    const plumb::CellSpan<D> span = span_of<D>(cell.code);
    const Lists& items = levels_[level];
    for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
      const PlaceRange<D>& box = boxes_[items[i]];
      unsigned lower = 0, upper = 0;  // axes along which it meets that half
      for (std::size_t axis = 0; axis < D; ++axis) {
        const std::uint64_t middle = span.first[axis] + span.count / 2;
        lower |= (box.low[axis] < middle ? 1u : 0u) << axis;
        upper |= (box.high[axis] >= middle ? 1u : 0u) << axis;
      }
      for (unsigned c = 0; c < children; ++c) {
        if ((c & ~upper) == 0 && (~c & ((1u << D) - 1) & ~lower) == 0) take(items[i], c);
      }
    }
  }

  /// The leaves' lists one after the other, by code, so that those of any cell are a run.
  void gather() {
    std::vector<CellNode>& nodes = tree_.nodes;
    std::vector<std::uint32_t> begins(nodes.size()), counts(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;) {
      counts[i] = nodes[i].is_leaf() ? nodes[i].count() : 0;
      for (std::size_t c = 0; !nodes[i].is_leaf() && c < children; ++c) counts[i] += counts[nodes[i].children + c];
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::uint32_t begin = begins[i];
      for (std::size_t c = 0; !nodes[i].is_leaf() && c < children; ++c) {
        begins[nodes[i].children + c] = begin;
        begin += counts[nodes[i].children + c];
      }
    }
    tree_.items.resize(counts[0]);
    for (std::size_t i = 0, level = 0; i < nodes.size(); ++i) {
      if (level + 1 < first_of_level_.size() && i == first_of_level_[level + 1]) ++level;
      if (nodes[i].is_leaf()) {
        const auto from = levels_[level].begin();
        std::copy(from + nodes[i].begin, from + nodes[i].end, tree_.items.begin() + begins[i]);
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].begin = begins[i], nodes[i].end = begins[i] + counts[i];
  }

  static constexpr std::size_t children = std::size_t{1} << D;

  std::span<const PlaceRange<D>> boxes_;
  const BoxOctreeOptions& options_;
  CellTree<D>& tree_;
  double most_;
  std::size_t references_ = 0;
  std::vector<Lists> levels_;
  std::vector<std::size_t> first_of_level_;
};

}  // namespace

template <std::size_t D>
void list_in_leaves(std::span<const PlaceRange<D>> boxes, const BoxOctreeOptions& options, CellTree<D>& tree) {
  LeafLists<D>(boxes, options, tree).list();
}
template void list_in_leaves<2>(std::span<const PlaceRange<2>>, const BoxOctreeOptions&, CellTree<2>&);
template void list_in_leaves<3>(std::span<const PlaceRange<3>>, const BoxOctreeOptions&, CellTree<3>&);

}  // namespace plumb::space

// Broad phase (self-join of an octree): which boxes overlap, each of which is in the smallest cell that holds it?  From
// the root down, each cell with the boxes of the cells around it that reach into it.
//
// Laws: (1) pairs are those of box_pair.hpp: two boxes that meet are in cells of
// which one is the other or holds it, so the pair is found in the smaller one.  (2) Their order depends on the tree
// alone.
// Source: RTCD 7.3.2, 7.5.2.
// Cost: two sorts of a cell's boxes and of those that reach into it, some ns for each that starts within another along
// the axis of a sweep, and for each child of a cell and each box that is in it or reaches into it; numbers of the boxes
// that reach into the cells on one way down are kept.
#pragma once

#include <array>
#include <vector>

#include "plumb/space/octree/box_octree.hpp"
#include "space/octree/box_sides.hpp"
#include "space/pairs/swept_lists.hpp"

namespace plumb::space {

template <std::size_t D, bool touching>
class CellJoin {
 public:
  using Box = typename CellKinds<D>::Box;

  explicit CellJoin(const BoxCells<D>& tree) : tree_(tree), across_(tree.boxes.size()) {}

  /// Part by part, by the boxes' own numbers.
  std::vector<std::vector<BoxPair>> pairs(Execution execution) const {
    // The upper cells are parts of their own, and so is all that is in each cell below them.
    constexpr std::size_t upper_levels = D == 3 ? 2 : 3;
    std::vector<std::vector<BoxPair>> parts;
    if (tree_.cells.nodes.empty()) return parts;
    std::vector<Task> tasks{{0, {}}};
    for (std::size_t level = 0; level <= upper_levels && !tasks.empty(); ++level) {
      const bool is_last = level == upper_levels;
      const std::size_t before = parts.size();
      parts.resize(before + tasks.size());
      std::vector<std::vector<Task>> below(tasks.size());
      for_blocks(execution, tasks.size(), 1, [&](std::size_t t, std::size_t, std::size_t) {
        Lists lists(parts[before + t]);
        if (is_last) {
          join_below(tasks[t], lists);
        } else {
          join_cell(tasks[t].node, tasks[t].reaching, lists);
          for_children(tasks[t].node, lists, [&](std::uint32_t child, const std::vector<std::uint32_t>& reaching) {
            below[t].push_back({child, reaching});
          });
        }
      });
      tasks.clear();
      for (auto& some : below) tasks.insert(tasks.end(), some.begin(), some.end());
    }
    return parts;
  }

 private:
  static constexpr std::size_t children = std::size_t{1} << D, few = 96;
  using Swept = SweptBox<Box>;
  /// A cell, and the boxes of larger ones that reach into it.
  struct Task {
    std::uint32_t node;
    std::vector<std::uint32_t> reaching;
  };
  /// Of the cell that is looked at; memory that is used again.  Boxes are kept apart by the plane, square to which axis,
  /// that they lie across: those of one plane begin nearly in the same place along that axis.
  struct Lists {
    explicit Lists(std::vector<BoxPair>& to) : pairs(to) {}
    std::array<std::vector<Swept>, D> own, reaching;
    std::vector<std::uint32_t> of_child;
    std::vector<BoxPair>& pairs;
  };

  /// Along which boxes across planes square to these axes are swept: neither, where there is a third.
  static constexpr std::size_t sweep_axis(std::size_t a, std::size_t b) {
    if (a == b) return a == 0 ? 1 : 0;
    return D == 3 ? 3 - a - b : 0;
  }
  /// Its own boxes with one another and with those that reach into it.
  void join_cell(std::uint32_t node, std::span<const std::uint32_t> reaching, Lists& lists) const {
    const OwnItems own = own_items(tree_.cells, node);
    for (auto& list : lists.own) list.clear();
    for (auto& list : lists.reaching) list.clear();
    const CellNode& cell = tree_.cells.nodes[node];
    // The corner that all children have in common.
    const auto middle = coordinates(box_of(tree_.cells, cell.is_leaf() ? node : cell.children).max);
    for (std::uint32_t i = own.begin; i < own.end; ++i) {
      const Box& box = tree_.boxes[i];
      std::size_t across = 0;
      const auto low = coordinates(box.min), high = coordinates(box.max);
      while (across + 1 < D && !(low[across] < middle[across] && middle[across] <= high[across])) ++across;
      across_[i] = static_cast<std::uint8_t>(across);
      lists.own[across].push_back({box, i});
    }
    // Of few boxes one sweep for all is soonest done.
    if (own.end - own.begin + reaching.size() <= few) {
      for (std::size_t a = 1; a < D; ++a) {
        lists.own[0].insert(lists.own[0].end(), lists.own[a].begin(), lists.own[a].end());
        lists.own[a].clear();
      }
      for (const std::uint32_t i : reaching) lists.reaching[0].push_back({tree_.boxes[i], i});
      sweep_along<sweep_axis(0, 0)>(lists);
      return;
    }
    for (const std::uint32_t i : reaching) lists.reaching[across_[i]].push_back({tree_.boxes[i], i});
    sweep_along<0>(lists);
    sweep_along<1>(lists);
    if constexpr (D == 3) sweep_along<2>(lists);
  }

  template <std::size_t axis>
  void sweep_along(Lists& lists) const {
    const auto take = [&](std::uint32_t i, std::uint32_t j) {
      const std::uint32_t a = tree_.cells.items[i], b = tree_.cells.items[j];
      lists.pairs.push_back({std::min(a, b), std::max(a, b)});
    };
    for (std::size_t a = 0; a < D; ++a) {
      bool is_swept = false;
      for (std::size_t b = 0; b < D; ++b) is_swept |= sweep_axis(a, b) == axis;
      if (!is_swept) continue;
      std::sort(lists.own[a].begin(), lists.own[a].end(), starts_before<axis, Box>);
      std::sort(lists.reaching[a].begin(), lists.reaching[a].end(), starts_before<axis, Box>);
    }
    for (std::size_t a = 0; a < D; ++a) {
      const std::span<const Swept> own = lists.own[a];
      if (own.empty()) continue;
      if (sweep_axis(a, a) == axis) sweep_within<touching, axis>(own, take);
      for (std::size_t b = 0; b < D; ++b) {
        if (sweep_axis(a, b) != axis) continue;
        if (a < b) sweep_between<touching, axis>(own, std::span<const Swept>(lists.own[b]), take);
        sweep_between<touching, axis>(own, std::span<const Swept>(lists.reaching[b]), take);
      }
    }
  }

  /// Behind join_cell: visit(child, reaching) of each child that has boxes.
  template <class Visit>
  void for_children(std::uint32_t node, Lists& lists, const Visit& visit) const {
    const CellNode& cell = tree_.cells.nodes[node];
    if (cell.is_leaf()) return;
    for (std::size_t c = 0; c < children; ++c) {
      const auto child = static_cast<std::uint32_t>(cell.children + c);
      if (tree_.cells.nodes[child].count() == 0) continue;
      lists.of_child.clear();
      const Box held = box_of(tree_.cells, child);
      const auto add = [&](const std::vector<Swept>& list) {
        for (const Swept& b : list) {
          if (meet(held, b.box)) lists.of_child.push_back(b.number);
        }
      };
      for (const auto& list : lists.own) add(list);
      for (const auto& list : lists.reaching) add(list);
      visit(child, lists.of_child);
    }
  }

  /// All that is in the cell of a task; without recursion.
  void join_below(const Task& top, Lists& lists) const {
    struct Waiting {
      std::uint32_t node;
      std::size_t begin;  // of what reaches into it: to the end, when it is its turn
    };
    std::vector<Waiting> waiting{{top.node, 0}};
    std::vector<std::uint32_t> reaching = top.reaching;
    while (!waiting.empty()) {
      const auto [node, begin] = waiting.back();
      waiting.pop_back();
      join_cell(node, std::span(reaching).subspan(begin), lists);
      reaching.resize(begin);
      for_children(node, lists, [&](std::uint32_t child, const std::vector<std::uint32_t>& of_child) {
        waiting.push_back({child, reaching.size()});
        reaching.insert(reaching.end(), of_child.begin(), of_child.end());
      });
    }
  }

  const BoxCells<D>& tree_;
  mutable std::vector<std::uint8_t> across_;  // which axis: told of a cell's own boxes before its children ask
};

}  // namespace plumb::space

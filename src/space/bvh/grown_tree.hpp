// From a way to cut ranges to a tree: nodes in depth-first order, with boxes fitted from the leaves up.
//
// Ranges of many items are cut one after the other, by cutters that may themselves work in parallel; the small ranges
// that remain are trees of their own, grown in parallel and put together.  Which ranges are small depends on their items
// alone, so the tree depends on no thread.
// A cutter has cut(range, parts), which is false where the range is best a leaf and else gives two parts that are not
// empty; a Leaf writes the items of a range to their slots and returns their box.
#pragma once

#include <array>
#include <utility>

#include "space/bvh/builders.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {

/// Ranges of more items than this are cut before any tree is grown.
inline constexpr std::uint32_t most_grown_by_one = 1 << 14;

/// The most items in a leaf where no areas tell whether it would better be cut.
inline constexpr std::uint32_t most_without_areas = 4;

/// What every cutter's range has.
struct SlotRange {
  std::uint32_t begin, end;
  std::uint32_t depth = 0;
  std::uint32_t parent = no_parent;  // whose second child it is

  static constexpr std::uint32_t no_parent = 0xffffffff;
  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

/// The box of a node that is no leaf, from its children's.
inline void fit(std::span<BoxNode> nodes, std::size_t i) {
  BoxNode& node = nodes[i];
  const BoxNode &a = nodes[i + 1], &b = nodes[i + node.link];
  for (std::size_t k = 0; k < 3; ++k) {
    node.min[k] = b.min[k] < a.min[k] ? b.min[k] : a.min[k];
    node.max[k] = b.max[k] > a.max[k] ? b.max[k] : a.max[k];
  }
}

/// All of them, children before parents.
inline void fit_all(std::span<BoxNode> nodes) {
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!nodes[i].is_leaf()) fit(nodes, i);
  }
}

template <class Range, class Cutter, class Leaf>
std::vector<BoxNode> grow_one(const Range& whole, Cutter& cutter, const Leaf& leaf) {
  std::vector<BoxNode> nodes;
  nodes.reserve(whole.size());
  std::vector<Range> later{whole};
  later[0].parent = SlotRange::no_parent;
  std::array<Range, 2> parts{whole, whole};
  while (!later.empty()) {
    const Range now = later.back();
    later.pop_back();
    const auto index = static_cast<std::uint32_t>(nodes.size());
    if (now.parent != SlotRange::no_parent) nodes[now.parent].link = index - now.parent;
    if (cutter.cut(now, parts)) {
      nodes.push_back(BoxNode{});
      parts[0].parent = SlotRange::no_parent;
      parts[1].parent = index;
      later.push_back(parts[1]);
      later.push_back(parts[0]);
    } else {
      nodes.push_back(node_of(leaf(now), now.begin, now.size()));
    }
  }
  fit_all(nodes);
  return nodes;
}

/// Nodes above the small trees: where its children are in the list, or the number of a tree.
struct TopNode {
  std::uint32_t children = 0;  // the second is next
  std::uint32_t tree = 0;
};

/// One array of them, links between nodes being relative.
std::vector<BoxNode> put_together(Execution execution, const std::vector<TopNode>& top,
                                  std::vector<std::vector<BoxNode>> trees);

/// make_cutter() gives a cutter; they share what they cut, each ranges of its own.
template <class Range, class MakeCutter, class Leaf>
std::vector<BoxNode> grow(Execution execution, const Range& whole, const MakeCutter& make_cutter, const Leaf& leaf) {
  std::vector<TopNode> top(1);
  std::vector<Range> ranges{whole}, small;
  auto cutter = make_cutter();
  std::array<Range, 2> parts{whole, whole};
  for (std::size_t t = 0; t < top.size(); ++t) {
    if (ranges[t].size() > most_grown_by_one && cutter.cut(ranges[t], parts)) {
      top[t].children = static_cast<std::uint32_t>(top.size());
      for (const Range& part : parts) {
        top.emplace_back();
        ranges.push_back(part);
      }
    } else {
      top[t].tree = static_cast<std::uint32_t>(small.size());
      small.push_back(ranges[t]);
    }
  }
  std::vector<std::vector<BoxNode>> trees(small.size());
  for_blocks(execution, trees.size(), 1, [&](std::size_t t, std::size_t, std::size_t) {
    auto own = make_cutter();
    trees[t] = grow_one(small[t], own, leaf);
  });
  return put_together(execution, top, std::move(trees));
}

}  // namespace plumb::space

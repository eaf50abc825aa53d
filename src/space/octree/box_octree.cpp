#include "plumb/space/octree/box_octree.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "space/bvh/parts.hpp"
#include "space/octree/box_sides.hpp"
#include "space/octree/cell_join.hpp"
#include "space/octree/cell_keys.hpp"
#include "space/octree/cut_cells.hpp"
#include "space/octree/leaf_lists.hpp"
#include "space/pairs/boxes_meet.hpp"

namespace plumb {
namespace {

using space::KeyedItem, space::PlaceRange;

constexpr std::size_t box_block = 1 << 10;

template <std::size_t D>
using BoxOf = typename CellKinds<D>::Box;

/// The level of the smallest cell that has both corners.
template <std::size_t D>
unsigned level_in_common(const PlaceRange<D>& range) {
  std::uint32_t differ = 0;
  for (std::size_t axis = 0; axis < D; ++axis) differ |= range.low[axis] ^ range.high[axis];
  return CellFrame<D>::levels - static_cast<unsigned>(std::bit_width(differ));
}

template <std::size_t D>
BoxCells<D> cells_of_boxes(std::string_view function, std::span<const BoxOf<D>> boxes,
                           const BoxOctreeOptions& options) {
  const OctreeOptions cutting{options.most_in_leaf, options.most_depth, options.execution};
  space::check_octree_options(function, cutting, boxes.size());
  if (!(options.most_references >= 1 && options.most_references <= 1000)) {
    throw InvalidShape(std::string(function) + ": options.most_references is " +
                       std::to_string(options.most_references) + ", but it must lie from 1 to 1000");
  }
  space::check_cell_boxes(function, boxes);
  BoxCells<D> tree;
  tree.rule = options.rule;
  if (boxes.empty()) return tree;
  BoxOf<D> held = boxes[0];
  for (const BoxOf<D>& b : boxes) held = space::holding(held, b);
  tree.cells.frame = CellFrame<D>(held);
  std::vector<PlaceRange<D>> ranges(boxes.size());
  space::for_blocks(options.execution, boxes.size(), box_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) ranges[i] = space::range_of(tree.cells.frame, boxes[i]);
  });
  if (options.rule == CellRule::every_leaf) {
    space::list_in_leaves<D>(ranges, options, tree.cells);
  } else {
    std::vector<KeyedItem> keyed(boxes.size());
    space::for_blocks(options.execution, boxes.size(), box_block, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        keyed[i] = {space::key_of<D>(ranges[i].low, level_in_common<D>(ranges[i])), static_cast<std::uint32_t>(i)};
      }
    });
    space::sort_by_key(options.execution, keyed);
    tree.cells.nodes = space::cut_cells<D>(keyed, false, cutting);
    for (const KeyedItem& k : keyed) tree.cells.items.push_back(k.item);
  }
  for (const std::uint32_t item : tree.cells.items) tree.boxes.push_back(boxes[item]);
  return tree;
}

/// Does the cell begin no later than both boxes' common part, and end behind its beginning?  Of the leaves that two
/// boxes have in common it is so for one alone.
template <std::size_t D>
bool begins_in(const BoxOf<D>& cell, const BoxOf<D>& a, const BoxOf<D>& b) {
  const auto low = coordinates(cell.min), high = coordinates(cell.max), x = coordinates(a.min), y = coordinates(b.min);
  bool all = true;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double begin = std::max(x[axis], y[axis]);
    all &= low[axis] <= begin && begin < high[axis];
  }
  return all;
}

template <std::size_t D>
std::vector<std::uint32_t> found_boxes(const BoxCells<D>& tree, const BoxOf<D>& box, const InBoxOptions& options,
                                       std::vector<std::uint32_t> found) {
  found.clear();
  figure::require_finite_parts<decltype(box.min), decltype(box.max)>("in_box", {"box.min", "box.max"}, box.min,
                                                                     box.max);
  if (is_empty(box)) return found;
  space::visit_seen_cells(tree.cells, box, [&](std::uint32_t node) {
    if (tree.rule == CellRule::every_leaf && !tree.cells.nodes[node].is_leaf()) return;
    const OwnItems own = own_items(tree.cells, node);
    const BoxOf<D> cell = box_of(tree.cells, node);
    for (std::uint32_t i = own.begin; i < own.end; ++i) {
      if (!space::boxes_meet(box, tree.boxes[i], options.touching)) continue;
      if (tree.rule == CellRule::smallest_cell || begins_in<D>(cell, box, tree.boxes[i])) {
        found.push_back(tree.cells.items[i]);
      }
    }
  });
  std::sort(found.begin(), found.end());
  return found;
}

/// By CellRule::every_leaf.
template <std::size_t D>
struct PairFinder {
  const BoxCells<D>& tree;
  bool touching;

  [[nodiscard]] bool counts(std::uint32_t i, std::uint32_t j) const {
    return space::boxes_meet(tree.boxes[i], tree.boxes[j], touching);
  }
  void tell(std::uint32_t i, std::uint32_t j, std::vector<BoxPair>& pairs) const {
    const auto [a, b] = std::minmax(tree.cells.items[i], tree.cells.items[j]);
    pairs.push_back({a, b});
  }

  void in_leaf(std::uint32_t node, std::vector<BoxPair>& pairs) const {
    const CellNode& n = tree.cells.nodes[node];
    if (!n.is_leaf() || n.count() < 2) return;
    const BoxOf<D> cell = box_of(tree.cells, node);
    for (std::uint32_t i = n.begin; i < n.end; ++i) {
      for (std::uint32_t j = i + 1; j < n.end; ++j) {
        if (counts(i, j) && begins_in<D>(cell, tree.boxes[i], tree.boxes[j])) tell(i, j, pairs);
      }
    }
  }
};

template <std::size_t D>
std::vector<std::vector<BoxPair>> pairs_in_leaves(const BoxCells<D>& tree, const BoxPairOptions& options) {
  constexpr std::size_t pair_block = 64;
  const PairFinder<D> finder{tree, options.touching};
  const std::size_t n = tree.cells.nodes.size();
  std::vector<std::vector<BoxPair>> parts(space::blocks_of(n, pair_block));
  space::for_blocks(options.execution, n, pair_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    for (std::size_t node = from; node < to; ++node) finder.in_leaf(static_cast<std::uint32_t>(node), parts[b]);
  });
  return parts;
}

template <std::size_t D>
std::vector<BoxPair> found_pairs(const BoxCells<D>& tree, const BoxPairOptions& options, std::vector<BoxPair> pairs) {
  const std::vector<std::vector<BoxPair>> parts = tree.rule == CellRule::every_leaf ? pairs_in_leaves(tree, options)
                                                  : options.touching
                                                      ? space::CellJoin<D, true>(tree).pairs(options.execution)
                                                      : space::CellJoin<D, false>(tree).pairs(options.execution);
  pairs.clear();
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  pairs.reserve(count);
  for (const auto& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

}  // namespace

BoxOctree build_octree(std::span<const Aabb3> boxes, const BoxOctreeOptions& options) {
  return cells_of_boxes<3>("build_octree", boxes, options);
}
BoxQuadtree build_quadtree(std::span<const Aabb2> boxes, const BoxOctreeOptions& options) {
  return cells_of_boxes<2>("build_quadtree", boxes, options);
}
std::vector<std::uint32_t> in_box(const BoxOctree& tree, const Aabb3& box, const InBoxOptions& options,
                                  std::vector<std::uint32_t> rows) {
  return found_boxes<3>(tree, box, options, std::move(rows));
}
std::vector<std::uint32_t> in_box(const BoxQuadtree& tree, const Aabb2& box, const InBoxOptions& options,
                                  std::vector<std::uint32_t> rows) {
  return found_boxes<2>(tree, box, options, std::move(rows));
}
std::vector<BoxPair> overlapping_pairs(const BoxOctree& tree, const BoxPairOptions& options,
                                       std::vector<BoxPair> rows) {
  return found_pairs<3>(tree, options, std::move(rows));
}
std::vector<BoxPair> overlapping_pairs(const BoxQuadtree& tree, const BoxPairOptions& options,
                                       std::vector<BoxPair> rows) {
  return found_pairs<2>(tree, options, std::move(rows));
}

}  // namespace plumb

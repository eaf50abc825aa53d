#include "plumb/space/textbook/hybrid_index.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/space/kd_tree/split_range.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/parts.hpp"
#include "space/grid/fitting_cell_size.hpp"
#include "space/kd_tree/leaves_meeting.hpp"
#include "space/octree/box_sides.hpp"
#include "space/octree/octree_of.hpp"
#include "space/pairs/boxes_meet.hpp"

namespace plumb {
namespace space::hybrid {
namespace {

/// Where what two boxes have in common begins, where they meet.
template <class Box>
auto lowest_corner(const Box& a, const Box& b) {
  auto corner = coordinates(a.min);
  const auto other = coordinates(b.min);
  for (std::size_t k = 0; k < corner.size(); ++k) corner[k] = std::max(corner[k], other[k]);
  return corner;
}

/// What of it is in the closed cell.
template <class Box>
Box part_in(const Box& cell, const Box& box) {
  auto high = coordinates(box.max);
  const auto end = coordinates(cell.max);
  for (std::size_t k = 0; k < high.size(); ++k) high[k] = std::min(high[k], end[k]);
  return box_between(lowest_corner(cell, box), high);
}

/// Does this part tell of two boxes that meet?
template <class Box>
bool tells_of(const GridOfTrees<Box>& index, std::size_t cell, const Box& a, const Box& b) {
  return index.grid.cell_of_pair(a, b) == cell;
}
template <class Box>
bool tells_of(const TreeOfGrids<Box>& index, std::size_t leaf, const Box& a, const Box& b) {
  const auto low = coordinates(index.cells[leaf].min), high = coordinates(index.cells[leaf].max);
  const auto corner = lowest_corner(a, b);
  bool is_here = true;
  for (std::size_t k = 0; k < corner.size(); ++k) is_here &= low[k] <= corner[k] && corner[k] < high[k];
  return is_here;
}

/// What an index of a part answers: places of boxes that may meet, all that do among them.
template <std::size_t d, class Box>
std::vector<std::uint32_t> places_of(const BoxCells<d>& tree, const Box& box) {
  return in_box(tree, box);
}
template <class Box>
std::vector<std::uint32_t> places_of(const StaticGrid<Box>& grid, const Box& box) {
  return grid.in_box(box);
}
template <std::size_t d>
std::vector<BoxPair> pairs_of(const BoxCells<d>& tree) {
  return overlapping_pairs(tree, {.execution = Execution::serial});
}
template <class Box>
std::vector<BoxPair> pairs_of(const StaticGrid<Box>& grid) {
  return grid.overlapping_pairs({.execution = Execution::serial});
}

template <class Index, class Box>
void add_in_part(const Index& index, std::size_t part, const Box& box, const InBoxOptions& options,
                 std::vector<std::uint32_t>& found) {
  const auto items = index.items_in(part);
  const auto& boxes = index.boxes();
  const auto take = [&](std::uint32_t i) {
    if (tells_of(index, part, box, boxes[i])) found.push_back(i);
  };
  const std::uint32_t own = index.crowded.index_of[part];
  if (own == index.crowded.none) {
    for (const std::uint32_t i : items) {
      if (boxes_meet(box, boxes[i], options.touching)) take(i);
    }
  } else {
    for (const std::uint32_t place : places_of(index.crowded.indexes[own], box)) {
      // A part that only touches may be of a box that overlaps.
      if (options.touching || boxes_meet(box, boxes[items[place]], false)) take(items[place]);
    }
  }
}

template <class Index>
void add_pairs_in_part(const Index& index, std::size_t part, bool touching, std::vector<BoxPair>& pairs) {
  const auto items = index.items_in(part);
  const auto& boxes = index.boxes();
  const auto take = [&](std::uint32_t a, std::uint32_t b) {
    if (!touching && !boxes_meet(boxes[a], boxes[b], false)) return;
    if (tells_of(index, part, boxes[a], boxes[b])) pairs.push_back({a, b});
  };
  const std::uint32_t own = index.crowded.index_of[part];
  if (own == index.crowded.none) {
    for (std::size_t m = 0; m < items.size(); ++m) {
      for (std::size_t n = m + 1; n < items.size(); ++n) {
        if (boxes_meet(boxes[items[m]], boxes[items[n]], true)) take(items[m], items[n]);
      }
    }
  } else {
    for (const BoxPair& p : pairs_of(index.crowded.indexes[own])) take(items[p.a], items[p.b]);
  }
}

template <class Index>
std::vector<BoxPair> all_pairs(const Index& index, const BoxPairOptions& options, std::vector<BoxPair> pairs) {
  constexpr std::size_t block = 16;
  std::vector<std::vector<BoxPair>> found(blocks_of(index.parts(), block));
  for_blocks(options.execution, index.parts(), block, [&](std::size_t b, std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) add_pairs_in_part(index, part, options.touching, found[b]);
  });
  pairs.clear();
  for (const auto& f : found) pairs.insert(pairs.end(), f.begin(), f.end());
  return pairs;
}

/// make(part) of each part of many boxes.
template <class Index, class Make>
void index_crowded(Index& index, const HybridOptions& options, const Make& make) {
  std::vector<std::size_t> parts;
  for (std::size_t part = 0; part < index.parts(); ++part) {
    const bool is = index.items_in(part).size() > options.most_in_list;
    index.crowded.index_of.push_back(is ? static_cast<std::uint32_t>(parts.size()) : index.crowded.none);
    if (is) parts.push_back(part);
  }
  std::vector<std::optional<decltype(make(std::size_t{0}))>> made(parts.size());
  for_blocks(options.execution, parts.size(), 1,
             [&](std::size_t i, std::size_t, std::size_t) { made[i].emplace(make(parts[i])); });
  for (auto& m : made) index.crowded.indexes.push_back(*std::move(m));
}

template <class Box>
void check_hybrid(const std::string& function, std::span<const Box> boxes, const HybridOptions& options) {
  require_grid_boxes(function, boxes);
  if (options.grid.cell_size) (void)per_cell_size(function, *options.grid.cell_size);
  if (options.in_part == 0) throw InvalidShape(function + ": options.in_part is 0, but it must be at least 1");
}

/// The boxes of one, as many as are wanted in a cell on average; no fewer cells than those around a corner at zero.
template <class Box>
double size_of_parts(const std::string& function, std::span<const Box> boxes, std::uint32_t in_part) {
  const Box all = box_around(boxes);
  const double most = std::max(static_cast<double>(1 << axes_of<Box>), static_cast<double>(boxes.size()) / in_part);
  double size = fitting_cell_size(function, boxes, choose_cell_size(boxes).size, false);
  while (size < 0x1p1023 && cell_count(cells_of(all, per_cell_size(function, size))) > most) size *= 2;
  return size;
}

template <class Box>
void add_leaf_cells(const SplitTree<Box>& tree, std::uint32_t at, const Box& cell, std::vector<Box>& cells) {
  const SplitNode& n = tree.nodes[at];
  if (n.is_leaf()) {
    cells[n.link] = cell;
    return;
  }
  auto low = coordinates(cell.min), high = coordinates(cell.max);
  low[n.axis] = high[n.axis] = n.plane;
  add_leaf_cells(tree, at + 1, box_between(coordinates(cell.min), high), cells);
  add_leaf_cells(tree, n.link, box_between(low, coordinates(cell.max)), cells);
}

/// act(part) of each that the box may meet.
template <class Box, class Act>
void for_parts_meeting(const GridOfTrees<Box>& index, const Box& box, const Act& act) {
  for (const std::size_t cell : index.grid.cells_meeting(box)) act(cell);
}
template <class Box, class Act>
void for_parts_meeting(const TreeOfGrids<Box>& index, const Box& box, const Act& act) {
  kd::for_leaves_meeting(index.tree, box, act);
}

template <class Box>
std::size_t memory_of_parts(const GridOfTrees<Box>& index) {
  std::size_t bytes = index.grid.memory();
  for (const auto& tree : index.crowded.indexes) {
    bytes += sizeof(tree) + sizeof(Box) * tree.boxes.capacity() + sizeof(CellNode) * tree.cells.nodes.capacity() +
             sizeof(std::uint32_t) * tree.cells.items.capacity();
  }
  return bytes;
}
template <class Box>
std::size_t memory_of_parts(const TreeOfGrids<Box>& index) {
  std::size_t bytes = memory_of(index.tree) + sizeof(Box) * index.cells.capacity();
  for (const auto& grid : index.crowded.indexes) bytes += sizeof(grid) + grid.memory();
  return bytes;
}

}  // namespace
}  // namespace space::hybrid

template <class Box>
GridOfTrees<Box> build_grid_of_trees(std::span<const Box> boxes, const HybridOptions& options) {
  using namespace space;
  hybrid::check_hybrid("build_grid_of_trees", boxes, options);
  GridOptions grid = options.grid;
  if (!boxes.empty() && !grid.cell_size)
    grid.cell_size = hybrid::size_of_parts("build_grid_of_trees", boxes, options.in_part);
  GridOfTrees<Box> index{StaticGrid<Box>(boxes, grid), {}};
  hybrid::index_crowded(index, options, [&](std::size_t cell) {
    std::vector<Box> inside;
    for (const std::uint32_t i : index.items_in(cell)) inside.push_back(boxes[i]);
    return octree_of(inside, {.most_in_leaf = 16, .rule = CellRule::every_leaf, .execution = Execution::serial});
  });
  return index;
}

template <class Box>
TreeOfGrids<Box> build_tree_of_grids(std::span<const Box> boxes, const HybridOptions& options) {
  using namespace space;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  hybrid::check_hybrid("build_tree_of_grids", boxes, options);
  TreeOfGrids<Box> index;
  index.tree = build_split_tree(boxes, {.most_in_leaf = options.in_part, .execution = options.execution});
  index.cells.resize(index.parts());
  std::array<double, axes_of<Box>> low, high;
  low.fill(-infinite), high.fill(infinite);
  if (!boxes.empty()) hybrid::add_leaf_cells(index.tree, 0, box_between(low, high), index.cells);
  hybrid::index_crowded(index, options, [&](std::size_t leaf) {
    std::vector<Box> inside;
    for (const std::uint32_t i : index.items_in(leaf)) inside.push_back(hybrid::part_in(index.cells[leaf], boxes[i]));
    return StaticGrid<Box>(inside, options.grid);
  });
  return index;
}

template <HybridIndex Index>
std::vector<std::uint32_t> in_box(const Index& index, const typename Index::Figure& box, const InBoxOptions& options,
                                  std::vector<std::uint32_t> rows) {
  query::require_figure("in_box", "box", box);
  rows.clear();
  if (is_empty(box)) return rows;
  space::hybrid::for_parts_meeting(
      index, box, [&](std::size_t part) { space::hybrid::add_in_part(index, part, box, options, rows); });
  std::sort(rows.begin(), rows.end());
  return rows;
}
template <HybridIndex Index>
std::vector<BoxPair> overlapping_pairs(const Index& index, const BoxPairOptions& options, std::vector<BoxPair> rows) {
  return space::hybrid::all_pairs(index, options, std::move(rows));
}
template <HybridIndex Index>
std::size_t memory_of(const Index& index) {
  return space::hybrid::memory_of_parts(index) + sizeof(std::uint32_t) * index.crowded.index_of.capacity();
}

#define PLUMB_INSTANTIATE_INDEX(Index)                                                                        \
  template std::vector<std::uint32_t> in_box(const Index&, const Index::Figure&, const InBoxOptions&,         \
                                             std::vector<std::uint32_t>);                                     \
  template std::vector<BoxPair> overlapping_pairs(const Index&, const BoxPairOptions&, std::vector<BoxPair>); \
  template std::size_t memory_of(const Index&);
#define PLUMB_INSTANTIATE(Box)                                                               \
  template GridOfTrees<Box> build_grid_of_trees(std::span<const Box>, const HybridOptions&); \
  template TreeOfGrids<Box> build_tree_of_grids(std::span<const Box>, const HybridOptions&); \
  PLUMB_INSTANTIATE_INDEX(GridOfTrees<Box>)                                                  \
  PLUMB_INSTANTIATE_INDEX(TreeOfGrids<Box>)
PLUMB_INSTANTIATE(Aabb2)
PLUMB_INSTANTIATE(Aabb3)
#undef PLUMB_INSTANTIATE
#undef PLUMB_INSTANTIATE_INDEX

}  // namespace plumb

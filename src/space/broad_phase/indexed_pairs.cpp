#include "space/broad_phase/indexed_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/build.hpp"
#include "plumb/space/grid/static_grid.hpp"
#include "plumb/space/kd_tree/split_range.hpp"
#include "plumb/space/textbook/box_store.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/grid/fitting_cell_size.hpp"
#include "space/octree/octree_of.hpp"
#include "space/pairs/leaf_pairs.hpp"

namespace plumb::space {
namespace {

/// Boxes in the plane are as high as one another, so none of them is flat and all overlap along z.
Aabb3 in_space(const Aabb3& box) { return box; }
Aabb3 in_space(const Aabb2& b) { return {{b.min.x, b.min.y, 0}, {b.max.x, b.max.y, 1}}; }

template <class Box>
std::vector<Aabb3> all_in_space(std::span<const Box> boxes) {
  std::vector<Aabb3> all;
  all.reserve(boxes.size());
  for (const Box& b : boxes) all.push_back(in_space(b));
  return all;
}

template <class Box>
struct Search {
  const BroadPhaseOptions& options;
  std::span<const Box> a, b;
  const PairTaker& to;

  [[nodiscard]] bool is_one_set() const { return b.empty(); }
  [[nodiscard]] BoxPairOptions pair_options() const { return {options.touching, options.execution}; }
  [[nodiscard]] InBoxOptions in_box_options() const { return {options.touching}; }
  void tell(const std::vector<BoxPair>& pairs, double done) const {
    if (!pairs.empty()) to.take(to.to, pairs, done);
  }

  /// work(part, pairs) of each part of the work; what they find is told in their order.
  template <class Work>
  void by_parts(std::size_t parts, const Work& work) const {
    std::vector<std::vector<BoxPair>> found(parts);
    const auto tell_part = [&](std::size_t part) {
      tell(found[part], static_cast<double>(part + 1) / static_cast<double>(parts));
      found[part] = {};
    };
    for_blocks(options.execution, parts, 1, [&](std::size_t part, std::size_t, std::size_t) {
      work(part, found[part]);
      if (options.execution == Execution::serial) tell_part(part);
    });
    if (options.execution == Execution::serial) return;
    for (std::size_t part = 0; part < parts; ++part) tell_part(part);
  }

  /// Of two sets: found(box) tells which boxes of a make a pair with one of b.
  template <class Found>
  void ask(const Found& found) const {
    constexpr std::size_t in_part = 256;
    by_parts(blocks_of(b.size(), in_part), [&](std::size_t part, std::vector<BoxPair>& pairs) {
      for (std::size_t j = part * in_part, end = std::min(b.size(), j + in_part); j < end; ++j) {
        const auto number = static_cast<std::uint32_t>(a.size() + j);
        for (const std::uint32_t i : found(b[j])) pairs.push_back({i, number});
      }
    });
  }

  /// By a grid that is made.
  void by_grid(const StaticGrid<Box>& grid) const {
    if (is_one_set()) return tell(grid.overlapping_pairs(pair_options()), 1);
    ask([&](const Box& box) { return grid.in_box(box, in_box_options()); });
  }
  /// By a structure that boxes are put into: slots are their numbers.
  template <BoxScheme scheme>
  void by_filled(BoxStore<Box, scheme> store) const {
    for (const Box& box : a) store.insert(box);
    if (is_one_set()) {
      std::vector<BoxPair> pairs;
      for (const HandlePair& p : store.overlapping_pairs(pair_options())) pairs.push_back({p.a.slot, p.b.slot});
      return tell(pairs, 1);
    }
    ask([&](const Box& box) {
      std::vector<std::uint32_t> found;
      for (const BoxHandle& h : store.in_box(box, in_box_options())) found.push_back(h.slot);
      return found;
    });
  }

  [[nodiscard]] double cell_size(bool is_table) const {
    return fitting_cell_size("overlapping_pairs", a, choose_cell_size(a).size, is_table);
  }

  void by_octree(CellRule rule) const {
    const auto tree = octree_of(a, {.rule = rule, .execution = options.execution});
    if (is_one_set()) return tell(overlapping_pairs(tree, pair_options()), 1);
    ask([&](const Box& box) { return in_box(tree, box, in_box_options()); });
  }

  void by_kd_tree() const {
    const auto tree = build_split_tree(a, {.execution = options.execution});
    if (is_one_set()) return tell(overlapping_pairs(tree, pair_options()), 1);
    ask([&](const Box& box) { return in_box(tree, box, in_box_options()); });
  }

  void by_box_tree() const {
    const BoxTree tree = build_box_tree(all_in_space(a), {.execution = options.execution});
    const auto items = tree.items.view();
    if (!is_one_set()) {
      ask([&](const Box& box) {
        const auto [min, max] = tree.frame.around(in_space(box));
        const BoxNode asked{min, 0, max, 0};
        std::vector<std::uint32_t> found;
        const auto look = [&](std::uint32_t first, std::uint32_t count) {
          for (std::uint32_t s = first; s < first + count; ++s) {
            if (boxes_meet(a[items[s]], box, options.touching)) found.push_back(items[s]);
          }
        };
        descend(
            tree, [&](const BoxNode& node) { return nodes_meet(node, asked); }, look);
        std::sort(found.begin(), found.end());
        return found;
      });
      return;
    }
    constexpr std::size_t parts_wanted = 512;
    const auto nodes = tree.nodes.view();
    const auto replace = [&](const NodePair& pair, const auto& take) { replace_own_pair(nodes, pair, take); };
    const auto meets = [](const BoxNode& x, const BoxNode& y) { return &x == &y || nodes_meet(x, y); };
    const std::vector<NodePair> starts = pair_parts(nodes, nodes, parts_wanted, replace, meets);
    by_parts(starts.size(), [&](std::size_t part, std::vector<BoxPair>& pairs) {
      const auto look = [&](const BoxNode& x, const BoxNode& y) {
        for (std::uint32_t s = x.link; s < x.link + x.count; ++s) {
          for (std::uint32_t t = &x == &y ? s + 1 : y.link; t < y.link + y.count; ++t) {
            const auto [i, j] = std::minmax(items[s], items[t]);
            if (boxes_meet(a[i], a[j], options.touching)) pairs.push_back({i, j});
          }
        }
      };
      descend_from(nodes, nodes, starts[part], replace, meets, look);
    });
  }

  /// Along that of greatest variance, and those after it.  Boxes are put in in its order, each behind those before.
  void by_lists(int axes) const {
    const BoxSet<Box> set{a, b, options.touching};
    SetBounds bounds;
    (void)find_bounds(a, bounds);
    const std::size_t first = first_listed_axis(BoxSet<Box>{a}, bounds, static_cast<std::size_t>(axes));
    BoxStore<Box, BoxScheme::sweep_lists> lists({.lists = axes, .first_axis = static_cast<SweepAxis>(first)});
    std::vector<std::uint32_t> order(set.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto start = [&](std::uint32_t i) { return numbers_of(set[i])[first]; };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return start(i) < start(j) || (start(i) == start(j) && i < j); });
    for (const std::uint32_t i : order) lists.insert(set[i]);
    std::vector<BoxPair> pairs;
    for (const HandlePair& p : lists.overlapping_pairs(pair_options())) {
      const auto [i, j] = std::minmax(order[p.a.slot], order[p.b.slot]);
      if (is_one_set() || (i < a.size() && j >= a.size())) pairs.push_back({i, j});
    }
    tell(pairs, 1);
  }
};

}  // namespace

template <class Box>
void find_by_index(const BroadPhaseOptions& options, std::span<const Box> a, std::span<const Box> b,
                   const PairTaker& to) {
  using Method = BroadPhaseMethod;
  const Search<Box> search{options, a, b, to};
  switch (options.method) {
    case Method::static_grid:
      return search.by_grid(StaticGrid<Box>(a));
    case Method::linked_grid:
      return search.by_filled(LinkedGrid<Box>({.world = box_around(a), .cell_size = search.cell_size(false)}));
    case Method::hashed_grid:
      return search.by_filled(HashedGrid<Box>({.cell_size = search.cell_size(true)}));
    case Method::implicit_grid:
      return search.by_filled(ImplicitGrid<Box>({.cell_size = search.cell_size(true)}));
    case Method::hierarchical_grid:
      return search.by_filled(HierarchicalGrid<Box>());
    case Method::row_column_grid:
      return search.by_filled(RowColumnGrid<Box>());
    case Method::octree:
      return search.by_octree(CellRule::smallest_cell);
    case Method::octree_of_leaves:
      return search.by_octree(CellRule::every_leaf);
    case Method::loose_octree:
      return search.by_filled(LooseCells<Box>({.world = box_around(a)}));
    case Method::box_tree:
      return search.by_box_tree();
    case Method::lists_along_one:
      return search.by_lists(1);
    case Method::lists_along_two:
      return search.by_lists(2);
    case Method::lists_along_three:
      return search.by_lists(3);
    case Method::kd_tree:
      return search.by_kd_tree();
    case Method::automatic:
    case Method::swept_columns:
    case Method::sort_and_sweep:
    case Method::brute_force:
      break;
  }
  throw InvalidShape("overlapping_pairs: options.method is " + std::to_string(static_cast<int>(options.method)) +
                     ", which names none");
}

template void find_by_index(const BroadPhaseOptions&, std::span<const Aabb2>, std::span<const Aabb2>, const PairTaker&);
template void find_by_index(const BroadPhaseOptions&, std::span<const Aabb3>, std::span<const Aabb3>, const PairTaker&);

}  // namespace plumb::space

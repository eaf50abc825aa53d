#include "tool/pairs/shown_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/kd_tree/split_tree.hpp"
#include "space/broad_phase/swept_columns.hpp"
#include "space/grid/fitting_cell_size.hpp"
#include "space/octree/octree_of.hpp"
#include "space/textbook/levels.hpp"
#include "space/textbook/loose_tree.hpp"
#include "tool/pairs/method_names.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view kAxisNames = "xyz";

/// The least number on an axis that is not in an earlier strip, for each strip but the first.
std::vector<double> walls_on(const space::OrdinalMap& map, std::size_t k, std::uint32_t strips, double least,
                             double greatest) {
  std::vector<double> walls;
  const double enough = (greatest / 2 - least / 2) * 1e-4;
  for (std::uint32_t s = 1; s < strips; ++s) {
    double low = walls.empty() ? least : walls.back(), high = greatest;
    for (double middle = low / 2 + high / 2; low < middle && middle < high && high / 2 - low / 2 > enough;
         middle = low / 2 + high / 2) {
      (space::strip_of(map.ordinal(k, middle), strips) < s ? low : high) = middle;
    }
    walls.push_back(high);
  }
  return walls;
}

template <class Box>
ShownPart part_of_box(const Box& box, unsigned level) {
  ShownPart part;
  const auto x = space::numbers_of(box);
  constexpr std::size_t axes = space::axes_of<Box>;
  for (std::size_t k = 0; k < axes; ++k) part.min[k] = x[k], part.max[k] = x[k + axes];
  part.level = level;
  return part;
}

Aabb3 as_in_space(const Aabb3& box) { return box; }
Aabb3 as_in_space(const Aabb2& b) { return {{b.min.x, b.min.y, 0}, {b.max.x, b.max.y, 1}}; }

std::string cells_text(std::size_t count) { return plural(count, "cell", "cells"); }

/// Cells of grids that boxes reach into, each once.
template <std::size_t n>
class HeldCells {
 public:
  void add(int level, const space::CellSpan<n>& span) {
    space::for_cells(span, [&](const space::CellNumber<n>& cell) { held_.push_back({-level, cell}); });
    if (held_.size() < room_) return;
    keep_each_once();
    room_ = std::max(room_, 2 * held_.size());
  }
  /// size(level) is that of its cells.
  template <class Size>
  std::vector<ShownPart> parts(const Size& size) {
    keep_each_once();
    std::vector<ShownPart> parts;
    unsigned level = 0;
    for (std::size_t i = 0; i < held_.size(); ++i) {
      const auto& [down, cell] = held_[i];
      level += i > 0 && held_[i - 1].first != down ? 1 : 0;
      ShownPart part;
      part.level = level;
      for (std::size_t k = 0; k < n; ++k) {
        part.min[k] = cell[k] * size(-down);
        part.max[k] = (cell[k] + 1.0) * size(-down);
      }
      parts.push_back(part);
    }
    return parts;
  }

 private:
  void keep_each_once() {
    std::ranges::sort(held_);
    held_.erase(std::unique(held_.begin(), held_.end()), held_.end());
  }
  std::vector<std::pair<int, space::CellNumber<n>>> held_;  // large cells first
  std::size_t room_ = std::size_t{1} << 20;
};

/// Of sound boxes, at least one.
template <class Box>
struct Structure {
  static constexpr std::size_t n = space::axes_of<Box>;
  std::span<const Box> a, b;
  bool touching;

  [[nodiscard]] ShownStructure by_columns() const {
    const space::BoxSet<Box> set{a, b, touching};
    if (set.size() == 1) return {.says = "one box alone: there is nothing to sweep"};
    const space::SetBounds bounds = bounds_of_both();
    const auto [map, plan] = space::place_sweep(set, bounds);
    auto strips = plan.columns;
    std::vector<space::OrdinalBox> ordinals;
    for (std::size_t i = 0; i < set.size(); ++i) ordinals.push_back(map(set[i], i, 0));
    const space::Columns columns = space::divide_into_columns(Execution::parallel, ordinals, strips);
    const std::size_t axis = plan.order[0];
    if (columns.size() == 1)
      return sorted_along({axis}, fmt::format("swept along {}, without columns", kAxisNames[axis]));
    ShownStructure shown;
    shown.along = axis;
    for (std::size_t k = 1; k < 3; ++k) {
      const std::size_t across = plan.order[k];
      if (across >= n) continue;
      for (const double x : walls_on(map, k, strips[k - 1], bounds.min[across], bounds.max[across])) {
        ShownPart wall;
        wall.min[across] = wall.max[across] = x;
        shown.walls.push_back(wall);
      }
    }
    const double copies = static_cast<double>(columns.begin.back()) / static_cast<double>(set.size());
    shown.line = "a wall of columns";
    shown.says = fmt::format("{}, each swept along {}; a box stands in {:.3g} of them on the average",
                             plural(columns.size(), "column", "columns"), kAxisNames[axis], copies);
    return shown;
  }

  [[nodiscard]] ShownStructure by_sweep() const {
    const std::size_t axis = space::widest_axis(space::BoxSet<Box>{a, b, touching}, bounds_of_both());
    return sorted_along({axis}, fmt::format("sorted by starts along {} and swept", kAxisNames[axis]));
  }

  [[nodiscard]] ShownStructure by_lists(std::size_t lists) const {
    const std::size_t first = space::first_listed_axis(space::BoxSet<Box>{a}, bounds_of(a), lists);
    std::vector<std::size_t> axes;
    std::string names;
    for (std::size_t k = 0; k < std::min(lists, n); ++k) {
      axes.push_back((first + k) % 3);
      names += fmt::format("{}{}", k == 0 ? "" : ", ", kAxisNames[axes.back()]);
    }
    return sorted_along(axes, "lists of starts and ends along " + names);
  }

  [[nodiscard]] ShownStructure by_cells_of_one_size(bool is_table) const {
    const double size = space::fitting_cell_size("pairs", a, choose_cell_size(a).size, is_table);
    HeldCells<n> held;
    for (const Box& box : a) held.add(0, space::cells_of(box, space::per_cell_size("pairs", size)));
    ShownStructure shown{.line = "a cell", .cells = held.parts([&](int) { return size; })};
    shown.says = fmt::format("{} of side {:.4g}, those that a box reaches into", cells_text(shown.cells.size()), size);
    return shown;
  }

  [[nodiscard]] ShownStructure by_levels(std::string_view of) const {
    HeldCells<n> held;
    for (const Box& box : a) {
      const auto [level, span] = space::place_in_levels(box, space::least_level);
      held.add(level, span);
    }
    ShownStructure shown{.line = "a cell", .cells = held.parts([](int level) { return std::ldexp(1.0, level); })};
    shown.says =
        fmt::format("{} of {} sides, each twice the next or more{}: a box is in those of its size that it meets",
                    cells_text(shown.cells.size()), shown.cells.back().level + 1, of);
    return shown;
  }

  [[nodiscard]] ShownStructure by_octree(CellRule rule) const {
    const auto tree = space::octree_of(a, {.rule = rule});
    ShownStructure shown{.line = "a cell"};
    for (std::uint32_t i = 0; i < tree.cells.nodes.size(); ++i)
      shown.cells.push_back(part_of_box(box_of(tree.cells, i), level_of<n>(tree.cells.nodes[i].code)));
    shown.says =
        fmt::format("{}, inner ones and leaves; a box is in {}", cells_text(shown.cells.size()),
                    rule == CellRule::smallest_cell ? "the smallest that holds it" : "all leaves that it meets");
    return shown;
  }

  [[nodiscard]] ShownStructure by_loose_octree() const {
    const space::LooseTree<Box> tree({"pairs", {}}, {.world = space::box_around(a)});
    std::vector<std::uint64_t> codes;
    for (const Box& box : a) codes.push_back(tree.place_of(box).code);
    std::ranges::sort(codes);
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    ShownStructure shown{.line = "a cell"};
    for (const std::uint64_t code : codes) {
      const CellSpan<n> span = span_of<n>(code);
      ShownPart part;
      part.level = level_of<n>(code);
      for (std::size_t k = 0; k < n; ++k) {
        part.min[k] = tree.frame().border(k, span.first[k]);
        part.max[k] = tree.frame().border(k, span.first[k] + span.count);
      }
      shown.cells.push_back(part);
    }
    shown.says = fmt::format("{} that have boxes of their own, which may reach half a side beyond the lines",
                             cells_text(shown.cells.size()));
    return shown;
  }

  [[nodiscard]] ShownStructure by_box_tree() const {
    std::vector<Aabb3> boxes;
    for (const Box& box : a) boxes.push_back(as_in_space(box));
    const BoxTree tree = build_box_tree(boxes);
    const auto nodes = tree.nodes.view();
    ShownStructure shown{.line = "a box of the tree"};
    std::vector<std::pair<std::size_t, unsigned>> waiting{{0, 0}};
    std::size_t leaves = 0;
    while (!waiting.empty()) {
      const auto [i, level] = waiting.back();
      waiting.pop_back();
      ShownPart part = part_of_box(tree.frame.outside(nodes[i].box()), level);
      if (n == 2) part.min[2] = -ShownPart::far, part.max[2] = ShownPart::far;
      shown.cells.push_back(part);
      leaves += nodes[i].is_leaf() ? 1 : 0;
      if (!nodes[i].is_leaf()) waiting.insert(waiting.end(), {{i + 1, level + 1}, {i + nodes[i].link, level + 1}});
    }
    shown.says = fmt::format("a tree of boxes around boxes, {} of which are leaves", grouped(leaves));
    return shown;
  }

  [[nodiscard]] ShownStructure by_kd_tree() const {
    const auto tree = build_split_tree(a);
    ShownStructure shown{.line = "a plane of the tree"};
    std::vector<std::pair<std::size_t, ShownPart>> waiting{{0, ShownPart{}}};
    while (!waiting.empty()) {
      const auto [i, region] = waiting.back();
      waiting.pop_back();
      const SplitNode& node = tree.nodes[i];
      if (node.is_leaf()) continue;
      ShownPart wall = region, lower = region, upper = region;
      wall.min[node.axis] = wall.max[node.axis] = lower.max[node.axis] = upper.min[node.axis] = node.plane;
      lower.level = upper.level = region.level + 1;
      shown.walls.push_back(wall);
      waiting.insert(waiting.end(), {{i + 1, lower}, {node.link, upper}});
    }
    shown.says = fmt::format("{} divide space into {}; a box is in all that it meets",
                             plural(shown.walls.size(), "plane", "planes"), plural(tree.leaves(), "leaf", "leaves"));
    return shown;
  }

  [[nodiscard]] ShownStructure by(BroadPhaseMethod method) const {
    using Method = BroadPhaseMethod;
    switch (method) {
      case Method::swept_columns:
        return by_columns();
      case Method::sort_and_sweep:
        return by_sweep();
      case Method::static_grid:
      case Method::linked_grid:
        return by_cells_of_one_size(false);
      case Method::hashed_grid:
      case Method::implicit_grid:
        return by_cells_of_one_size(true);
      case Method::hierarchical_grid:
        return by_levels("");
      case Method::row_column_grid:
        return by_levels(", where rows and columns cross");
      case Method::octree:
        return by_octree(CellRule::smallest_cell);
      case Method::octree_of_leaves:
        return by_octree(CellRule::every_leaf);
      case Method::loose_octree:
        return by_loose_octree();
      case Method::box_tree:
        return by_box_tree();
      case Method::lists_along_one:
        return by_lists(1);
      case Method::lists_along_two:
        return by_lists(2);
      case Method::lists_along_three:
        return by_lists(3);
      case Method::kd_tree:
        return by_kd_tree();
      case Method::automatic:
      case Method::brute_force:
        break;
    }
    return {.says = "each pair is compared: nothing divides the boxes"};
  }

 private:
  static space::SetBounds bounds_of(std::span<const Box> boxes) {
    space::SetBounds bounds;
    space::find_bounds(boxes, bounds);
    return bounds;
  }
  [[nodiscard]] space::SetBounds bounds_of_both() const {
    space::SetBounds bounds = bounds_of(a);
    if (b.empty()) return bounds;
    const space::SetBounds of_b = bounds_of(b);
    for (std::size_t k = 0; k < n; ++k) {
      bounds.min[k] = std::min(bounds.min[k], of_b.min[k]);
      bounds.max[k] = std::max(bounds.max[k], of_b.max[k]);
    }
    return bounds;
  }
  static ShownStructure sorted_along(std::vector<std::size_t> axes, std::string says) {
    ShownStructure shown;
    shown.sorted_axes = std::move(axes);
    shown.says = std::move(says);
    return shown;
  }
};

template <class Box>
ShownStructure structure_of(const std::vector<Box>& a, std::span<const Box> b, bool touching, BroadPhaseMethod method) {
  if (a.empty()) return {.says = "there are no boxes to divide"};
  ShownStructure shown = Structure<Box>{a, b, touching}.by(method);
  std::ranges::stable_sort(shown.cells, {}, &ShownPart::level);
  std::ranges::stable_sort(shown.walls, {}, &ShownPart::level);
  return shown;
}

}  // namespace

BroadPhaseMethod method_taken(const PairsReport& r) {
  const std::size_t boxes = r.sets.front().size() + (r.of_one() ? 0 : r.sets.back().size());
  return space::method_taken(broad_phase_method(r.method), boxes);
}

ShownStructure shown_structure(const PairsReport& r) {
  const BoxInput &a = r.sets.front(), &b = r.sets.back();
  if (r.is_planar())
    return structure_of<Aabb2>(a.plane, r.of_one() ? std::span<const Aabb2>() : b.plane, r.touching, method_taken(r));
  return structure_of<Aabb3>(a.space, r.of_one() ? std::span<const Aabb3>() : b.space, r.touching, method_taken(r));
}

}  // namespace plumb::tool

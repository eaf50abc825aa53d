#include "plumb/space/kd_tree/figure_range.hpp"

#include "query/body/figure_input.hpp"
#include "space/bvh/parts.hpp"
#include "space/kd_tree/answer_lists.hpp"
#include "space/kd_tree/figures_meet.hpp"
#include "space/kd_tree/kept_figures.hpp"
#include "space/kd_tree/slot_figures.hpp"

namespace plumb {
namespace space::kd {
namespace {

constexpr std::size_t figure_block = 256;

// Lists that are appended ascend.

template <class Figure>
void add_figures_within(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p, double radius,
                        std::vector<std::uint32_t>& numbers) {
  const SlotFigures<Figure> items(tree);
  const std::size_t start = numbers.size();
  each_within(tree, items, p, radius, [&](std::uint32_t slot, double) { numbers.push_back(items.number(slot)); });
  sort_from(numbers, start);
}

template <class Figure>
void add_figures_in_box(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Box& box, bool touching,
                        std::vector<std::uint32_t>& numbers) {
  if (is_empty(box)) return;
  const std::size_t start = numbers.size();
  const Aabb3 asked = box_in_space(box);
  const FloatBox3 at = tree.tree.frame.around(asked);
  const auto meets = [&](const BoxNode& n) {
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k) all &= at.min[k] <= n.max[k] && n.min[k] <= at.max[k];
    return all;
  };
  descend(tree.tree, meets, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const Figure& figure = tree.figures[slot];
      if (boxes_meet(asked, box_in_space(figure)) && figures_meet(figure, box, touching)) {
        numbers.push_back(tree.tree.items[slot]);
      }
    }
  });
  sort_from(numbers, start);
}

/// A list of each of n.
template <class Add>
FigureLists listed(std::size_t n, Execution execution, FigureLists lists, const Add& add) {
  std::vector<ListBlock> blocks(blocks_of(n, figure_block));
  for_blocks(execution, n, figure_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    blocks[b] =
        asked_in_turn(to - from, [&](std::uint32_t i, std::vector<std::uint32_t>& numbers) { add(from + i, numbers); });
  });
  return put_together(n, figure_block, blocks, std::move(lists));
}

}  // namespace
}  // namespace space::kd

template <KeptFigure Figure>
std::vector<std::uint32_t> within(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p,
                                  double radius, std::vector<std::uint32_t> rows) {
  space::kd::require_radius(radius);
  query::require_figure("within", "p", p);
  rows.clear();
  space::kd::add_figures_within(tree, p, radius, rows);
  return rows;
}
template <KeptFigure Figure>
std::vector<std::uint32_t> in_box(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Box& box,
                                  const InBoxOptions& options, std::vector<std::uint32_t> rows) {
  query::require_figure("in_box", "box", box);
  rows.clear();
  space::kd::add_figures_in_box(tree, box, options.touching, rows);
  return rows;
}

template <KeptFigure Figure>
FigureLists within(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries,
                   double radius, Execution execution, FigureLists lists) {
  space::kd::require_radius(radius);
  require_finite_points("within", "queries", queries);
  return space::kd::listed(queries.size(), execution, std::move(lists),
                           [&](std::size_t i, std::vector<std::uint32_t>& numbers) {
                             space::kd::add_figures_within(tree, queries[i], radius, numbers);
                           });
}
template <KeptFigure Figure>
FigureLists in_box(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Box> boxes,
                   Execution execution, const InBoxOptions& options, FigureLists lists) {
  space::kd::require_finite_boxes(boxes);
  return space::kd::listed(boxes.size(), execution, std::move(lists),
                           [&](std::size_t i, std::vector<std::uint32_t>& numbers) {
                             space::kd::add_figures_in_box(tree, boxes[i], options.touching, numbers);
                           });
}

#define PLUMB_INSTANTIATE(F)                                                                                       \
  template std::vector<std::uint32_t> within(const FigureTree<F>&, const FigureTree<F>::Point&, double,            \
                                             std::vector<std::uint32_t>);                                          \
  template std::vector<std::uint32_t> in_box(const FigureTree<F>&, const FigureTree<F>::Box&, const InBoxOptions&, \
                                             std::vector<std::uint32_t>);                                          \
  template FigureLists within(const FigureTree<F>&, std::span<const FigureTree<F>::Point>, double, Execution,      \
                              FigureLists);                                                                        \
  template FigureLists in_box(const FigureTree<F>&, std::span<const FigureTree<F>::Box>, Execution,                \
                              const InBoxOptions&, FigureLists);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

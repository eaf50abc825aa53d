#include "plumb/space/kd_tree/figure_tree.hpp"

#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/build.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/closest/figure_box.hpp"
#include "space/kd_tree/kept_figures.hpp"

namespace plumb {
namespace space::kd {

template <class Figure>
std::vector<Aabb3> checked_boxes_of(std::string_view function, std::span<const Figure> figures, Execution execution) {
  std::vector<Aabb3> boxes(figures.size());
  constexpr std::size_t block_size = 1 << 14;
  std::vector<std::uint8_t> sound(blocks_of(figures.size(), block_size), 1);
  for_blocks(execution, figures.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      // The least of numbers says nothing of a NaN among them.
      if (!query::is_sound(figures[i]) || query::is_nothing(figures[i])) sound[b] = 0;
      boxes[i] = box_in_space(figures[i]);
    }
  });
  for (std::size_t b = 0; b < sound.size(); ++b) {
    if (sound[b] != 0) continue;
    for (std::size_t i = b * block_size; i < std::min(figures.size(), (b + 1) * block_size); ++i) {
      const std::string name = "figures[" + std::to_string(i) + "]";
      query::require_figure(function, name, figures[i]);
      if (query::is_nothing(figures[i]))
        throw InvalidShape(std::string(function) + ": " + name + " is empty; leave it out");
    }
  }
  return boxes;
}

#define PLUMB_INSTANTIATE(F) \
  template std::vector<Aabb3> checked_boxes_of(std::string_view, std::span<const F>, Execution);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace space::kd

template <KeptFigure Figure>
FigureTree<Figure> build_figure_tree(std::span<const Figure> figures, const KdTreeOptions& options) {
  const BvhOptions how{.most_in_leaf = options.most_in_leaf, .execution = options.execution};
  space::check_options("build_figure_tree", how);
  const auto boxes = space::kd::checked_boxes_of("build_figure_tree", figures, options.execution);
  FigureTree<Figure> tree{build_box_tree(boxes, how), {}};
  tree.figures.reserve(figures.size());
  for (const std::uint32_t item : tree.tree.items) tree.figures.push_back(figures[item]);
  return tree;
}

template <KeptFigure Figure>
std::size_t memory_of(const FigureTree<Figure>& tree) {
  return sizeof(BoxNode) * tree.tree.nodes.size() + sizeof(std::uint32_t) * tree.tree.items.size() +
         sizeof(Figure) * tree.figures.capacity();
}

#define PLUMB_INSTANTIATE(F)                                                          \
  template FigureTree<F> build_figure_tree(std::span<const F>, const KdTreeOptions&); \
  template std::size_t memory_of(const FigureTree<F>&);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

#include "plumb/space/kd_tree/nearest_figure.hpp"

#include <algorithm>

#include "query/body/figure_input.hpp"
#include "space/bvh/parts.hpp"
#include "space/kd_tree/answer_lists.hpp"
#include "space/kd_tree/kept_figures.hpp"
#include "space/kd_tree/slot_figures.hpp"

namespace plumb {
namespace space::kd {
namespace {

template <class Figure>
using NearestOf = Nearest<Unwatched, FigureTree<Figure>>;

/// k of each.
template <class Figure, class Point>
void nearest_figures(const FigureTree<Figure>& tree, std::span<const Point> queries, std::size_t k,
                     std::span<NearestFigure> out, Execution execution) {
  require_length(queries.size() * k, out.size());
  if (out.empty()) return;
  require_as_many(k, tree.figures.size(), "figure");
  require_finite_points("nearest", "queries", queries);
  constexpr std::size_t block = 256;
  for_blocks(execution, queries.size(), block, [&](std::size_t, std::size_t from, std::size_t to) {
    NearestOf<Figure> search(tree, k);
    NearestFigure* next = out.data() + from * k;
    for (std::size_t i = from; i < to; ++i) {
      for (const auto& c : search.of(queries[i])) *next++ = {c.item, c.distance};
    }
  });
}

}  // namespace
}  // namespace space::kd

template <KeptFigure Figure>
NearestFigure nearest(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p) {
  space::kd::require_as_many(1, tree.figures.size(), "figure");
  query::require_figure("nearest", "p", p);
  const auto found = space::kd::NearestOf<Figure>(tree, 1).of(p)[0];
  return {found.item, found.distance};
}

template <KeptFigure Figure>
std::vector<NearestFigure> nearest(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p,
                                   std::size_t k, Ties ties, std::vector<NearestFigure> rows) {
  query::require_figure("nearest", "p", p);
  rows.clear();
  k = std::min(k, tree.figures.size());
  if (k == 0) return rows;
  space::kd::NearestOf<Figure> search(tree, k);
  for (const auto& c : search.of(p)) rows.push_back({c.item, c.distance});
  if (ties == Ties::all) {
    // Of equally near ones the lowest are told already.
    const double distance = rows.back().distance;
    for (const std::uint32_t item : search.tied_with_last()) rows.push_back({item, distance});
  }
  return rows;
}

template <KeptFigure Figure>
void nearest(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries,
             std::span<NearestFigure> out, Execution execution) {
  space::kd::nearest_figures(tree, queries, 1, out, execution);
}
template <KeptFigure Figure>
void nearest(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries, std::size_t k,
             std::span<NearestFigure> out, Execution execution) {
  space::kd::nearest_figures(tree, queries, k, out, execution);
}

#define PLUMB_INSTANTIATE(F)                                                                                        \
  template NearestFigure nearest(const FigureTree<F>&, const FigureTree<F>::Point&);                                \
  template std::vector<NearestFigure> nearest(const FigureTree<F>&, const FigureTree<F>::Point&, std::size_t, Ties, \
                                              std::vector<NearestFigure>);                                          \
  template void nearest(const FigureTree<F>&, std::span<const FigureTree<F>::Point>, std::span<NearestFigure>,      \
                        Execution);                                                                                 \
  template void nearest(const FigureTree<F>&, std::span<const FigureTree<F>::Point>, std::size_t,                   \
                        std::span<NearestFigure>, Execution);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

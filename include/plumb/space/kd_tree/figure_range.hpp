// Range search: which of many boxes, segments or triangles come within a radius of p, which meet a box?
//
// Laws: (1) those whose distance from p is at most the radius, in real arithmetic; those that have a point in the
// closed box, as of intersects, or without touching overlap it, as of relate: in ascending order of their numbers.  (2)
// A batch answers each query as it is answered alone, on every number of threads.
// An inverted box meets nothing.  A negative radius throws InvalidShape, what is NaN or infinite NonFinite, by name.
// Source: RTCD 6.3.1.
// Cost: what is found, and the figures at the border, whose distances and separating axes are asked.  Bounded by n log
// n operations a query, the order of what is found, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/kd_tree/figure_tree.hpp"

namespace plumb {

/// Many lists of figures, one after the other.
using FigureLists = PointLists;

template <KeptFigure Figure>
std::vector<std::uint32_t> within(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p,
                                  double radius, std::vector<std::uint32_t> rows = {});
template <KeptFigure Figure>
std::vector<std::uint32_t> in_box(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Box& box,
                                  const InBoxOptions& options = {}, std::vector<std::uint32_t> rows = {});

template <KeptFigure Figure>
FigureLists within(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries,
                   double radius, Execution execution = Execution::parallel, FigureLists lists = {});
template <KeptFigure Figure>
FigureLists in_box(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Box> boxes,
                   Execution execution = Execution::parallel, const InBoxOptions& options = {}, FigureLists lists = {});

}  // namespace plumb

// Nearest neighbor: which of many boxes, segments or triangles are nearest to p, and how far are they?
//
//   const auto tree = build_figure_tree(triangles);
//   nearest(tree, p).index
//   nearest(tree, p, 5, Ties::all)       // what is exactly as near as the fifth as well
//   nearest(tree, points, out)           // of many points, with threads
//
// Laws: (1) nearer in real arithmetic comes first, of equally near figures that of the lower number: so the answer is
// that of a search through all figures.  A box, and a triangle of the plane, holds its inside, whose points are at
// distance 0.  (2) A distance is the double nearest to the exact one, as of distance(p, figure).  (3) A batch answers
// each query as it is answered alone, on every number of threads.
// (4) Of the k nearest there are as many as there are figures, where these are fewer.
// The nearest of no figures, and a batch of more than there are, throw InvalidShape; where `out` has not the batch's
// length, UnequalLengths; of a coordinate that is NaN or infinite NonFinite, which names the query.
// Source: RTCD 5.1.2, 5.1.3, 5.1.5, 6.3.2; branch and bound as in Roussopoulos, Kelley and Vincent 1995.
// Cost: log n where figures are scattered: docs/nearest.md.  A bound for each child of a node that is entered, rounded
// down; a distance for each figure whose box may be nearer; microseconds for a tie of figures that have not their
// nearest point or edge in common.  Bounded by n log n operations a point, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/kd_tree/figure_tree.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"

namespace plumb {

/// Its number, and how far it is.
using NearestFigure = NearestPoint;

template <KeptFigure Figure>
NearestFigure nearest(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p);
/// The k nearest, nearest first.
template <KeptFigure Figure>
std::vector<NearestFigure> nearest(const FigureTree<Figure>& tree, const typename FigureTree<Figure>::Point& p,
                                   std::size_t k, Ties ties = Ties::lowest, std::vector<NearestFigure> rows = {});

/// One of each query.
template <KeptFigure Figure>
void nearest(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries,
             std::span<NearestFigure> out, Execution execution = Execution::parallel);
/// k of each query, query by query.
template <KeptFigure Figure>
void nearest(const FigureTree<Figure>& tree, std::span<const typename FigureTree<Figure>::Point> queries, std::size_t k,
             std::span<NearestFigure> out, Execution execution = Execution::parallel);

}  // namespace plumb

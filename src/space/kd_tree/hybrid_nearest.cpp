#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/query/closest/closest.hpp"
#include "plumb/space/kd_tree/hybrid_index.hpp"
#include "query/body/figure_input.hpp"
#include "space/kd_tree/answer_lists.hpp"
#include "space/octree/box_sides.hpp"

namespace plumb {
namespace space::kd {
namespace {

template <class Box>
using CornerOf = std::remove_cvref_t<decltype(Box{}.min)>;

/// A box that holds the ball about p, and no number beyond doubles.
template <class Box>
Box box_around_ball(const CornerOf<Box>& p, double radius) {
  constexpr double most = std::numeric_limits<double>::max(), infinite = std::numeric_limits<double>::infinity();
  auto low = coordinates(p), high = low;
  for (std::size_t k = 0; k < low.size(); ++k) {
    low[k] = std::max(-most, std::nextafter(low[k] - radius, -infinite));
    high[k] = std::min(most, std::nextafter(high[k] + radius, infinite));
  }
  return box_between(low, high);
}

/// The boxes of these numbers, which ascend, and what is nearest among them.
template <class Box>
std::vector<NearestFigure> nearest_of(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& numbers,
                                      const CornerOf<Box>& p, std::size_t k, Ties ties,
                                      std::vector<NearestFigure> rows) {
  std::vector<Box> some;
  some.reserve(numbers.size());
  for (const std::uint32_t i : numbers) some.push_back(boxes[i]);
  std::vector<NearestFigure> found =
      nearest(build_figure_tree(some, {.execution = Execution::serial}), p, k, ties, std::move(rows));
  for (NearestFigure& f : found) f.index = numbers[f.index];
  return found;
}

/// Twice as far from time to time, until there are k; then all that may be as near as the farthest of the k nearest of
/// those.  How far it goes is a guess, that all are found is none: balls are put into boxes, and boxes found exactly.
template <class Index, class Box>
std::vector<NearestFigure> nearest_boxes(const Index& index, const CornerOf<Box>& p, std::size_t k, Ties ties,
                                         std::vector<NearestFigure> rows = {}) {
  rows.clear();
  const std::vector<Box>& boxes = index.boxes();
  query::require_figure("nearest", "p", p);
  k = std::min(k, boxes.size());
  if (k == 0) return rows;
  double bound = 0;  // k boxes are no farther, but for a rounding
  for (std::size_t i = 0; i < k; ++i) bound = std::max(bound, distance(p, boxes[i]));
  const double share = std::pow(static_cast<double>(k) / static_cast<double>(boxes.size()), 1.0 / axes_of<Box>);
  double radius = bound * share;
  std::vector<std::uint32_t> near = in_box(index, box_around_ball<Box>(p, radius));
  while (near.size() < k) {
    radius = radius > 0 ? 2 * radius : bound;
    near = in_box(index, box_around_ball<Box>(p, radius));
  }
  std::vector<NearestFigure> found = nearest_of(boxes, near, p, k, ties, std::move(rows));
  const double farthest = found[k - 1].distance;  // the nearest double to it
  if (farthest < radius) return found;
  near = in_box(index, box_around_ball<Box>(p, std::nextafter(farthest, std::numeric_limits<double>::infinity())));
  return nearest_of(boxes, near, p, k, ties, std::move(found));
}

}  // namespace
}  // namespace space::kd

template <class Box>
NearestFigure nearest(const GridOfTrees<Box>& index, const typename GridOfTrees<Box>::Point& p) {
  space::kd::require_as_many(1, index.boxes().size(), "figure");
  return space::kd::nearest_boxes<GridOfTrees<Box>, Box>(index, p, 1, Ties::lowest)[0];
}
template <class Box>
NearestFigure nearest(const TreeOfGrids<Box>& index, const typename TreeOfGrids<Box>::Point& p) {
  space::kd::require_as_many(1, index.boxes().size(), "figure");
  return space::kd::nearest_boxes<TreeOfGrids<Box>, Box>(index, p, 1, Ties::lowest)[0];
}
template <class Box>
std::vector<NearestFigure> nearest(const GridOfTrees<Box>& index, const typename GridOfTrees<Box>::Point& p,
                                   std::size_t k, Ties ties, std::vector<NearestFigure> rows) {
  return space::kd::nearest_boxes<GridOfTrees<Box>, Box>(index, p, k, ties, std::move(rows));
}
template <class Box>
std::vector<NearestFigure> nearest(const TreeOfGrids<Box>& index, const typename TreeOfGrids<Box>::Point& p,
                                   std::size_t k, Ties ties, std::vector<NearestFigure> rows) {
  return space::kd::nearest_boxes<TreeOfGrids<Box>, Box>(index, p, k, ties, std::move(rows));
}

#define PLUMB_INSTANTIATE(Box)                                                                                      \
  template NearestFigure nearest(const GridOfTrees<Box>&, const GridOfTrees<Box>::Point&);                          \
  template NearestFigure nearest(const TreeOfGrids<Box>&, const TreeOfGrids<Box>::Point&);                          \
  template std::vector<NearestFigure> nearest(const GridOfTrees<Box>&, const GridOfTrees<Box>::Point&, std::size_t, \
                                              Ties, std::vector<NearestFigure>);                                    \
  template std::vector<NearestFigure> nearest(const TreeOfGrids<Box>&, const TreeOfGrids<Box>::Point&, std::size_t, \
                                              Ties, std::vector<NearestFigure>);
PLUMB_INSTANTIATE(Aabb2)
PLUMB_INSTANTIATE(Aabb3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

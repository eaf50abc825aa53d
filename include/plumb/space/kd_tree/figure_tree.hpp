// Bounding volume hierarchy over figures: boxes, segments or triangles, each once, by their exact boxes.
//
//   const FigureTree<Segment2> streets = build_figure_tree(segments);
//   nearest(streets, p);  within(streets, p, 0.5);  in_box(streets, window);  // nearest_figure.hpp, figure_range.hpp
//
// Laws: (1) tree is a box tree (plumb/space/bvh/box_tree.hpp) of the figures' boxes, those of the plane in z = 0;
// figures are in the order of its slots.  (2) Degenerate figures are the sets that they are.  (3) The same figures make
// the same tree on every number of threads; any number of equal ones builds, and as fast.
// A coordinate that is NaN or infinite throws NonFinite, which names the figure; an empty box, more than 2^31 figures,
// leaves of no figure or of more than 255 throw InvalidShape.
// Source: RTCD 6.2.1.
// Cost: n log n; a figure, 4 bytes and some 11 bytes of nodes each.  Bounded by n log n operations.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/space/bvh/box_tree.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"
#include "plumb/space/kd_tree/point_range.hpp"

namespace plumb {

/// What such a tree is built of: Aabb2, Segment2, Triangle2 and those of space.
template <class Figure>
concept KeptFigure =
    std::is_same_v<Figure, Aabb2> || std::is_same_v<Figure, Segment2> || std::is_same_v<Figure, Triangle2> ||
    std::is_same_v<Figure, Aabb3> || std::is_same_v<Figure, Segment3> || std::is_same_v<Figure, Triangle3>;

template <KeptFigure Figure>
struct FigureTree {
  static constexpr std::size_t dimension =
      std::is_same_v<Figure, Aabb2> || std::is_same_v<Figure, Segment2> || std::is_same_v<Figure, Triangle2> ? 2 : 3;
  using Point = std::conditional_t<dimension == 2, Point2, Point3>;
  using Box = space::BoxOf<Point>;

  BoxTree tree;                 // whose items are the figures' numbers
  std::vector<Figure> figures;  // slot by slot
};

template <KeptFigure Figure>
FigureTree<Figure> build_figure_tree(std::span<const Figure> figures, const KdTreeOptions& options = {});
template <KeptFigure Figure>
FigureTree<Figure> build_figure_tree(const std::vector<Figure>& figures, const KdTreeOptions& options = {}) {
  return build_figure_tree(std::span<const Figure>(figures), options);
}

/// Bytes that its arrays take.
template <KeptFigure Figure>
std::size_t memory_of(const FigureTree<Figure>& tree);

}  // namespace plumb

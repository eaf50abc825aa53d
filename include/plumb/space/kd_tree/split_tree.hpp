// k-d tree of boxes, segments or triangles: space is divided by planes square to an axis, cell by cell, until few
// figures are left in each.
//
//   const SplitTree<Triangle3> tree = build_split_tree(triangles);
//   tree.items_in(leaf)                            // their numbers, ascending
//   in_box(tree, box);  overlapping_pairs(tree);   // split_range.hpp
//   cells_along(tree, ray);  first_hit(tree, ray); // split_ray.hpp
//
// A figure that a plane goes through is in both halves: so what is at a place is in the one leaf that holds the place,
// and a ray that is followed from cell to cell may stop where it first hits.  (Kept at the node instead, it would be
// asked by each ray that passes the node.)
// Laws: (1) leaves tile space, without end at the border; a cell is half open: points in a plane belong to the upper
// side.  (2) A figure is in a leaf exactly where its box has a point of the half-open cell, and the figure itself one
// of the closed cell: so each point of a figure is in a leaf that tells it.  (3) The figures' places in leaves are at most
// most_references times as many as the figures.  (4) The same figures make the same tree on every number of threads; no
// leaf is deeper than 60.
// A coordinate that is NaN or infinite throws NonFinite, which names the figure; empty boxes, more than 2^31 figures
// and options out of range InvalidShape.
// Source: RTCD 7.3.7; MacDonald and Booth 1990 for the choice of planes.
// Cost: 16 bytes a node, 4 a leaf and a place in it; n log n to build: a test against two cells for each figure that is
// cut.  Bounded by n log n operations a level, times most_references; 60 levels at most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/kd_tree/figure_tree.hpp"

namespace plumb {

/// In depth-first order: the lower child of a node lies right behind it.
struct SplitNode {
  static constexpr std::uint32_t leaf_axis = 3;

  double plane;
  std::uint32_t axis;  // leaf_axis of a leaf
  std::uint32_t link;  // the upper child; of a leaf its number

  [[nodiscard]] bool is_leaf() const { return axis == leaf_axis; }
  friend bool operator==(const SplitNode&, const SplitNode&) = default;
};

template <KeptFigure Figure>
struct SplitTree {
  static constexpr std::size_t dimension = FigureTree<Figure>::dimension;
  using Point = typename FigureTree<Figure>::Point;
  using Box = typename FigureTree<Figure>::Box;
  using Segment = std::conditional_t<dimension == 2, Segment2, Segment3>;
  using Ray = std::conditional_t<dimension == 2, Ray2, Ray3>;

  std::vector<SplitNode> nodes;
  std::vector<std::uint32_t> first = {0};  // in items, of each leaf, and the end
  std::vector<std::uint32_t> items;        // numbers of figures, leaf by leaf
  std::vector<Figure> figures;             // by their numbers

  [[nodiscard]] std::size_t leaves() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> items_in(std::size_t leaf) const {
    return std::span(items).subspan(first[leaf], first[leaf + 1] - first[leaf]);
  }
};

struct SplitTreeOptions {
  std::uint32_t most_in_leaf = 8;  // at least 1; a leaf holds more where no plane divides them to advantage
  std::uint32_t most_depth = 60;   // of a leaf; at most 60
  double most_references = 8;      // from 1 to 1000
  Execution execution = Execution::parallel;
};

template <KeptFigure Figure>
SplitTree<Figure> build_split_tree(std::span<const Figure> figures, const SplitTreeOptions& options = {});
template <KeptFigure Figure>
SplitTree<Figure> build_split_tree(const std::vector<Figure>& figures, const SplitTreeOptions& options = {}) {
  return build_split_tree(std::span<const Figure>(figures), options);
}

/// The leaf whose cell holds a point.
template <KeptFigure Figure>
std::uint32_t locate(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Point& p);

/// Bytes that its arrays take.
template <KeptFigure Figure>
std::size_t memory_of(const SplitTree<Figure>& tree);

}  // namespace plumb

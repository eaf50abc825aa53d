// Octree traversal, ray walk: which leaves does a ray or a segment go through, in order?
//
//   for (const std::uint32_t leaf : cells_along(tree.cells, Segment3{a, b}, WalkedCells::closed)) ...
//   CellWalker<3> walk(tree.cells, ray, WalkedCells::half_open);               // one leaf after the other
//   for (std::uint32_t leaf = walk.next(); leaf != no_cell; leaf = walk.next()) ...
//
// Laws: (1) WalkedCells::half_open: exactly the leaves that hold a point of it, where a cell has its lower borders and not
// its upper ones: each point of it in the root is in one leaf.  They ascend along the ray.  (2) WalkedCells::closed:
// exactly the leaves whose closed cells it touches, in a face, an edge or a corner too.  They ascend by where it comes
// to them first, those that it comes to at one place by their codes, in Morton order.  (3) A ray without a direction,
// and a segment of one point, is that point.  (4) Nothing beyond the last leaf that was taken is looked
// at, but other children of cells on the way to it.
// Where a ray crosses which border first is told by the sign of (c - o.x) d.y - (d - o.y) d.x, certified: no parameter
// is computed, none adds up.  NaN and infinity throw NonFinite.
// Source: RTCD 7.4.1; Revelles, Urena and Lastra 2000 for octrees by parameters.
// Cost: some 20 comparisons of borders for each cell that is entered on the way; no recursion.  Bounded by n log n
// comparisons for n cells, the order along the way, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/walked_cells.hpp"
#include "plumb/space/octree/cell_tree.hpp"

namespace plumb {

namespace space {

/// A line's way from a place on, with an end or without.
template <std::size_t D>
struct CellWay {
  std::array<double, D> from, to;   // `to`: the end, or the direction where there is none
  std::array<signed char, D> side;  // of the direction
  bool ends;
};

/// Where the way crosses a border: at its beginning, at a border of an axis, at its end or never.
struct CellCrossing {
  std::uint8_t axis;  // or one of these two
  bool open;          // is the cell on its side of the border without this place?
  double border;
};

}  // namespace space

template <std::size_t D>
class CellWalker {
 public:
  /// The tree must outlive it.
  CellWalker(const CellTree<D>& tree, const typename CellKinds<D>::Ray& ray, WalkedCells walk = WalkedCells::closed);
  CellWalker(const CellTree<D>& tree, const typename CellKinds<D>::Segment& segment,
             WalkedCells walk = WalkedCells::closed);

  /// no_cell behind the last.
  std::uint32_t next();

 private:
  struct Waiting {
    std::uint32_t node;
    CellSpan<D> span;
    space::CellCrossing entry;
  };
  void begin();
  void add_children(const Waiting& cell);
  [[nodiscard]] bool comes_later(const Waiting& a, const Waiting& b) const;

  const CellTree<D>* tree_;
  space::CellWay<D> way_;
  WalkedCells walk_;
  std::vector<Waiting> waiting_;  // half open: the next one last; closed: a heap
};

template <std::size_t D>
std::vector<std::uint32_t> cells_along(const CellTree<D>& tree, const typename CellKinds<D>::Ray& ray,
                                       WalkedCells walk = WalkedCells::closed, std::vector<std::uint32_t> rows = {});
template <std::size_t D>
std::vector<std::uint32_t> cells_along(const CellTree<D>& tree, const typename CellKinds<D>::Segment& segment,
                                       WalkedCells walk = WalkedCells::closed, std::vector<std::uint32_t> rows = {});

}  // namespace plumb

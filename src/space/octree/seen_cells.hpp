// Which cells of a tree may hold something of a box?  Those in the range of its corners' numbers.
//
// Laws: numbers never fall as coordinates grow, so what meets the box has a number in the range, along every axis, even
// outside the root.  Cells without items are passed over.
// Cost: two comparisons an axis and cell; no recursion.
#pragma once

#include <array>

#include "plumb/space/octree/cell_tree.hpp"

namespace plumb::space {

template <std::size_t D>
struct PlaceRange {
  typename CellFrame<D>::Place low, high;

  /// Has it one of the cell's least cells?
  [[nodiscard]] bool meets(const plumb::CellSpan<D>& cell) const {
    bool all = true;
    for (std::size_t axis = 0; axis < D; ++axis) {
      all &= low[axis] < cell.first[axis] + cell.count && cell.first[axis] <= high[axis];
    }
    return all;
  }
  [[nodiscard]] bool holds(const typename CellFrame<D>::Place& place) const {
    bool all = true;
    for (std::size_t axis = 0; axis < D; ++axis) all &= low[axis] <= place[axis] && place[axis] <= high[axis];
    return all;
  }
};

template <std::size_t D>
PlaceRange<D> range_of(const CellFrame<D>& frame, const typename CellKinds<D>::Box& box) {
  return {frame.place(box.min), frame.place(box.max)};
}

/// Child c.
template <std::size_t D>
plumb::CellSpan<D> child_of(const plumb::CellSpan<D>& cell, std::size_t c) {
  plumb::CellSpan<D> child{cell.first, cell.count / 2};
  for (std::size_t axis = 0; axis < D; ++axis) {
    if ((c >> axis & 1) != 0) child.first[axis] += static_cast<std::uint32_t>(child.count);
  }
  return child;
}

/// Calls visit(node) for each cell from `top` down, parents before their children.
template <std::size_t D, class Visit>
void visit_seen_cells(const CellTree<D>& tree, const PlaceRange<D>& range, std::uint32_t top, const Visit& visit) {
  constexpr std::size_t children = std::size_t{1} << D;
  struct Waiting {
    std::uint32_t node;
    plumb::CellSpan<D> span;
  };
  std::array<Waiting, (children - 1) * CellFrame<D>::levels + 1> later;
  std::size_t waiting = 0;
  later[waiting++] = {top, span_of<D>(tree.nodes[top].code)};
  while (waiting > 0) {
    const Waiting now = later[--waiting];
    const CellNode& node = tree.nodes[now.node];
    visit(now.node);
    if (node.is_leaf()) continue;
    for (std::size_t c = children; c-- > 0;) {
      const auto child = static_cast<std::uint32_t>(node.children + c);
      if (tree.nodes[child].count() == 0) continue;
      const plumb::CellSpan<D> span = child_of(now.span, c);
      if (range.meets(span)) later[waiting++] = {child, span};
    }
  }
}
template <std::size_t D, class Visit>
void visit_seen_cells(const CellTree<D>& tree, const typename CellKinds<D>::Box& box, const Visit& visit) {
  if (!tree.nodes.empty()) visit_seen_cells(tree, range_of(tree.frame, box), 0, visit);
}

}  // namespace plumb::space

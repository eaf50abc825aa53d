// Octree, quadtree: which cells is a root cut into, and which items are in them?  A linear octree: all cells in one
// array, each with its locational code.
//
//   Octree cells = ...;                                   // of build_octree
//   const std::uint32_t leaf = locate(cells, point);      // or no_cell
//   box_of(cells, leaf)                                   // its borders: doubles
//   for (std::uint32_t i : items_in(cells, leaf)) ...
//
// A cell is half-open (cell_frame.hpp).  It is a leaf, or cut into 2^D children of half its side; the leaves tile the
// root.
// Laws: (1) nodes[0] is the root; the children of a cell lie one after the other in the order of their codes, behind
// it; cells ascend by level.  (2) The code of a cell is a 1 and D bits for each level, one an axis, x lowest: 1 where
// it is the upper half.  (3) items holds for each cell a run, which those of its children lie in.  (4) locate(point) is
// the leaf that the point is in, no_cell of a point outside the root.
// Source: RTCD 7.3.1, 7.3.3 to 7.3.5; Gargantini 1982 and Morton 1966 for the codes.
// Cost: 24 bytes a cell.  locate: a step a level, of which there are 21 at most in space, 31 in the plane.  Nothing
// is searched.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "plumb/space/octree/cell_frame.hpp"

namespace plumb {

inline constexpr std::uint32_t no_cell = 0xffffffff;

struct CellNode {
  std::uint64_t code;
  std::uint32_t children;    // the first of them; 0 of a leaf
  std::uint32_t parent;      // no_cell of the root
  std::uint32_t begin, end;  // in items

  [[nodiscard]] bool is_leaf() const { return children == 0; }
  [[nodiscard]] std::uint32_t count() const { return end - begin; }
  friend bool operator==(const CellNode&, const CellNode&) = default;
};

template <std::size_t D>
struct CellTree {
  CellFrame<D> frame;
  std::vector<CellNode> nodes;
  std::vector<std::uint32_t> items;
  friend bool operator==(const CellTree&, const CellTree&) = default;
};

using Octree = CellTree<3>;
using Quadtree = CellTree<2>;

/// How often the root is halved.
template <std::size_t D>
unsigned level_of(std::uint64_t code) {
  return static_cast<unsigned>(std::bit_width(code) - 1) / D;
}

/// The numbers of its first least cell, and how many it has along an axis.
template <std::size_t D>
struct CellSpan {
  typename CellFrame<D>::Place first;
  std::uint64_t count;
};
template <std::size_t D>
CellSpan<D> span_of(std::uint64_t code) {
  CellSpan<D> span{};
  const unsigned level = level_of<D>(code), shift = CellFrame<D>::levels - level;
  for (unsigned l = 0; l < level; ++l) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      span.first[axis] |= static_cast<std::uint32_t>(code >> (D * l + axis) & 1) << (shift + l);
    }
  }
  span.count = std::uint64_t{1} << shift;
  return span;
}

/// Its borders; infinite beyond the largest double.
template <std::size_t D>
typename CellKinds<D>::Box box_of(const CellTree<D>& tree, std::uint32_t node) {
  const CellSpan<D> span = span_of<D>(tree.nodes[node].code);
  const auto low = [&](std::size_t axis) { return tree.frame.border(axis, span.first[axis]); };
  const auto high = [&](std::size_t axis) { return tree.frame.border(axis, span.first[axis] + span.count); };
  if constexpr (D == 2) {
    return {{low(0), low(1)}, {high(0), high(1)}};
  } else {
    return {{low(0), low(1), low(2)}, {high(0), high(1), high(2)}};
  }
}

template <std::size_t D>
std::span<const std::uint32_t> items_in(const CellTree<D>& tree, std::uint32_t node) {
  const CellNode& n = tree.nodes[node];
  return std::span(tree.items).subspan(n.begin, n.count());
}

/// The leaf that has this least cell.
template <std::size_t D>
std::uint32_t leaf_at(const CellTree<D>& tree, const typename CellFrame<D>::Place& place) {
  std::uint32_t node = 0;
  for (unsigned bit = CellFrame<D>::levels; !tree.nodes[node].is_leaf();) {
    --bit;
    std::uint32_t child = 0;
    for (std::size_t axis = 0; axis < D; ++axis) child |= (place[axis] >> bit & 1u) << axis;
    node = tree.nodes[node].children + child;
  }
  return node;
}

/// A NaN lies in no cell.
template <std::size_t D>
std::uint32_t locate(const CellTree<D>& tree, const typename CellKinds<D>::Point& point) {
  if (tree.nodes.empty() || !tree.frame.holds(point)) return no_cell;
  return leaf_at(tree, tree.frame.place(point));
}

}  // namespace plumb

// Does a tree of cells keep the laws of plumb/space/octree/cell_tree.hpp?  Looked at from outside.
#pragma once

#include <string>
#include <vector>

#include "plumb/certify/accepted.hpp"
#include "plumb/space/octree/cell_tree.hpp"

namespace plumb::octree_laws {

/// Which law is broken; nothing where none is.
template <std::size_t D>
std::string broken(const CellTree<D>& tree, std::uint32_t deepest) {
  constexpr std::uint32_t children = 1u << D;
  if (tree.nodes.empty()) return tree.items.empty() ? "" : "items of no cells";
  const CellNode& root = tree.nodes[0];
  if (root.code != 1 || root.parent != no_cell || root.begin != 0 || root.end != tree.items.size()) return "the root";
  std::uint32_t next = 1;
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const CellNode& n = tree.nodes[i];
    const std::string where = " at cell " + std::to_string(i);
    const unsigned level = level_of<D>(n.code);
    if (level > deepest || level > CellFrame<D>::levels) return "depth" + where;
    if (i > 0 && level < level_of<D>(tree.nodes[i - 1].code)) return "ascending levels" + where;
    if (n.begin > n.end) return "a run" + where;
    const auto box = box_of(tree, i);
    const auto low = coordinates(box.min), high = coordinates(box.max);
    for (std::size_t axis = 0; axis < D; ++axis) {
      // Beyond the largest double nothing is.
      if (!(low[axis] < high[axis]) && low[axis] - low[axis] == 0) return "borders ascend" + where;
    }
    if (n.is_leaf()) continue;
    if (n.children != next) return "children in order" + where;
    next += children;
    if (next > tree.nodes.size()) return "all children are there" + where;
    std::uint32_t begin = n.begin;
    for (std::uint32_t c = 0; c < children; ++c) {
      const CellNode& child = tree.nodes[n.children + c];
      if (child.code != (n.code << D | c) || child.parent != i) return "codes" + where;
      if (child.begin < begin || child.end > n.end) return "runs in order" + where;
      begin = child.end;
      const auto part = box_of(tree, n.children + c);
      const auto from = coordinates(part.min), to = coordinates(part.max);
      for (std::size_t axis = 0; axis < D; ++axis) {
        const bool upper = (c >> axis & 1) != 0;
        if (upper ? to[axis] != high[axis] : from[axis] != low[axis]) return "children end where it does" + where;
        const auto other = box_of(tree, n.children + (c ^ 1u << axis));
        if (!upper && to[axis] != coordinates(other.min)[axis]) return "halves meet" + where;
      }
    }
  }
  return next == tree.nodes.size() ? "" : "cells that are no children";
}

/// Is the point in the half-open cell?
template <class Box, class Point>
bool is_in_cell(const Box& cell, const Point& p) {
  const auto low = coordinates(cell.min), high = coordinates(cell.max), x = coordinates(p);
  for (std::size_t axis = 0; axis < x.size(); ++axis) {
    if (!(low[axis] <= x[axis] && x[axis] < high[axis])) return false;
  }
  return true;
}

/// Has the closed box a point in it?
template <class Box>
bool has_place_in(const Box& cell, const Box& box) {
  const auto low = coordinates(cell.min), high = coordinates(cell.max), from = coordinates(box.min),
             to = coordinates(box.max);
  for (std::size_t axis = 0; axis < from.size(); ++axis) {
    if (!(low[axis] <= to[axis] && from[axis] < high[axis])) return false;
  }
  return true;
}

}  // namespace plumb::octree_laws

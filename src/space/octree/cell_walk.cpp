#include "plumb/space/octree/cell_walk.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "space/octree/cell_keys.hpp"
#include "space/octree/crossing_order.hpp"
#include "space/octree/seen_cells.hpp"

namespace plumb {
namespace {

template <std::size_t D>
struct CellBorders {
  std::array<double, D> low, high;
};
template <std::size_t D>
CellBorders<D> borders_of(const CellFrame<D>& frame, const CellSpan<D>& span) {
  CellBorders<D> borders;
  for (std::size_t axis = 0; axis < D; ++axis) {
    borders.low[axis] = frame.border(axis, span.first[axis]);
    borders.high[axis] = frame.border(axis, span.first[axis] + span.count);
  }
  return borders;
}

template <std::size_t D>
space::CellWay<D> way_along(const std::array<double, D>& from, const std::array<double, D>& to, bool ends) {
  space::CellWay<D> way{from, to, {}, ends};
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double beginning = ends ? from[axis] : 0;
    way.side[axis] = static_cast<signed char>((to[axis] > beginning) - (to[axis] < beginning));
  }
  return way;
}

}  // namespace

template <std::size_t D>
CellWalker<D>::CellWalker(const CellTree<D>& tree, const typename CellKinds<D>::Ray& ray, WalkedCells walk)
    : tree_(&tree), way_(way_along<D>(coordinates(ray.origin), coordinates(ray.direction), false)), walk_(walk) {
  figure::require_finite_parts<decltype(ray.origin), decltype(ray.direction)>(
      "CellWalker", {"ray.origin", "ray.direction"}, ray.origin, ray.direction);
  begin();
}
template <std::size_t D>
CellWalker<D>::CellWalker(const CellTree<D>& tree, const typename CellKinds<D>::Segment& segment, WalkedCells walk)
    : tree_(&tree), way_(way_along<D>(coordinates(segment.a), coordinates(segment.b), true)), walk_(walk) {
  figure::require_finite_parts<decltype(segment.a), decltype(segment.b)>("CellWalker", {"segment.a", "segment.b"},
                                                                         segment.a, segment.b);
  begin();
}

template <std::size_t D>
void CellWalker<D>::begin() {
  if (tree_->nodes.empty()) return;
  const CellSpan<D> root = span_of<D>(1);
  const CellBorders<D> borders = borders_of(tree_->frame, root);
  const auto passage = space::CrossingsOf<D>(way_, walk_).passage(borders.low, borders.high);
  if (passage) waiting_.push_back({0, root, passage->entry});
}

template <std::size_t D>
bool CellWalker<D>::comes_later(const Waiting& a, const Waiting& b) const {
  const int by_entry = space::CrossingsOf<D>(way_, walk_).entry_order(a.entry, b.entry);
  if (by_entry != 0) return by_entry > 0;
  return space::interleaved<D>(a.span.first) > space::interleaved<D>(b.span.first);
}

template <std::size_t D>
void CellWalker<D>::add_children(const Waiting& cell) {
  const space::CrossingsOf<D> crossings(way_, walk_);
  const auto first = static_cast<std::ptrdiff_t>(waiting_.size());
  for (std::uint32_t c = 0; c < 1u << D; ++c) {
    const CellSpan<D> span = space::child_of(cell.span, c);
    const CellBorders<D> borders = borders_of(tree_->frame, span);
    const auto passage = crossings.passage(borders.low, borders.high);
    if (!passage) continue;
    waiting_.push_back({tree_->nodes[cell.node].children + c, span, passage->entry});
    if (walk_ == WalkedCells::closed) {
      std::push_heap(waiting_.begin(), waiting_.end(),
                     [this](const Waiting& a, const Waiting& b) { return comes_later(a, b); });
    }
  }
  // Half-open cells lie one behind the other, with all that is in them.
  if (walk_ == WalkedCells::half_open) {
    std::sort(waiting_.begin() + first, waiting_.end(),
              [this](const Waiting& a, const Waiting& b) { return comes_later(a, b); });
  }
}

template <std::size_t D>
std::uint32_t CellWalker<D>::next() {
  while (!waiting_.empty()) {
    if (walk_ == WalkedCells::closed) {
      std::pop_heap(waiting_.begin(), waiting_.end(),
                    [this](const Waiting& a, const Waiting& b) { return comes_later(a, b); });
    }
    const Waiting now = waiting_.back();
    waiting_.pop_back();
    if (tree_->nodes[now.node].is_leaf()) return now.node;
    add_children(now);
  }
  return no_cell;
}

namespace {

template <std::size_t D>
std::vector<std::uint32_t> all_of(CellWalker<D> walker, std::vector<std::uint32_t> leaves) {
  leaves.clear();
  for (std::uint32_t leaf = walker.next(); leaf != no_cell; leaf = walker.next()) leaves.push_back(leaf);
  return leaves;
}

}  // namespace

template <std::size_t D>
std::vector<std::uint32_t> cells_along(const CellTree<D>& tree, const typename CellKinds<D>::Ray& ray, WalkedCells walk,
                                       std::vector<std::uint32_t> rows) {
  return all_of(CellWalker<D>(tree, ray, walk), std::move(rows));
}
template <std::size_t D>
std::vector<std::uint32_t> cells_along(const CellTree<D>& tree, const typename CellKinds<D>::Segment& segment,
                                       WalkedCells walk, std::vector<std::uint32_t> rows) {
  return all_of(CellWalker<D>(tree, segment, walk), std::move(rows));
}

template class CellWalker<2>;
template class CellWalker<3>;
template std::vector<std::uint32_t> cells_along<2>(const Quadtree&, const Ray2&, WalkedCells,
                                                   std::vector<std::uint32_t>);
template std::vector<std::uint32_t> cells_along<3>(const Octree&, const Ray3&, WalkedCells, std::vector<std::uint32_t>);
template std::vector<std::uint32_t> cells_along<2>(const Quadtree&, const Segment2&, WalkedCells,
                                                   std::vector<std::uint32_t>);
template std::vector<std::uint32_t> cells_along<3>(const Octree&, const Segment3&, WalkedCells,
                                                   std::vector<std::uint32_t>);

}  // namespace plumb

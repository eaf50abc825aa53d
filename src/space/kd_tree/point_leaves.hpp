// Which leaves of a k-d tree of points may hold points of boxes?  All nodes of a level, and all boxes, at a time.
//
// Laws: (1) each leaf whose cell has a point of the closed box is visited once, those of a box one after another.
// (2) Of points that are all equal below a node one is looked at, for all: as soon as its level is.
// Source: RTCD 7.3.7; level by level, as no processor foresees the turns of a search, which are no branches here.
// Cost: the nodes above the leaves, a dozen instructions each.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_POINT_LEAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_POINT_LEAVES
#undef PLUMB_POINT_LEAVES
#else
#define PLUMB_POINT_LEAVES
#endif

#include <hwy/highway.h>

#include <array>

#include "space/kd_tree/point_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::kd::HWY_NAMESPACE {
namespace {

/// Of a box along an axis.
struct Side {
  double low, high;
};
/// In the lower half the number of a node among those of its level, in the upper half that of a box.
using NodeOfBox = std::uint64_t;
constexpr std::size_t most_nodes = 256;

/// Calls visit_one(box, leaf) and visit_run(box, leaves) for what is below nodes of this level, most_nodes at the most,
/// whose boxes ascend.  The sides of the boxes stand axis by axis.
template <class Point, class VisitOne, class VisitRun>
void visit_leaves_below(const KdTree<Point>& tree, unsigned level, std::span<const NodeOfBox> nodes, const Side* sides,
                        const VisitOne& visit_one, const VisitRun& visit_run) {
  std::array<std::array<NodeOfBox, 2 * most_nodes>, 2> rooms;
  for (; level < tree.levels; ++level) {
    NodeOfBox* const below = rooms[level % 2].data();
    const std::size_t before = (std::size_t{1} << level) - 1;
    std::size_t count = 0;
    for (const NodeOfBox i : nodes) {
      const auto number = static_cast<std::uint32_t>(i);
      const std::size_t node = before + number;
      if (tree.equal[node] != 0) [[unlikely]] {
        visit_run(i >> 32, leaves_below(tree, node));
        continue;
      }
      const Side& side = sides[KdTree<Point>::dimension * (i >> 32) + tree.axes[node]];
      const double plane = tree.planes[node];
      below[count] = i + number;
      count += static_cast<std::size_t>(side.low <= plane);
      below[count] = i + number + 1;
      count += static_cast<std::size_t>(side.high >= plane);
    }
    nodes = {below, count};
    if (count > most_nodes) {
      visit_leaves_below(tree, level + 1, nodes.first(most_nodes), sides, visit_one, visit_run);
      nodes = nodes.subspan(most_nodes);
    }
  }
  for (const NodeOfBox i : nodes) visit_one(i >> 32, static_cast<std::uint32_t>(i));
}

/// Of one box: visit_one(leaf), visit_run(leaves).
template <class Point, class VisitOne, class VisitRun>
HWY_INLINE void visit_leaves(const KdTree<Point>& tree, const std::array<Side, KdTree<Point>::dimension>& sides,
                             const VisitOne& visit_one, const VisitRun& visit_run) {
  const NodeOfBox root = 0;
  visit_leaves_below(
      tree, 0, std::span(&root, 1), sides.data(), [&](std::size_t, std::size_t leaf) HWY_ATTR { visit_one(leaf); },
      [&](std::size_t, LeafRun run) HWY_ATTR { visit_run(run); });
}

}  // namespace
}  // namespace plumb::space::kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

#include "plumb/space/octree/point_octree.hpp"

#include <algorithm>
#include <memory>

#include "figure/basic/finite_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/octree/box_sides.hpp"
#include "space/octree/cell_keys.hpp"
#include "space/octree/cut_cells.hpp"
#include "space/octree/seen_cells.hpp"
#include "space/pairs/opened_box.hpp"

namespace plumb {
namespace {

using space::KeyedItem;

constexpr std::size_t point_block = 1 << 12;

template <std::size_t D>
PointCells<D> cells_of_points(std::string_view function, std::span<const typename CellKinds<D>::Point> points,
                              const OctreeOptions& options) {
  space::check_octree_options(function, options, points.size());
  figure::require_finite_points(function, "points", points);
  PointCells<D> tree;
  if (points.empty()) return tree;
  typename CellKinds<D>::Box held{points[0], points[0]};
  for (const auto& p : points) held = space::holding(held, {p, p});
  tree.cells.frame = CellFrame<D>(held);
  const auto place = std::make_unique_for_overwrite<KeyedItem[]>(points.size());
  const std::span<KeyedItem> keyed(place.get(), points.size());
  space::for_blocks(options.execution, points.size(), point_block, [&](std::size_t, std::size_t from, std::size_t to) {
    const CellFrame<D> frame = tree.cells.frame;
    for (std::size_t i = from; i < to; ++i) {
      keyed[i] = {space::interleaved<D>(frame.place(points[i])) << 1 | 1, static_cast<std::uint32_t>(i)};
    }
  });
  space::sort_by_key(options.execution, keyed);
  tree.cells.nodes = space::cut_cells<D>(keyed, true, options);
  tree.cells.items.resize(points.size());
  tree.points.resize(points.size());
  space::for_blocks(options.execution, points.size(), point_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      tree.cells.items[i] = keyed[i].item;
      tree.points[i] = points[keyed[i].item];
    }
  });
  return tree;
}

template <std::size_t D>
std::vector<std::uint32_t> found_points(const PointCells<D>& tree, const typename CellKinds<D>::Box& asked,
                                        const InBoxOptions& options, std::vector<std::uint32_t> found) {
  found.clear();
  figure::require_finite_parts<decltype(asked.min), decltype(asked.max)>("in_box", {"box.min", "box.max"}, asked.min,
                                                                         asked.max);
  const typename CellKinds<D>::Box box = options.touching ? asked : space::opened(asked);
  if (is_empty(box)) return found;
  space::visit_seen_cells(tree.cells, box, [&](std::uint32_t node) {
    const CellNode& n = tree.cells.nodes[node];
    if (!n.is_leaf()) return;
    for (std::uint32_t i = n.begin; i < n.end; ++i) {
      if (space::is_in(box, tree.points[i])) found.push_back(tree.cells.items[i]);
    }
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

PointOctree build_octree(std::span<const Point3> points, const OctreeOptions& options) {
  return cells_of_points<3>("build_octree", points, options);
}
PointQuadtree build_quadtree(std::span<const Point2> points, const OctreeOptions& options) {
  return cells_of_points<2>("build_quadtree", points, options);
}
std::vector<std::uint32_t> in_box(const PointOctree& tree, const Aabb3& box, const InBoxOptions& options,
                                  std::vector<std::uint32_t> rows) {
  return found_points<3>(tree, box, options, std::move(rows));
}
std::vector<std::uint32_t> in_box(const PointQuadtree& tree, const Aabb2& box, const InBoxOptions& options,
                                  std::vector<std::uint32_t> rows) {
  return found_points<2>(tree, box, options, std::move(rows));
}

}  // namespace plumb

#include "plumb/space/kd_tree/point_range.hpp"

#include "figure/basic/finite_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/kd_tree/answer_lists.hpp"
#include "space/kd_tree/point_search.hpp"
#include "space/kd_tree/query_order.hpp"
#include "space/pairs/opened_box.hpp"

namespace plumb {
namespace space::kd {

namespace {

constexpr std::size_t block_size = 1 << 12;

}  // namespace
}  // namespace space::kd

template <class Point>
std::vector<std::uint32_t> within(const KdTree<Point>& tree, const std::type_identity_t<Point>& p, double radius,
                                  std::vector<std::uint32_t> rows) {
  space::kd::require_radius(radius);
  require_finite_parts<Point>("within", {"p"}, p);
  rows.clear();
  if (tree.count != 0) space::kd::add_within(tree, p, radius, rows);
  return rows;
}

template <class Point>
std::vector<std::uint32_t> in_box(const KdTree<Point>& tree, const space::BoxOf<Point>& box,
                                  const InBoxOptions& options, std::vector<std::uint32_t> rows) {
  require_finite_parts<Point, Point>("in_box", {"box.min", "box.max"}, box.min, box.max);
  rows.clear();
  if (tree.count != 0) space::kd::add_in_box(tree, options.touching ? box : space::opened(box), rows);
  return rows;
}

template <class Point>
PointLists within(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries, double radius,
                  Execution execution, PointLists lists) {
  using namespace space::kd;
  require_radius(radius);
  require_finite_points("within", "queries", queries);
  std::vector<ListBlock> blocks(space::blocks_of(queries.size(), block_size));
  space::for_blocks(execution, queries.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    in_query_order(tree, queries.subspan(from, to - from), Execution::serial,
                   [&](std::size_t, std::span<const std::uint64_t> keys) {
                     blocks[b].start.resize(keys.size()), blocks[b].size.resize(keys.size());
                     if (tree.count != 0) add_within_each(tree, queries.data() + from, keys, radius, blocks[b]);
                   });
  });
  return put_together(queries.size(), block_size, blocks, std::move(lists));
}

template <class Point>
PointLists in_box(const KdTree<Point>& tree, std::span<const space::BoxOf<Point>> boxes, Execution execution,
                  const InBoxOptions& options, PointLists lists) {
  using namespace space::kd;
  require_finite_boxes(boxes);
  std::vector<ListBlock> blocks(space::blocks_of(boxes.size(), block_size));
  space::for_blocks(execution, boxes.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    blocks[b] = asked_in_turn(to - from, [&](std::uint32_t i, std::vector<std::uint32_t>& numbers) {
      if (tree.count == 0) return;
      const auto& box = boxes[from + i];
      add_in_box<Point>(tree, options.touching ? box : space::opened(box), numbers);
    });
  });
  return put_together(boxes.size(), block_size, blocks, std::move(lists));
}

#define PLUMB_INSTANTIATE(P)                                                                                     \
  template std::vector<std::uint32_t> within(const KdTree<P>&, const P&, double, std::vector<std::uint32_t>);    \
  template std::vector<std::uint32_t> in_box(const KdTree<P>&, const space::BoxOf<P>&, const InBoxOptions&,      \
                                             std::vector<std::uint32_t>);                                        \
  template PointLists within(const KdTree<P>&, std::span<const P>, double, Execution, PointLists);               \
  template PointLists in_box(const KdTree<P>&, std::span<const space::BoxOf<P>>, Execution, const InBoxOptions&, \
                             PointLists);
PLUMB_INSTANTIATE(Point2)
PLUMB_INSTANTIATE(Point3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

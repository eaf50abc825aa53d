#include "plumb/space/kd_tree/nearest_point.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/closest/closest.hpp"
#include "space/kd_tree/answer_lists.hpp"
#include "space/kd_tree/point_search.hpp"
#include "space/kd_tree/query_order.hpp"

namespace plumb {
namespace space::kd {
namespace {

template <class Point>
std::size_t leaf_of(const KdTree<Point>& tree, const Point& p) {
  std::uint64_t key = 0;
  find_leaves(tree, std::span<const Point>(&p, 1), &key);
  return key >> 32;
}

}  // namespace
}  // namespace space::kd

template <class Point>
NearestPoint nearest(const KdTree<Point>& tree, const std::type_identity_t<Point>& p) {
  space::kd::require_as_many(1, tree.count, "point");
  require_finite_parts<Point>("nearest", {"p"}, p);
  return space::kd::nearest_one(tree, p);
}

template <class Point>
std::vector<NearestPoint> nearest(const KdTree<Point>& tree, const std::type_identity_t<Point>& p, std::size_t k,
                                  Ties ties, std::vector<NearestPoint> rows) {
  using namespace space::kd;
  require_finite_parts<Point>("nearest", {"p"}, p);
  rows.clear();
  k = std::min<std::size_t>(k, tree.count);
  if (k == 0) return rows;
  std::vector<Candidate<Point>> room(k);
  rows.resize(k);
  k_nearest<Point>(tree, p, leaf_of(tree, p), room, rows.data());
  if (ties == Ties::lowest) return rows;
  std::vector<std::uint32_t> as_near;
  add_ties(tree, p, room.back().at, as_near);
  std::ranges::sort(as_near);
  // Those of the lowest numbers are told already, and the last of them is the last that is told.
  const auto more = std::ranges::upper_bound(as_near, rows.back().index);
  const double distance = rows.back().distance;
  for (auto i = more; i != as_near.end(); ++i) rows.push_back({*i, distance});
  return rows;
}

template <class Point>
void nearest(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries,
             std::span<NearestPoint> out, Execution execution) {
  using namespace space::kd;
  require_length(queries.size(), out.size());
  if (queries.empty()) return;
  require_as_many(1, tree.count, "point");
  require_finite_points("nearest", "queries", queries);
  in_query_order(tree, queries, execution, [&](std::size_t from, std::span<const std::uint64_t> keys) {
    nearest_of_each(tree, queries.data() + from, keys, out.data() + from);
  });
}

template <class Point>
void nearest(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries, std::size_t k,
             std::span<NearestPoint> out, Execution execution) {
  using namespace space::kd;
  require_length(queries.size() * k, out.size());
  if (out.empty()) return;
  require_as_many(k, tree.count, "point");
  require_finite_points("nearest", "queries", queries);
  in_query_order(tree, queries, execution, [&](std::size_t from, std::span<const std::uint64_t> keys) {
    std::vector<Candidate<Point>> room(k);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::size_t number = from + static_cast<std::uint32_t>(keys[i]);
      const std::size_t ahead = from + static_cast<std::uint32_t>(keys[std::min(i + asked_ahead, keys.size() - 1)]);
      __builtin_prefetch(&queries[ahead]);
      __builtin_prefetch(&out[ahead * k], 1);
      k_nearest<Point>(tree, queries[number], keys[i] >> 32, room, out.data() + number * k);
    }
  });
}

#define PLUMB_INSTANTIATE(P)                                                                       \
  template NearestPoint nearest(const KdTree<P>&, const P&);                                       \
  template std::vector<NearestPoint> nearest(const KdTree<P>&, const P&, std::size_t, Ties,        \
                                             std::vector<NearestPoint>);                           \
  template void nearest(const KdTree<P>&, std::span<const P>, std::span<NearestPoint>, Execution); \
  template void nearest(const KdTree<P>&, std::span<const P>, std::size_t, std::span<NearestPoint>, Execution);
PLUMB_INSTANTIATE(Point2)
PLUMB_INSTANTIATE(Point3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb

// Queries of a batch, near ones after one another: in the order of the leaves that hold them.
//
// Law: the order decides nothing but what is in the processor's caches.
// Cost: a descent and three passes of a radix sort a query.
#pragma once

#include <span>
#include <vector>

#include "space/bvh/parts.hpp"
#include "space/bvh/radix_sort.hpp"
#include "space/kd_tree/point_search.hpp"

namespace plumb::space::kd {

/// In the order of their leaves queries are met anywhere in memory: so many ahead they are sent for.  By measurement.
inline constexpr std::size_t asked_ahead = 4;

/// Calls work(from, keys) for each block of queries: the number of its first, and the keys of find_leaves.
template <class Point, class Work>
void in_query_order(const KdTree<Point>& tree, std::span<const Point> queries, Execution execution, const Work& work) {
  constexpr std::size_t block = 1 << 15, few = 256;
  const bool is_serial = execution == Execution::serial;
  for_blocks(execution, queries.size(), is_serial ? block : block / 8,
             [&](std::size_t, std::size_t from, std::size_t to) {
               std::vector<std::uint64_t> keys(to - from);
               find_leaves(tree, queries.subspan(from, to - from), keys.data());
               if (keys.size() > few) radix_sort_upper(Execution::serial, keys);
               work(from, std::span<const std::uint64_t>(keys));
             });
}

}  // namespace plumb::space::kd

// Nearest neighbors: which of many points are nearest to p, and how far are they?
//
// Laws: (1) nearer in real arithmetic comes first, of equally near points that of the lower number; so the answer is
// that of a search through all points, and depends neither on the tree nor on threads or instruction sets.  (2) A
// distance is the double nearest to the exact one.  (3) A batch answers each query as it is answered alone.
// (4) Of the k nearest there are as many as there are points, where these are fewer.
// The nearest of no points, and a batch of more than there are, throw InvalidShape; where `out` has not the batch's
// length, UnequalLengths; of a coordinate that is NaN or infinite NonFinite, which names the query.
// Source: RTCD 7.3.7; Friedman, Bentley, Finkel 1977.
// Cost: log n where points are scattered.  Squares of distances in lanes of doubles with derived bounds; exact
// comparisons among points that these leave equally near (docs/nearest.md).  Bounded by n log n operations a point, on
// integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/kd_tree/kd_tree.hpp"

namespace plumb {

struct NearestPoint {
  std::uint32_t index;
  double distance;
  friend bool operator==(const NearestPoint&, const NearestPoint&) = default;
};

/// What is told of points that are exactly as near as the last one that was asked for.
enum class Ties : unsigned char {
  lowest,  // of these the lowest, as many as were asked for
  all      // all of these: more than were asked for
};

template <class Point>
NearestPoint nearest(const KdTree<Point>& tree, const std::type_identity_t<Point>& p);
/// The k nearest, nearest first.
template <class Point>
std::vector<NearestPoint> nearest(const KdTree<Point>& tree, const std::type_identity_t<Point>& p, std::size_t k,
                                  Ties ties = Ties::lowest, std::vector<NearestPoint> rows = {});

/// One of each query.
template <class Point>
void nearest(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries,
             std::span<NearestPoint> out, Execution execution = Execution::parallel);
/// k of each query, query by query.
template <class Point>
void nearest(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries, std::size_t k,
             std::span<NearestPoint> out, Execution execution = Execution::parallel);

}  // namespace plumb

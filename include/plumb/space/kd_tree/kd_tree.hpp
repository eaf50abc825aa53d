// k-d tree: points divided in halves, by planes square to an axis.
//
// The compact static tree: complete, so that it needs no pointers, its nodes in the order of a heap.  The children of
// node i are 2 i + 1 and 2 i + 2; the leaves, which are no nodes, are the points from first(leaf) on.  A leaf's
// coordinates stand together, axis by axis, as lanes read them.
// Laws: (1) each point is in one leaf.  (2) Below child 2 i + 1 no coordinate of the axis exceeds planes[i], below the
// other none is less.  (3) Leaves differ by at most one in the number of their points.  (4) The same points make the
// same tree on every number of threads: points in one plane are divided by their numbers.  (5) So below a node of equal
// points the numbers ascend, and a search looks at the first of them for all.
// A coordinate that is NaN or infinite throws NonFinite, which names the point; more than 2^32 - 1 points and leaves of
// no point throw InvalidShape.
// Source: RTCD 7.3.7, 13.4.1; Bentley 1975.
// Cost: 28 bytes a point in space and 20 in the plane, 10 bytes a leaf; n log n to build, by recursion as deep as the
// levels.  Bounded by n log n operations: each level halves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/certify/batch.hpp"

namespace plumb {

template <class Point>
struct KdTree {
  static constexpr std::size_t dimension = sizeof(Point) / sizeof(double);
  /// Lanes read up to so many numbers beyond the last leaf.
  static constexpr std::size_t padding = 8;

  std::uint32_t count = 0;             // of points
  unsigned levels = 0;                 // of planes; there are 2^levels leaves
  bool halves = true;                  // is half of each coordinate a double?  Then no difference need overflow
  std::vector<double> planes;          // one a node: coordinate ...
  std::vector<std::uint8_t> axes;      // ... and axis, 0 for x
  std::vector<std::uint8_t> equal;     // 1 where all points below a node are one and the same
  std::vector<double> coordinates;     // leaf by leaf: all x, all y, all z
  std::vector<std::uint32_t> numbers;  // of the points, leaf by leaf, ascending in each

  [[nodiscard]] std::size_t leaves() const { return std::size_t{1} << levels; }
  /// The place in `numbers` of the first point of a leaf; of leaf leaves(), the end.
  [[nodiscard]] std::uint32_t first(std::size_t leaf) const {
    return static_cast<std::uint32_t>(std::uint64_t{count} * leaf >> levels);
  }
};

using KdTree2 = KdTree<Point2>;
using KdTree3 = KdTree<Point3>;

template <class Point>
concept KeptPoint = std::is_same_v<Point, Point2> || std::is_same_v<Point, Point3>;

struct KdTreeOptions {
  std::uint32_t most_in_leaf = 8;
  Execution execution = Execution::parallel;
};

template <KeptPoint Point>
KdTree<Point> build_kd_tree(std::span<const Point> points, const KdTreeOptions& options = {});
template <KeptPoint Point>
KdTree<Point> build_kd_tree(const std::vector<Point>& points, const KdTreeOptions& options = {}) {
  return build_kd_tree(std::span<const Point>(points), options);
}

/// Bytes that its arrays take.
template <class Point>
std::size_t memory_of(const KdTree<Point>& tree);

}  // namespace plumb

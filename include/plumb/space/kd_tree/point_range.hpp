// Range search: which of many points are in a ball, which in a box?
//
// Laws: (1) the points that contains() of a closed ball or box names, or without touching those that overlap it, in
// ascending order of their numbers.  (2) A batch answers each query as it is answered alone, on every number of
// threads.
// An inverted box holds nothing.  A negative radius throws InvalidShape, what is NaN or infinite NonFinite, by name.
// Source: RTCD 7.3.7.
// Cost: what is found, and the leaves at the border.  Bounded by n log n operations a query, the order of what is
// found, on integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

namespace space {
// Not a condition on Point: GCC and Clang give the linker different names of functions that take one.
template <class Point>
struct BoxOfPoint;
template <>
struct BoxOfPoint<Point2> {
  using Box = Aabb2;
};
template <>
struct BoxOfPoint<Point3> {
  using Box = Aabb3;
};
template <class Point>
using BoxOf = typename BoxOfPoint<Point>::Box;
}  // namespace space

/// Many lists, one after the other.
struct PointLists {
  std::vector<std::size_t> first = {0};  // of each list, and the end
  std::vector<std::uint32_t> numbers;

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(numbers).subspan(first[i], first[i + 1] - first[i]);
  }
  friend bool operator==(const PointLists&, const PointLists&) = default;
};

template <class Point>
std::vector<std::uint32_t> within(const KdTree<Point>& tree, const std::type_identity_t<Point>& p, double radius,
                                  std::vector<std::uint32_t> rows = {});
template <class Point>
std::vector<std::uint32_t> in_box(const KdTree<Point>& tree, const space::BoxOf<Point>& box,
                                  const InBoxOptions& options = {}, std::vector<std::uint32_t> rows = {});

template <class Point>
PointLists within(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries, double radius,
                  Execution execution = Execution::parallel, PointLists lists = {});
template <class Point>
PointLists in_box(const KdTree<Point>& tree, std::span<const space::BoxOf<Point>> boxes,
                  Execution execution = Execution::parallel, const InBoxOptions& options = {}, PointLists lists = {});

}  // namespace plumb

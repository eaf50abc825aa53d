// Extreme vertex of a fan: which of the many neighbors of a vertex lies beyond a plane through it?  In logarithmic
// time.
//
// The neighbors of a vertex of a convex polytope are, seen from it and cut by a plane, the corners of a convex polygon,
// in the order in which they stand around it.  Of every second of them, every fourth and so on the farthest is found by
// a step from the one before: a hierarchy of the plane.
// Laws: the fan's normal is a guess in doubles, and all the neighbors are strictly on its side by exact signs; where it
// is not so there is no fan, and the neighbors are asked one by one.
// Source: Dobkin and Kirkpatrick 1983; RTCD 9.3.1.
// Cost: two signs of degree 4 or more for each halving.
#pragma once

#include <optional>
#include <span>

#include "arith/vec.hpp"
#include "plumb/query/polytope_hierarchy/polytope_hierarchy.hpp"

namespace plumb::query::hierarchy {

/// Fewer are asked one by one.
inline constexpr std::size_t fewest_of_fan = 16;

/// Nothing where there are too few of them, or no normal was found.
std::optional<Vector3> fan_normal(std::span<const Point3> points, std::uint32_t vertex,
                                  std::span<const std::uint32_t> around);

/// The place of a greatest one in a cycle of numbers that rises to it from both sides.
template <class IsLess>
std::size_t greatest_of_cycle(std::size_t size, IsLess is_less) {
  std::size_t stride = 1, at = 0;
  while (2 * stride < size) stride *= 2;
  for (; stride > 0; stride /= 2) {
    const std::size_t last = (size - 1) / stride * stride;
    const std::size_t after = at == last ? 0 : at + stride, before = at == 0 ? last : at - stride;
    if (is_less(at, after)) at = after;
    if (is_less(at, before)) at = before;
  }
  return at;
}

/// A Direction tells the sign() of a text that takes it as a vector of any number type, of any length above zero. Of
/// the neighbors of the fan's vertex the one that lies farthest along a direction, as seen from there: where any lies
/// beyond the plane through the vertex at right angles to it, this does.
template <class Direction>
std::uint32_t farthest_of_fan(std::span<const Point3> points, const HierarchyLevel::Fan& fan,
                              std::span<const std::uint32_t> around, const Direction& direction) {
  const auto is_less = [&](std::size_t i, std::size_t j) {
    return direction.sign([&]<class T>(const arith::Vec<T>& d) {
      const arith::Vec<T> from = arith::vec<T>(points[fan.vertex]), up = arith::vec<T>(fan.normal);
      const arith::Vec<T> p = arith::vec<T>(points[around[i]]) - from, q = arith::vec<T>(points[around[j]]) - from;
      return dot(d, q) * dot(up, p) - dot(d, p) * dot(up, q);
    }) == Sign::positive;
  };
  return around[greatest_of_cycle(around.size(), is_less)];
}

}  // namespace plumb::query::hierarchy

// A box axis by axis: is it one, and do two meet?
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::space {

/// Throws NonFinite and InvalidShape, naming the function and the box.
template <class Box>
void check_cell_box(std::string_view function, std::string_view name, const Box& box) {
  const auto low = coordinates(box.min), high = coordinates(box.max);
  bool is_sound = true;
  for (std::size_t k = 0; k < low.size(); ++k) is_sound &= low[k] - low[k] == high[k] - high[k] && low[k] <= high[k];
  if (is_sound) return;
  const std::string min = std::string(name) + ".min", max = std::string(name) + ".max";
  figure::require_finite_parts<decltype(box.min), decltype(box.max)>(function, {min, max}, box.min, box.max);
  throw InvalidShape(std::string(function) + ": " + std::string(name) + " is empty; leave it out");
}

template <class Box>
void check_cell_boxes(std::string_view function, std::span<const Box> boxes) {
  bool is_sound = true;
  for (const Box& box : boxes) {
    const auto low = coordinates(box.min), high = coordinates(box.max);
    for (std::size_t k = 0; k < low.size(); ++k) is_sound &= low[k] - low[k] == high[k] - high[k] && low[k] <= high[k];
  }
  if (is_sound) return;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    check_cell_box(function, "boxes[" + std::to_string(i) + "]", boxes[i]);
  }
}

/// By its numbers along each axis.
template <std::size_t d>
auto box_between(const std::array<double, d>& low, const std::array<double, d>& high) {
  if constexpr (d == 2) {
    return Aabb2{{low[0], low[1]}, {high[0], high[1]}};
  } else {
    return Aabb3{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  }
}

inline bool meet(const Aabb2& a, const Aabb2& b) {
  return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) & (b.min.y <= a.max.y);
}
inline bool meet(const Aabb3& a, const Aabb3& b) {
  return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) & (b.min.y <= a.max.y) &
         (a.min.z <= b.max.z) & (b.min.z <= a.max.z);
}

/// The least box that holds both.
inline Aabb2 holding(const Aabb2& a, const Aabb2& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}
inline Aabb3 holding(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

inline bool is_in(const Aabb2& b, const Point2& p) {
  return (b.min.x <= p.x) & (p.x <= b.max.x) & (b.min.y <= p.y) & (p.y <= b.max.y);
}
inline bool is_in(const Aabb3& b, const Point3& p) {
  return (b.min.x <= p.x) & (p.x <= b.max.x) & (b.min.y <= p.y) & (p.y <= b.max.y) & (b.min.z <= p.z) &
         (p.z <= b.max.z);
}

}  // namespace plumb::space

#include "surface/repair/marked_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb::surface {
namespace {

bool boxes_meet(const Aabb3& a, const Aabb3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

/// Is all of the box within the length?  Its corners are, but for those that another is at least as far as on some axis.
bool is_within(const Aabb3& box, const Point3& p, double length) {
  const std::array<double, 3> low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z},
      at{p.x, p.y, p.z};
  // Where the point is between both sides, the farther one is a guess, and the other is asked as well.
  std::array<double, 3> far{}, other{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_high = at[k] <= low[k] || (at[k] < high[k] && high[k] - at[k] >= at[k] - low[k]);
    far[k] = is_high ? high[k] : low[k];
    const bool is_between = low[k] < at[k] && at[k] < high[k];
    other[k] = is_between && is_high ? low[k] : is_between ? high[k] : far[k];
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::size_t k) { return (corner >> k & 1) != 0 ? other[k] : far[k]; };
    const auto is_new = [&](std::size_t k) { return (corner >> k & 1) == 0 || other[k] != far[k]; };
    if (!is_new(0) || !is_new(1) || !is_new(2)) continue;
    if (compare_distance(p, Point3{side(0), side(1), side(2)}, length) == Sign::positive) return false;
  }
  return true;
}

/// A guess of how far the box's middle is: its half sum of distances along the axes.
double rough_distance(const Aabb3& box, const Point3& p) {
  const auto along = [](double low, double high, double x) { return std::fabs(low / 2 + high / 2 - x); };
  return along(box.min.x, box.max.x, p.x) + along(box.min.y, box.max.y, p.y) + along(box.min.z, box.max.z, p.z);
}

}  // namespace

MarkedPoints::MarkedPoints(std::span<const Point3> points, Execution execution)
    : points_(points),
      tree_(build_kd_tree(points, {.execution = execution})),
      slot_(points.size()),
      leaf_(points.size()),
      marked_(points.size()) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  nodes_.assign(2 * tree_.leaves() - 1, {{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}, 0});
  for (std::uint32_t leaf = 0; leaf < tree_.leaves(); ++leaf)
    for (std::uint32_t slot = tree_.first(leaf); slot < tree_.first(leaf + 1); ++slot) leaf_[slot] = leaf;
  for (std::uint32_t slot = 0; slot < points.size(); ++slot) slot_[tree_.numbers[slot]] = slot;
}

template <class Visit>
void MarkedPoints::each_above(std::uint32_t point, const Visit& visit) {
  std::size_t node = tree_.leaves() - 1 + leaf_[slot_[point]];
  for (; node != 0; node = (node - 1) / 2) visit(nodes_[node]);
  visit(nodes_[0]);
}

void MarkedPoints::mark(std::uint32_t point) {
  const Point3& p = points_[point];
  marked_[slot_[point]] = 1;
  each_above(point, [&](Node& node) {
    Aabb3& b = node.box;
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y), std::min(b.min.z, p.z)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y), std::max(b.max.z, p.z)};
    ++node.count;
  });
}

void MarkedPoints::unmark(std::uint32_t point) {
  marked_[slot_[point]] = 0;
  each_above(point, [](Node& node) { --node.count; });
}

void MarkedPoints::add_within(std::size_t node, const Point3& p, double length, const Aabb3& around,
                              std::vector<std::uint32_t>& found) const {
  if (nodes_[node].count == 0 || !boxes_meet(nodes_[node].box, around)) return;
  if (node + 1 < tree_.leaves()) {
    add_within(2 * node + 1, p, length, around, found);
    add_within(2 * node + 2, p, length, around, found);
    return;
  }
  const std::size_t leaf = node + 1 - tree_.leaves();
  for (std::uint32_t slot = tree_.first(leaf); slot < tree_.first(leaf + 1); ++slot) {
    if (marked_[slot] == 0) continue;
    const std::uint32_t other = tree_.numbers[slot];
    if (compare_distance(p, points_[other], length) != Sign::positive) found.push_back(other);
  }
}

bool MarkedPoints::any_beyond(std::size_t node, const Point3& p, double length) const {
  if (nodes_[node].count == 0 || is_within(nodes_[node].box, p, length)) return false;
  if (node + 1 < tree_.leaves()) {
    std::size_t first = 2 * node + 1, second = first + 1;
    if (rough_distance(nodes_[first].box, p) < rough_distance(nodes_[second].box, p)) std::swap(first, second);
    return any_beyond(first, p, length) || any_beyond(second, p, length);
  }
  const std::size_t leaf = node + 1 - tree_.leaves();
  for (std::uint32_t slot = tree_.first(leaf); slot < tree_.first(leaf + 1); ++slot)
    if (marked_[slot] != 0 && compare_distance(p, points_[tree_.numbers[slot]], length) == Sign::positive) return true;
  return false;
}

}  // namespace plumb::surface

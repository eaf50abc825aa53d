#include "plumb/space/coherence/kept_range.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/pairs/boxes_meet.hpp"
#include "space/range/range_tests.hpp"

namespace plumb {
namespace {

Aabb3 box_of(const Aabb3& box) { return box; }
template <class Shape>
Aabb3 box_of(const Shape& shape) {
  return fit_aabb(shape);
}

/// Larger on all sides, as far as doubles go; any that holds the box would do, and of lengths that are no doubles (and
/// times zero no numbers) it is the largest.
Aabb3 region_around(const Aabb3& box, double margin) {
  constexpr double most = std::numeric_limits<double>::max();
  const double by = margin * std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const auto low = [&](double x) { return std::max(-most, x - by); };
  const auto high = [&](double x) { return std::min(most, x + by); };
  return {{low(box.min.x), low(box.min.y), low(box.min.z)}, {high(box.max.x), high(box.max.y), high(box.max.z)}};
}

}  // namespace

KeptRange::KeptRange(const Bvh& mesh, double margin) : mesh_(&mesh), margin_(margin) {
  if (!(margin >= 0 && margin <= std::numeric_limits<double>::max())) {
    throw InvalidShape("KeptRange: margin is " + std::to_string(margin) + ", but it must be finite and not negative");
  }
}

void KeptRange::fill() {
  row_.clear();
  const space::SlotTriangles triangles(*mesh_);
  descend(mesh_->tree, space::node_may_meet(mesh_->tree.frame, region_), [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const Triangle3 t = triangles.triangle(slot);
      const Aabb3 box = space::box_around(t.a, t.b, t.c);
      if (space::boxes_meet(box, region_, true)) row_.push_back({box, t, triangles.number(slot)});
    }
  });
  std::sort(row_.begin(), row_.end(), [](const Kept& a, const Kept& b) { return a.number < b.number; });
  const auto is_same = [](const Kept& a, const Kept& b) {
    return a.number == b.number;
  };  // one may be in several slots
  row_.erase(std::unique(row_.begin(), row_.end(), is_same), row_.end());
  is_filled_ = true;
}

template <KeptRangeShape Shape>
std::vector<std::uint32_t> KeptRange::meeting(const Shape& shape, std::vector<std::uint32_t> rows) {
  rows.clear();
  (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shape);  // throws where the numbers are no shape
  by_row_ = false;
  if constexpr (std::same_as<Shape, Aabb3>) {
    if (is_empty(shape)) return rows;
  }
  Aabb3 box;
  try {
    box = box_of(shape);
  } catch (const BeyondDoubles&) {  // no box of doubles holds it
    return plumb::meeting(*mesh_, shape, std::move(rows));
  }
  if (is_empty(region_) || !contains(region_, box)) {
    region_ = region_around(box, margin_);
    is_filled_ = false;
    return plumb::meeting(*mesh_, shape, std::move(rows));
  }
  if (!is_filled_) fill();
  by_row_ = true;
  for (const Kept& k : row_) {
    if (space::boxes_meet(k.box, box, true) && space::meets_triangle(k.triangle, shape)) rows.push_back(k.number);
  }
  return rows;
}

template std::vector<std::uint32_t> KeptRange::meeting(const Aabb3&, std::vector<std::uint32_t>);
template std::vector<std::uint32_t> KeptRange::meeting(const Obb3&, std::vector<std::uint32_t>);
template std::vector<std::uint32_t> KeptRange::meeting(const Sphere3&, std::vector<std::uint32_t>);
template std::vector<std::uint32_t> KeptRange::meeting(const Capsule3&, std::vector<std::uint32_t>);
template std::vector<std::uint32_t> KeptRange::meeting(const Segment3&, std::vector<std::uint32_t>);

}  // namespace plumb

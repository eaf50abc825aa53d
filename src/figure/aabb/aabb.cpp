#include "plumb/figure/aabb/aabb.hpp"

#include <algorithm>

#include "figure/aabb/ranges.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using figure::require_finite_points;

using namespace figure::box;

[[noreturn]] void throw_no_points() { throw InvalidShape("fit_aabb: no points; give at least one"); }

}  // namespace

Aabb2 fit_aabb(std::span<const Point2> points) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  Aabb2 b{points[0], points[0]};
  for (const Point2& p : points) {
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y)};
  }
  return b;
}

Aabb3 fit_aabb(std::span<const Point3> points) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  Aabb3 b{points[0], points[0]};
  for (const Point3& p : points) {
    b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y), std::min(b.min.z, p.z)};
    b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y), std::max(b.max.z, p.z)};
  }
  return b;
}

Aabb3 fit_aabb(std::span<const Point3> points, const Pose& pose) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  const auto& [c, t] = pose;
  figure::require_sound("fit_aabb", pose);
  const auto range = [&](std::size_t axis, double translation, const Vector3& row) {
    const Point3 *least = points.data(), *greatest = least;
    for (const Point3& p : points) {
      if (sign_of(predicates::OrderAlongDirection3d{}, p, *greatest, row) == Sign::positive) {
        greatest = &p;
      } else if (sign_of(predicates::OrderAlongDirection3d{}, p, *least, row) == Sign::negative) {
        least = &p;
      }
    }
    const auto bound = [&](Rounding rounding, const Point3& p, std::string_view name) {
      return figure::within_doubles(rounded_value(rounding, image, translation, row.x, p.x, row.y, p.y, row.z, p.z),
                                    "fit_aabb", name);
    };
    return Range{bound(Rounding::down, *least, min_name[axis]), bound(Rounding::up, *greatest, max_name[axis])};
  };
  return box_of(range(0, t.x, {c[0].x, c[1].x, c[2].x}), range(1, t.y, {c[0].y, c[1].y, c[2].y}),
                range(2, t.z, {c[0].z, c[1].z, c[2].z}));
}

Aabb2 merge(const Aabb2& a, const Aabb2& b) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

Aabb3 merge(const Aabb3& a, const Aabb3& b) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

Aabb2 transform(const Aabb2& box, const Pose2& pose) {
  const auto& [c, t] = pose;
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  if (is_empty(box)) return box;
  const std::array from{box.min.x, box.min.y, 0.0}, to{box.max.x, box.max.y, 0.0};
  return box_of(range_of_image("transform", 0, t.x, {c[0].x, c[1].x, 0}, from, to),
                range_of_image("transform", 1, t.y, {c[0].y, c[1].y, 0}, from, to));
}

Aabb3 transform(const Aabb3& box, const Pose& pose) {
  const auto& [c, t] = pose;
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  if (is_empty(box)) return box;
  const std::array from{box.min.x, box.min.y, box.min.z}, to{box.max.x, box.max.y, box.max.z};
  return box_of(range_of_image("transform", 0, t.x, {c[0].x, c[1].x, c[2].x}, from, to),
                range_of_image("transform", 1, t.y, {c[0].y, c[1].y, c[2].y}, from, to),
                range_of_image("transform", 2, t.z, {c[0].z, c[1].z, c[2].z}, from, to));
}

Aabb2 expand(const Aabb2& box, double margin) {
  figure::require_sound("expand", box, part::place("margin", margin));
  if (is_empty(box)) return box;
  const auto range = [&](std::size_t axis, double from, double to) {
    return Range{least_sum("expand", axis, from, -margin), greatest_sum("expand", axis, to, margin)};
  };
  return box_of(range(0, box.min.x, box.max.x), range(1, box.min.y, box.max.y));
}

Aabb3 expand(const Aabb3& box, double margin) {
  figure::require_sound("expand", box, part::place("margin", margin));
  if (is_empty(box)) return box;
  const auto range = [&](std::size_t axis, double from, double to) {
    return Range{least_sum("expand", axis, from, -margin), greatest_sum("expand", axis, to, margin)};
  };
  return box_of(range(0, box.min.x, box.max.x), range(1, box.min.y, box.max.y), range(2, box.min.z, box.max.z));
}

}  // namespace plumb

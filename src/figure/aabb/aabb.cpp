#include "plumb/figure/aabb/aabb.hpp"

#include <algorithm>

#include "figure/aabb/ranges.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/image_order.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace {

using figure::require_finite_points;

using namespace figure::box;

/// Between the images of two points, which are the extreme ones.
Range range_of_image(std::string_view function, const figure::CertainPose& pose, std::size_t axis, const Point3& least,
                     const Point3& greatest) {
  const auto bound = [&](Rounding rounding, const Point3& p, std::string_view name) {
    const auto numerator = [&]<class T>(const figure::PoseNumbers<T>& n) { return n.image(arith::vec<T>(p), axis); };
    return figure::within_doubles(pose.rounded(rounding, numerator), function, name);
  };
  return {bound(Rounding::down, least, min_name[axis]), bound(Rounding::up, greatest, max_name[axis])};
}

/// Each term takes the end that the sign of its factor names.
Range range_of_image(const figure::CertainPose& pose, std::size_t axis, const Aabb3& box) {
  const auto is_negative = [&](std::size_t column) {
    return pose.sign([&](const auto& n) { return n.entry(axis, column); }) == Sign::negative;
  };
  const bool x = is_negative(0), y = is_negative(1), z = is_negative(2);
  const auto& [min, max] = box;
  return range_of_image("transform", pose, axis, {x ? max.x : min.x, y ? max.y : min.y, z ? max.z : min.z},
                        {x ? min.x : max.x, y ? min.y : max.y, z ? min.z : max.z});
}

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

Aabb3 fit_aabb(std::span<const Point3> points, PoseView pose) {
  if (points.empty()) throw_no_points();
  require_finite_points("fit_aabb", "points", points);
  figure::require_sound("fit_aabb", pose);
  const figure::CertainPose moved(pose);
  const figure::ImageOrder order(moved);
  const auto range = [&](std::size_t axis) {
    const Point3 *least = points.data(), *greatest = least;
    for (const Point3& p : points) {
      if (order(axis, p, *greatest) == Sign::positive) {
        greatest = &p;
      } else if (order(axis, p, *least) == Sign::negative) {
        least = &p;
      }
    }
    return range_of_image("fit_aabb", moved, axis, *least, *greatest);
  };
  return box_of(range(0), range(1), range(2));
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

Aabb2 transform(const Aabb2& box, PoseView2 pose) {
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  if (is_empty(box)) return box;
  const figure::CertainPose moved(pose);
  const Aabb3 raised{{box.min.x, box.min.y, 0}, {box.max.x, box.max.y, 0}};
  return box_of(range_of_image(moved, 0, raised), range_of_image(moved, 1, raised));
}

Aabb3 transform(const Aabb3& box, PoseView pose) {
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  if (is_empty(box)) return box;
  const figure::CertainPose moved(pose);
  return box_of(range_of_image(moved, 0, box), range_of_image(moved, 1, box), range_of_image(moved, 2, box));
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

#include "plumb/query/body/restated.hpp"

#include <cmath>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error_free.hpp"

namespace plumb::query {
namespace {

/// a + b, where it is a double.
std::optional<double> exact_end(double a, double b) {
  const Rounded s = two_sum(a, b);
  return std::isfinite(s.value) && s.error == 0 ? std::optional(s.value) : std::nullopt;
}

/// From `from` - below to `from` + above.
std::optional<Aabb3> exact_box(const Point3& from, const Vector3& below, const Vector3& above) {
  const auto x = exact_end(from.x, -below.x), y = exact_end(from.y, -below.y), z = exact_end(from.z, -below.z);
  const auto p = exact_end(from.x, above.x), q = exact_end(from.y, above.y), r = exact_end(from.z, above.z);
  if (!x || !y || !z || !p || !q || !r) return {};
  return Aabb3{{*x, *y, *z}, {*p, *q, *r}};
}

Vector3 magnitudes(const Vector3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

}  // namespace

std::optional<Aabb3> box_in_doubles(std::string_view function, const AabbWidths3& box) {
  require_finite_parts(function, {"box.min", "box.widths"}, box.min, box.widths);
  return exact_box(box.min, {0, 0, 0}, magnitudes(box.widths));
}
std::optional<Aabb3> box_in_doubles(std::string_view function, const AabbCenter3& box) {
  require_finite_parts(function, {"box.center", "box.half"}, box.center, box.half);
  const Vector3 half = magnitudes(box.half);
  return exact_box(box.center, half, half);
}

Posed<Aabb3> box_as_it_is(const AabbWidths3& box) {
  const Vector3 w = magnitudes(box.widths);
  return {{{0, 0, 0}, {w.x, w.y, w.z}}, {identity_pose.columns, {box.min.x, box.min.y, box.min.z}}};
}
Obb3 box_as_it_is(const AabbCenter3& box) { return {box.center, identity_pose.columns, box.half}; }

void require_slab(std::string_view function, const Slab2& slab) {
  require_finite_parts(function, {"slab.normal", "slab.min", "slab.max"}, slab.normal, slab.min, slab.max);
}
void require_slab(std::string_view function, const Slab3& slab) {
  require_finite_parts(function, {"slab.normal", "slab.min", "slab.max"}, slab.normal, slab.min, slab.max);
}

}  // namespace plumb::query

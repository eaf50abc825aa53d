#include <bit>
#include <cmath>

#include "figure/support/input.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

/// From one corner of a box to the other, by axis: which end lies farther, and whether both do.
struct BoxVertex {
  std::uint32_t bits = 0;
  bool unique = true;

  void axis(std::uint32_t i, Sign farther, bool flat) {
    if (farther == Sign::positive && !flat) bits |= 1u << i;
    if (farther == Sign::zero && !flat) unique = false;
  }
  [[nodiscard]] bool has(std::uint32_t i) const { return (bits >> i & 1) != 0; }
};

BoxVertex aligned(const Vector3& d, bool flat_x, bool flat_y, bool flat_z) {
  BoxVertex ends;
  ends.axis(0, sign_of_number(d.x), flat_x);
  ends.axis(1, sign_of_number(d.y), flat_y);
  ends.axis(2, sign_of_number(d.z), flat_z);
  return ends;
}

[[noreturn]] void throw_empty(const char* axis) {
  throw InvalidShape(
      std::string("support_point: box is empty, min.").append(axis).append(" exceeds max.").append(axis));
}

Support3 of(const Aabb3& box, const Vector3& d) {
  if (box.min.x > box.max.x) throw_empty("x");
  if (box.min.y > box.max.y) throw_empty("y");
  if (box.min.z > box.max.z) throw_empty("z");
  const BoxVertex e = aligned(d, box.min.x == box.max.x, box.min.y == box.max.y, box.min.z == box.max.z);
  return {{e.has(0) ? box.max.x : box.min.x, e.has(1) ? box.max.y : box.min.y, e.has(2) ? box.max.z : box.min.z},
          e.bits,
          e.unique};
}

/// center + the sum of +-half_i axes_i.
Support3 of(const Point3& center, const std::array<Vector3, 3>& axes, const Vector3& half, const Vector3& d) {
  const std::array<double, 3> reach{std::fabs(half.x), std::fabs(half.y), std::fabs(half.z)};
  BoxVertex ends;
  for (std::uint32_t i = 0; i < 3; ++i)
    ends.axis(i, sign_of(predicates::Dot3d{}, axes[i], d), reach[i] == 0 || figure::support::is_zero(axes[i]));
  const auto coordinate = [&](double Point3::*c, double Vector3::*v) {
    return arith::exact_sum::nearest([&](const auto& number) {
      auto sum = number(center.*c);
      for (std::uint32_t i = 0; i < 3; ++i) sum = sum + number(ends.has(i) ? reach[i] : -reach[i]) * number(axes[i].*v);
      return sum;
    });
  };
  const Point3 p{coordinate(&Point3::x, &Vector3::x), coordinate(&Point3::y, &Vector3::y),
                 coordinate(&Point3::z, &Vector3::z)};
  return {figure::support::within_doubles(p), ends.bits, ends.unique};
}

}  // namespace

Support2 support_point(const Aabb2& box, const Vector2& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  const Support3 s =
      of(Aabb3{figure::support::raised(box.min), figure::support::raised(box.max)}, figure::support::raised(direction));
  return {{s.point.x, s.point.y}, s.feature, s.unique};
}

Support3 support_point(const Aabb3& box, const Vector3& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  return of(box, direction);
}

Support3 support_point(const AabbWidths3& box, const Vector3& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  const Vector3& w = box.widths;
  const BoxVertex e = aligned(direction, w.x == 0, w.y == 0, w.z == 0);
  const Point3 p{box.min.x + (e.has(0) ? std::fabs(w.x) : 0), box.min.y + (e.has(1) ? std::fabs(w.y) : 0),
                 box.min.z + (e.has(2) ? std::fabs(w.z) : 0)};
  return {figure::support::within_doubles(p), e.bits, e.unique};
}

Support3 support_point(const AabbCenter3& box, const Vector3& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  const Vector3& h = box.half;
  const BoxVertex e = aligned(direction, h.x == 0, h.y == 0, h.z == 0);
  const auto end = [](double center, double half, bool far) { return center + (far ? 1 : -1) * std::fabs(half); };
  const Point3 p{end(box.center.x, h.x, e.has(0)), end(box.center.y, h.y, e.has(1)), end(box.center.z, h.z, e.has(2))};
  return {figure::support::within_doubles(p), e.bits, e.unique};
}

Support2 support_point(const Obb2& box, const Vector2& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  const Support3 s = of(figure::support::raised(box.center),
                        {figure::support::raised(box.axes[0]), figure::support::raised(box.axes[1])},
                        figure::support::raised(box.half), figure::support::raised(direction));
  return {{s.point.x, s.point.y}, s.feature, s.unique};
}

Support3 support_point(const Obb3& box, const Vector3& direction) {
  figure::require_sound("support_point", box, part::axis("direction", direction));
  return of(box.center, box.axes, box.half, direction);
}

Support3 support_point(const Rectangle3& r, const Vector3& direction) {
  figure::require_sound("support_point", r, part::axis("direction", direction));
  return of(r.center, {r.axes[0], r.axes[1]}, figure::support::raised(r.half), direction);
}

}  // namespace plumb

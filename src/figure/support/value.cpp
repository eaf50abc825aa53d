#include <cmath>

#include "certify/rounded.hpp"
#include "figure/support/forms.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

using figure::support::raised;

double at_vertex(Rounding rounding, const Vector3& direction, const Point3& vertex) {
  return rounded_value(rounding, predicates::Dot3d{}, direction, Vector3{vertex.x, vertex.y, vertex.z});
}

// center . d + the sum of |half_i (axes_i . d)|.
double of_box(const Point3& center, const std::array<Vector3, 3>& axes, const Vector3& reach, const Vector3& direction,
              Rounding rounding) {
  const std::array<double, 3> half{std::fabs(reach.x), std::fabs(reach.y), std::fabs(reach.z)};
  std::array<double, 3> times{};  // half_i with the sign of axes_i . direction
  for (std::size_t i = 0; i < 3; ++i)
    times[i] = sign_of(predicates::Dot3d{}, axes[i], direction) == Sign::negative ? -half[i] : half[i];
  return arith::radial::rounded(rounding, [&](const auto& number) {
    using T = arith::exact_sum::Number<std::decay_t<decltype(number)>>;
    auto sum = figure::signed_sums::vector(number, center);
    for (std::size_t i = 0; i < 3; ++i) sum = sum + number(times[i]) * figure::signed_sums::vector(number, axes[i]);
    return arith::radial::Parts<T>{figure::signed_sums::dot(sum, figure::signed_sums::vector(number, direction)),
                                   number(0.0), number(1.0)};
  });
}

constexpr std::array upright{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};

template <class Shape>
double of_round(const Shape& shape, const Vector3& direction, Rounding rounding) {
  figure::require_sound("support_value", shape, part::axis("direction", direction));
  const figure::support::Choice c = figure::support::choose(shape, direction);
  return figure::support::rounded(rounding, shape, direction, c, [&](const auto& number, const auto& v) {
    return figure::signed_sums::dot(v, figure::signed_sums::vector(number, direction));
  });
}

}  // namespace

double support_value(std::span<const Point3> points, const Vector3& direction, Rounding rounding) {
  return at_vertex(rounding, direction, support_point(points, direction).point);
}
double support_value(const ConvexPolyhedron3& polyhedron, const Vector3& direction, Rounding rounding) {
  return at_vertex(rounding, direction, support_point(polyhedron, direction).point);
}
double support_value(const Aabb3& box, const Vector3& direction, Rounding rounding) {
  return at_vertex(rounding, direction, support_point(box, direction).point);
}
double support_value(const Obb3& box, const Vector3& direction, Rounding rounding) {
  figure::require_sound("support_value", box, part::axis("direction", direction));
  return of_box(box.center, box.axes, box.half, direction, rounding);
}

double support_value(const AabbCenter3& box, const Vector3& direction, Rounding rounding) {
  figure::require_sound("support_value", box, part::axis("direction", direction));
  return of_box(box.center, upright, box.half, direction, rounding);
}
double support_value(const AabbWidths3& box, const Vector3& direction, Rounding rounding) {
  figure::require_sound("support_value", box, part::axis("direction", direction));
  const auto ahead = [](double width, double d) { return d > 0 ? std::fabs(width) : 0; };
  return rounded_value(
      rounding,
      [](auto dx, auto dy, auto dz, auto x, auto y, auto z, auto u, auto v, auto w) {
        return dx * (x + u) + (dy * (y + v) + dz * (z + w));
      },
      direction, box.min, ahead(box.widths.x, direction.x), ahead(box.widths.y, direction.y),
      ahead(box.widths.z, direction.z));
}

double support_value(std::span<const Point2> points, const Vector2& direction, Rounding rounding) {
  const Point2 p = support_point(points, direction).point;
  return at_vertex(rounding, raised(direction), raised(p));
}
double support_value(const Aabb2& box, const Vector2& direction, Rounding rounding) {
  return at_vertex(rounding, raised(direction), raised(support_point(box, direction).point));
}
double support_value(const Obb2& box, const Vector2& direction, Rounding rounding) {
  figure::require_sound("support_value", box, part::axis("direction", direction));
  return of_box(raised(box.center), {raised(box.axes[0]), raised(box.axes[1]), Vector3{0, 0, 0}}, raised(box.half),
                raised(direction), rounding);
}
double support_value(const Circle2& circle, const Vector2& direction, Rounding rounding) {
  figure::require_sound("support_value", circle, part::axis("direction", direction));
  return of_round(Sphere3{raised(circle.center), circle.radius}, raised(direction), rounding);
}
double support_value(const Capsule2& capsule, const Vector2& direction, Rounding rounding) {
  return of_round(Capsule3{raised(capsule.a), raised(capsule.b), capsule.radius}, raised(direction), rounding);
}

double support_value(const Sphere3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}
double support_value(const Capsule3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}
double support_value(const Lozenge3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}
double support_value(const Cylinder3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}
double support_value(const Cone3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}
double support_value(const Ellipsoid3& s, const Vector3& direction, Rounding rounding) {
  return of_round(s, direction, rounding);
}

}  // namespace plumb

#include "certify/rounded.hpp"
#include "figure/support/forms.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

double at_vertex(Rounding rounding, const Vector3& direction, const Point3& vertex) {
  return rounded_value(rounding, predicates::Dot3d{}, direction, Vector3{vertex.x, vertex.y, vertex.z});
}

template <class Shape>
double of_round(const Shape& shape, const Vector3& direction, Rounding rounding) {
  figure::support::require("support_value", shape, direction);
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
  require_finite_parts("support_value",
                       {"box.center", "box.axes[0]", "box.axes[1]", "box.axes[2]", "box.half", "direction"}, box.center,
                       box.axes[0], box.axes[1], box.axes[2], box.half, direction);
  const std::array<double, 3> half{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)};
  std::array<double, 3> times{};  // half_i with the sign of axes_i . direction
  for (std::size_t i = 0; i < 3; ++i)
    times[i] = sign_of(predicates::Dot3d{}, box.axes[i], direction) == Sign::negative ? -half[i] : half[i];
  return arith::radial::rounded(rounding, [&](const auto& number) {
    using T = arith::exact_sum::Number<std::decay_t<decltype(number)>>;
    auto sum = figure::signed_sums::vector(number, box.center);
    for (std::size_t i = 0; i < 3; ++i) sum = sum + number(times[i]) * figure::signed_sums::vector(number, box.axes[i]);
    return arith::radial::Parts<T>{figure::signed_sums::dot(sum, figure::signed_sums::vector(number, direction)),
                                   number(0.0), number(1.0)};
  });
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

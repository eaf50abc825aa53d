// What of a ball cut by a plane lies farthest?  The ball's own farthest point, where the plane leaves it, else one of the
// circle that the plane cuts.
#include "figure/support/forms.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

using figure::signed_sums::dot;
using figure::signed_sums::vector;
using figure::signed_sums::VectorOf;
using figure::support::Choice;

/// How far the plane lies beyond the center, times the length of its normal, and what its circle's radius is a root of,
/// times the square of that.
template <class M>
struct Cut {
  using T = arith::exact_sum::Number<M>;
  Cut(const M& number, const SphericalCap3& s)
      : normal(vector(number, s.halfspace.normal)),
        depth(number(s.halfspace.offset) - dot(normal, vector(number, s.sphere.center))),
        square(dot(normal, normal)),
        circle(number(s.sphere.radius) * number(s.sphere.radius) * square - depth * depth) {}
  VectorOf<M> normal;
  T depth, square, circle;
};

template <class Take>
Sign sign_of_sum(const Take& take) {
  return arith::exact_sum::sign(take);
}

Sign circle_sign(const SphericalCap3& s) {
  return sign_of_sum([&](const auto& number) { return Cut(number, s).circle; });
}
Sign depth_sign(const SphericalCap3& s) {
  return sign_of_sum([&](const auto& number) { return Cut(number, s).depth; });
}

/// Does the halfspace hold the ball's farthest point?  depth |d| >= radius normal . d, for d that is not zero.
bool holds_farthest(const SphericalCap3& s, const Vector3& d) {
  const Sign depth = depth_sign(s);
  const Sign along = sign_of_sum([&](const auto& number) {
    return number(s.sphere.radius) * dot(vector(number, s.halfspace.normal), vector(number, d));
  });
  if (depth != along) return depth > along;
  const Sign by_squares = sign_of_sum([&](const auto& number) {
    const auto direction = vector(number, d);
    const Cut cut(number, s);
    const auto reach = number(s.sphere.radius) * dot(cut.normal, direction);
    return cut.depth * cut.depth * dot(direction, direction) - reach * reach;
  });
  return depth == Sign::negative ? by_squares != Sign::positive : by_squares != Sign::negative;
}

Choice choose(const SphericalCap3& s, const Vector3& d) {
  const bool point = s.sphere.radius == 0;
  if (figure::support::is_zero(d)) {
    const bool center = depth_sign(s) != Sign::negative;
    return {center ? 0u : 1u, point || (!center && circle_sign(s) == Sign::zero), false};
  }
  if (holds_farthest(s, d)) return {0, true, !point};
  const bool along = sign_of_sum([&](const auto& number) {
                       const auto across = cross(vector(number, s.halfspace.normal), vector(number, d));
                       return dot(across, across);
                     }) == Sign::zero;
  const bool touched = circle_sign(s) == Sign::zero;
  return {1, touched || !along, !touched && !along};
}

/// One number of the answer, as figure::support::rounded makes it.
template <class Take>
double rounded_of_cap(Rounding rounding, const SphericalCap3& s, const Vector3& d, const Choice& c, const Take& take) {
  return arith::radial::rounded(rounding, [&](const auto& number) {
    using T = arith::exact_sum::Number<std::decay_t<decltype(number)>>;
    const auto center = vector(number, s.sphere.center), direction = vector(number, d);
    if (c.feature == 0) {
      if (!c.round) return arith::radial::Parts<T>{take(number, center), number(0.0), number(1.0)};
      return arith::radial::Parts<T>{take(number, center), take(number, number(s.sphere.radius) * direction),
                                     dot(direction, direction)};
    }
    const Cut cut(number, s);
    const auto middle = cut.square * center + cut.depth * cut.normal;
    if (!c.round) return arith::radial::Parts<T>{take(number, middle), number(0.0), number(1.0), cut.square};
    const auto across = cut.square * direction - dot(cut.normal, direction) * cut.normal;
    const T reach = cut.circle * cut.square;
    return arith::radial::Parts<T>{take(number, middle), take(number, reach * across), reach * dot(across, across),
                                   cut.square};
  });
}

void require_cap(std::string_view function, const SphericalCap3& s, const Vector3& d) {
  figure::require_sound(function, s, part::axis("direction", d));
  if (depth_sign(s) == Sign::negative && circle_sign(s) == Sign::negative)
    throw InvalidShape(std::string(function).append(": the cap is empty; give a plane that leaves some of the ball"));
}

}  // namespace

Support3 support_point(const SphericalCap3& cap, const Vector3& direction) {
  require_cap("support_point", cap, direction);
  const Vector3 d = figure::support::handy(direction);
  const Choice c = choose(cap, d);
  const auto nearest = [&](const auto& take) { return rounded_of_cap(Rounding::nearest, cap, d, c, take); };
  const Point3 p{nearest([](const auto&, const auto& v) { return v.x; }),
                 nearest([](const auto&, const auto& v) { return v.y; }),
                 nearest([](const auto&, const auto& v) { return v.z; })};
  return {figure::support::within_doubles(p), c.feature, c.unique};
}

double support_value(const SphericalCap3& cap, const Vector3& direction, Rounding rounding) {
  require_cap("support_value", cap, direction);
  return rounded_of_cap(rounding, cap, direction, choose(cap, direction),
                        [&](const auto& number, const auto& v) { return dot(v, vector(number, direction)); });
}

}  // namespace plumb

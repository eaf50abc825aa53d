#include "query/time_of_impact/contact_at_root.hpp"

#include "arith/certain.hpp"

namespace plumb::query::moving {
namespace {

Ball ball_difference(double a, double b) {
  const Rounded d = two_sum(a, -b);
  if (!(Ball::size(d.value) <= 0x1p1021)) return {0, 0, Ball::infinity};
  return {d.value, d.error, 0};
}
std::array<Ball, 3> ball_difference(const Point3& a, const Point3& b) {
  return {ball_difference(a.x, b.x), ball_difference(a.y, b.y), ball_difference(a.z, b.z)};
}

/// One coordinate of a cross product.
Ball cross_coordinate(const std::array<Ball, 3>& a, const std::array<Ball, 3>& b, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  return a[i] * b[j] - a[j] * b[i];
}

}  // namespace

ContactAtRoot::ContactAtRoot(MovingKind kind, std::span<const Point3, 4> p, std::span<const Point3, 4> q)
    : kind_(kind),
      differences_{[&] {
        const auto linear = [&](std::size_t i, std::size_t j) {
          return Linear{ball_difference(p[i], p[j]), ball_difference(q[i], q[j])};
        };
        if (kind == MovingKind::vertex_triangle)
          return std::array{linear(1, 0), linear(2, 0), linear(3, 0), linear(3, 0)};
        return std::array{linear(2, 0), linear(3, 0), linear(2, 1), linear(3, 1)};
      }()},
      cubic_{Ball{0}, Ball{0}, Ball{0}, Ball{0}} {
  const auto& [a, b, c, d] = differences_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::array<Ball, 3> n = product(a, b, axis);
    cubic_[0] = cubic_[0] + c.at_0[axis] * n[0];
    cubic_[1] = cubic_[1] + (c.at_0[axis] * n[1] + c.at_1[axis] * n[0]);
    cubic_[2] = cubic_[2] + (c.at_0[axis] * n[2] + c.at_1[axis] * n[1]);
    cubic_[3] = cubic_[3] + c.at_1[axis] * n[2];
  }
}

std::array<Ball, 3> ContactAtRoot::product(const Linear& a, const Linear& b, std::size_t axis) {
  return {cross_coordinate(a.at_0, b.at_0, axis),
          cross_coordinate(a.at_0, b.at_1, axis) + cross_coordinate(a.at_1, b.at_0, axis),
          cross_coordinate(a.at_1, b.at_1, axis)};
}

Ball ContactAtRoot::cubic(const Ball& t) const {
  const Ball u = Ball{1} - t, square = t * t;
  return ((cubic_[0] * u + cubic_[1] * t) * u + cubic_[2] * square) * u + cubic_[3] * square * t;
}

std::optional<Ball> ContactAtRoot::root(const Bracket& bracket) const {
  const Ball at_guess = cubic(Ball{bracket.guess});
  Ball t = Ball{bracket.guess} - Ball{(at_guess.high + at_guess.low) / bracket.slope};
  t.radius = 0;
  if (!(t.high > bracket.from && t.high < bracket.to)) return {};
  const Ball value = cubic(t);
  t.radius = quotient(Interval(most_of(value)), Interval(bracket.least_slope)).upper;
  if (!(t.radius < 1)) return {};
  return t;
}

Crossing ContactAtRoot::crossing(const Ball& t, std::size_t axis) const {
  const Ball u = Ball{1} - t;
  const auto side = [&](std::size_t i, std::size_t j) {
    const std::array<Ball, 3> q = product(differences_[i], differences_[j], axis);
    return certain_sign((q[0] * u + q[1] * t) * u + q[2] * (t * t));
  };
  if (kind_ == MovingKind::vertex_triangle) {
    const int a = side(0, 1), b = side(1, 2), c = side(2, 0);
    if (a * b < 0 || b * c < 0 || c * a < 0) return Crossing::apart;
    return a * b * c != 0 ? Crossing::across : Crossing::unknown;
  }
  const int a = side(0, 1), b = side(2, 3), c = side(0, 2), d = side(1, 3);
  if (a * b > 0 || c * d > 0) return Crossing::apart;
  return a * b * c * d != 0 ? Crossing::across : Crossing::unknown;
}

}  // namespace plumb::query::moving

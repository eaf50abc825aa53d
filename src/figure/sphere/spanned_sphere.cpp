#include "plumb/figure/sphere/spanned_sphere.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arith/big_rounding.hpp"
#include "arith/twofold.hpp"
#include "arith/vec.hpp"
#include "certify/carried_errors.hpp"
#include "certify/fused.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/spanned_ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

/// The center is the first point + offset / weight, over the numbers T, of the points of a circle or of three or four
/// points of space.
template <class T, std::size_t axes>
struct CenterParts {
  std::array<T, axes> offset;
  T weight;
};

/// Exact, and with less to carry along where a difference of two doubles is stated of its own.
template <class T>
T step(double to, double from) {
  if constexpr (requires { T::difference(to, from); }) {
    return T::difference(to, from);
  } else {
    return T(to) - T(from);
  }
}
template <class T>
arith::Vec<T> step(const Point2& to, const Point2& from) {
  return {step<T>(to.x, from.x), step<T>(to.y, from.y), T(0.0)};
}
template <class T>
arith::Vec<T> step(const Point3& to, const Point3& from) {
  return {step<T>(to.x, from.x), step<T>(to.y, from.y), step<T>(to.z, from.z)};
}

template <class T>
CenterParts<T, 2> center_parts(const SpannedCircle2& circle) {
  const auto& [a, p, q] = circle.points;
  const auto b = step<T>(p, a), c = step<T>(q, a);
  const T b2 = b.x * b.x + b.y * b.y, c2 = c.x * c.x + c.y * c.y, w = b.x * c.y - b.y * c.x;
  return {{b2 * c.y - c2 * b.y, c2 * b.x - b2 * c.x}, w + w};
}

template <class T>
CenterParts<T, 3> center_parts(const SpannedSphere3& sphere) {
  using arith::cross, arith::dot;
  const auto from_first = [&](std::size_t i) { return step<T>(sphere.points[i], sphere.points[0]); };
  const auto b = from_first(1), c = from_first(2), n = cross(b, c);
  const T b2 = dot(b, b), c2 = dot(c, c);
  const auto parts = [](const arith::Vec<T>& offset, const T& w) {
    return CenterParts<T, 3>{{offset.x, offset.y, offset.z}, w + w};
  };
  if (sphere.count == 3) return parts(cross(n, b) * c2 + cross(c, n) * b2, dot(n, n));
  const auto d = from_first(3);
  return parts(n * dot(d, d) + cross(d, b) * c2 + cross(c, d) * b2, dot(d, n));
}

/// Of three points or four, three in the plane.
template <class Spanned>
auto near_center(const Spanned& ball) {
  const auto parts = center_parts<Ball>(ball);
  const auto first = coordinates(ball.points[0]);
  return [&]<std::size_t... A>(std::index_sequence<A...>) {
    return std::array{Ball{first[A]} + quotient(parts.offset[A], parts.weight)...};
  }
  (std::make_index_sequence<first.size()>());
}

template <std::size_t axes>
using Quick = std::array<std::optional<double>, axes>;

/// The center's coordinates, where twice the digits of a double tell the nearest one.
template <class Two, class Spanned>
[[gnu::always_inline]] inline auto quick_center_in(const Spanned& ball) {
  const auto parts = center_parts<Two>(ball);
  const auto first = coordinates(ball.points[0]);
  Quick<first.size()> center;
  for (std::size_t k = 0; k < first.size(); ++k)
    center[k] = (first[k] + quotient(parts.offset[k], parts.weight)).nearest();
  return center;
}
PLUMB_WITH_FMA Quick<2> quick_center_fused(const SpannedCircle2& ball) { return quick_center_in<Twofold<true>>(ball); }
PLUMB_WITH_FMA Quick<3> quick_center_fused(const SpannedSphere3& ball) { return quick_center_in<Twofold<true>>(ball); }
PLUMB_WITHOUT Quick<2> quick_center(const SpannedCircle2& ball) { return quick_center_in<Twofold<false>>(ball); }
PLUMB_WITHOUT Quick<3> quick_center(const SpannedSphere3& ball) { return quick_center_in<Twofold<false>>(ball); }

template <class Spanned>
auto rounded_center(const Spanned& ball) {
  const auto quick = has_fma ? quick_center_fused(ball) : quick_center(ball);
  auto center = coordinates(ball.points[0]);
  std::optional<decltype(near_center(ball))> near;
  std::optional<decltype(center_parts<BigDyadic>(ball))> exact;
  for (std::size_t k = 0; k < center.size(); ++k) {
    if (quick[k]) {
      center[k] = *quick[k];
      continue;
    }
    if (!near) near = near_center(ball);
    if (const std::optional<double> nearest = (*near)[k].nearest()) {
      center[k] = *nearest;
      continue;
    }
    if (!exact) exact = center_parts<BigDyadic>(ball);
    const BigDyadic sum = BigDyadic(center[k]) * exact->weight + exact->offset[k];
    center[k] = rounded_quotient(Rounding::nearest, sum, exact->weight);
  }
  return center;
}

template <class Number>
struct Fraction {
  Number numerator, denominator;
};

/// The squared radius, over the numbers that make(double) gives.
template <class Ball, class Make>
auto squared_radius(const Ball& ball, Make make) {
  using Number = decltype(make(1.0));
  constexpr auto axes = static_cast<std::size_t>(dimension<Ball>);
  std::vector<std::array<Number, axes>> e;  // edges from the first point
  for (std::size_t i = 1; i < static_cast<std::size_t>(ball.count); ++i) {
    const auto from = coordinates(ball.points[0]), to = coordinates(ball.points[i]);
    e.push_back([&]<std::size_t... A>(std::index_sequence<A...>) {
      return std::array<Number, axes>{make(to[A]) - make(from[A])...};
    }(std::make_index_sequence<axes>()));
  }
  const auto dot_of = [](const auto& u, const auto& v) {
    Number sum = u[0] * v[0];
    for (std::size_t a = 1; a < axes; ++a) sum = sum + u[a] * v[a];
    return sum;
  };
  const auto cross_of = [](const auto& u, const auto& v) {
    return std::array<Number, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const Number four = make(4.0);
  if (e.empty()) return Fraction<Number>{make(0.0), four};
  const Number b2 = dot_of(e[0], e[0]);
  if (e.size() == 1) return Fraction<Number>{b2, four};
  const Number c2 = dot_of(e[1], e[1]);
  if (e.size() == 2) {  // the product of the three sides' squares over 16 times that of the area
    const Number bc = dot_of(e[0], e[1]);
    return Fraction<Number>{b2 * c2 * (b2 + c2 - bc - bc), four * (b2 * c2 - bc * bc)};
  }
  if constexpr (axes == 3) {
    const auto bc = cross_of(e[0], e[1]), db = cross_of(e[2], e[0]), cd = cross_of(e[1], e[2]);
    const Number d2 = dot_of(e[2], e[2]);
    const auto offset = [&](std::size_t a) { return d2 * bc[a] + c2 * db[a] + b2 * cd[a]; };
    const std::array<Number, 3> n{offset(0), offset(1), offset(2)};
    const Number w = dot_of(e[0], cd);
    return Fraction<Number>{dot_of(n, n), four * w * w};
  } else {
    return Fraction<Number>{b2, four};  // not reached: a circle has three points at the most
  }
}

template <class Ball>
void require_spanned(const Ball& ball) {
  const auto& p = ball.points;
  bool spanned = ball.count >= 1 && ball.count <= dimension<Ball> + 1;
  const auto count = static_cast<std::size_t>(spanned ? ball.count : 0);
  figure::require_finite_points<PointOf<Ball>>("spanned ball", "points", std::span(p).first(count));
  if (spanned && ball.count == 2) spanned = !(p[0] == p[1]);
  if constexpr (dimension<Ball> == 2) {
    if (spanned && ball.count == 3) spanned = sign_of(predicates::Orient2d{}, p[0], p[1], p[2]) != Sign::zero;
  } else {
    if (spanned && ball.count == 3) spanned = !collinear(p[0], p[1], p[2]);
    if (spanned && ball.count == 4) spanned = sign_of(predicates::Orient3d{}, p[0], p[1], p[2], p[3]) != Sign::zero;
  }
  if (!spanned)
    throw InvalidShape(
        std::string("spanned ball: its ")
            .append(std::to_string(ball.count))
            .append(" points span none; give points that are not equal, collinear or coplanar for their number"));
}

template <class Ball>
double rounded_radius(Rounding rounding, const Ball& ball) {
  require_spanned(ball);
  const auto exact = squared_radius(ball, [](double x) { return BigDyadic(x); });
  return rounded_root(rounding, exact.numerator, exact.denominator);
}

/// Their squares compared.
template <class A, class B>
Sign compared(const A& a, const B& b) {
  return sign_in<SignWorlds<Interval, BigDyadic>>([&]<class T>() {
    const auto make = [](double x) { return T(x); };
    const auto x = a(make), y = b(make);
    return x.numerator * y.denominator - y.numerator * x.denominator;
  });
}

template <class Ball>
auto square_of(const Ball& ball) {
  require_spanned(ball);
  return [&ball](auto make) { return squared_radius(ball, make); };
}

template <class Ball>
Sign compared_with_number(const Ball& ball, double r) {
  const auto square = square_of(ball);
  require_finite_parts("compare_radius", {"radius"}, r);
  if (r < 0) return Sign::positive;
  return compared(square, [r](auto make) {
    const auto x = make(r);
    return Fraction<decltype(make(r))>{x * x, make(1.0)};
  });
}

template <class Ball, class Point>
Location located(const Ball& ball, const Point& p) {
  require_spanned(ball);
  require_finite_parts("locate", {"p"}, p);
  return static_cast<Location>(side(ball, p));
}

template <class Spanned>
FineBall<Spanned> with_square(FineBall<Spanned> fine, const Spanned& ball) {
  fine.square = fine.square_of_distance(ball.points[0]);
  return fine;
}

/// Of one point or two.
template <class Spanned, std::size_t... A>
FineBall<Spanned> fine_middle(const Spanned& ball, std::index_sequence<A...>) {
  const auto a = coordinates(ball.points[0]), b = coordinates(ball.points[ball.count == 1 ? 0 : 1]);
  return with_square({{(Ball{a[A]} + Ball{b[A]}) * Ball{0.5}...}, Ball{0}}, ball);
}

}  // namespace

FineBall<SpannedCircle2> fine_ball(const SpannedCircle2& ball) {
  if (ball.count <= 2) return fine_middle(ball, std::make_index_sequence<2>());
  return with_square({near_center(ball), Ball{0}}, ball);
}
FineBall<SpannedSphere3> fine_ball(const SpannedSphere3& ball) {
  if (ball.count <= 2) return fine_middle(ball, std::make_index_sequence<3>());
  return with_square({near_center(ball), Ball{0}}, ball);
}

Point2 center_of(const SpannedCircle2& ball) {
  const auto& [a, b, c] = ball.points;
  if (ball.count == 1) return {a.x + 0.0, a.y + 0.0};
  if (ball.count == 2) return {std::midpoint(a.x, b.x) + 0.0, std::midpoint(a.y, b.y) + 0.0};
  const auto [x, y] = rounded_center(ball);
  return {x, y};
}

Point3 center_of(const SpannedSphere3& ball) {
  const auto& [a, b, c, d] = ball.points;
  if (ball.count == 1) return {a.x + 0.0, a.y + 0.0, a.z + 0.0};
  if (ball.count == 2)
    return {std::midpoint(a.x, b.x) + 0.0, std::midpoint(a.y, b.y) + 0.0, std::midpoint(a.z, b.z) + 0.0};
  const auto [x, y, z] = rounded_center(ball);
  return {x, y, z};
}

}  // namespace figure::sphere

Location locate(const SpannedCircle2& ball, const Point2& p) { return figure::sphere::located(ball, p); }
Location locate(const SpannedSphere3& ball, const Point3& p) { return figure::sphere::located(ball, p); }

Point2 center(const SpannedCircle2& ball) {
  figure::sphere::require_spanned(ball);
  return figure::sphere::center_of(ball);
}
Point3 center(const SpannedSphere3& ball) {
  figure::sphere::require_spanned(ball);
  return figure::sphere::center_of(ball);
}

double radius(Rounding rounding, const SpannedCircle2& ball) { return figure::sphere::rounded_radius(rounding, ball); }
double radius(Rounding rounding, const SpannedSphere3& ball) { return figure::sphere::rounded_radius(rounding, ball); }

Sign compare_radius(const SpannedCircle2& a, const SpannedCircle2& b) {
  return figure::sphere::compared(figure::sphere::square_of(a), figure::sphere::square_of(b));
}
Sign compare_radius(const SpannedSphere3& a, const SpannedSphere3& b) {
  return figure::sphere::compared(figure::sphere::square_of(a), figure::sphere::square_of(b));
}
Sign compare_radius(const SpannedCircle2& a, double r) { return figure::sphere::compared_with_number(a, r); }
Sign compare_radius(const SpannedSphere3& a, double r) { return figure::sphere::compared_with_number(a, r); }

}  // namespace plumb

#include "plumb/figure/sphere/sphere.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "certify/case_line.hpp"
#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/ball_reach.hpp"
#include "figure/sphere/spanned_ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

using predicates::squared;

/// (center, center, x, y): the square of x - y against that of the distance.
struct Rest2 {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{2, 2, 1, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return squared(p[4] - p[5]) - squared(predicates::difference2(p, 0, 1));
  }
};
struct Rest3 {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 1, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return squared(p[6] - p[7]) - squared(predicates::difference(p, 0, 1));
  }
};
template <class Point>
using Rest = std::conditional_t<std::is_same_v<Point, Point2>, Rest2, Rest3>;

/// Is `reach` at least the distance and the radius together?
template <class Point>
bool reaches(const Point& from, double reach, const Point& center, double radius) {
  return reach >= radius && sign_of(Rest<Point>{}, from, center, reach, radius) != Sign::negative;
}

template <class Ball, class Point>
double reach_of(const Point& from, const Ball& ball) {
  const double distance = rounded_root(Rounding::up, SquaredDistance<Point>{}, from, ball.center);
  if (ball.radius == 0) return distance;
  double r = Interval::sum_up(distance, ball.radius);  // above the least one by an ulp or two
  if (!(r <= std::numeric_limits<double>::max())) r = std::numeric_limits<double>::max();
  if (!reaches(from, r, ball.center, ball.radius)) return std::numeric_limits<double>::infinity();
  // Ends after a step or two: r is above the least one by no more, for the distance was rounded up once and the sum
  // too.
  for (double less = r; less > 0;) {
    less = std::nextafter(r, 0.0);
    if (!reaches(from, less, ball.center, ball.radius)) break;
    r = less;
  }
  return r;
}

template <class Ball>
Sign exact_gap(std::string_view function, const Ball& a, const Ball& b) {
  figure::require_sound(function, "a", a);
  figure::require_sound(function, "b", b);
  if constexpr (std::is_same_v<Ball, Circle2>) {
    return decide<figure::sphere::Gap2>({a.center.x, a.center.y, a.radius, b.center.x, b.center.y, b.radius});
  } else {
    return decide<figure::sphere::Gap3>(
        {a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius});
  }
}

template <class Ball>
Ball times(const Ball& ball, double factor) {
  Ball to = ball;
  to.center.x *= factor, to.center.y *= factor, to.radius *= factor;
  if constexpr (requires { to.center.z; }) to.center.z *= factor;
  return to;
}

/// The center of the smallest ball around two, neither of which holds the other, as doubles guess it: on the line of the
/// centers, so that both backs are equally far.
template <class Ball>
auto center_between(const Ball& a, const Ball& b) {
  using Point = decltype(a.center);
  const double d = rounded_root(Rounding::nearest, SquaredDistance<Point>{}, a.center, b.center);
  const double way = d > 0 ? (d + (b.radius - a.radius)) / (2 * d) : 0;
  const auto at = [way](double from, double to) {
    const double x = from + way * (to - from);
    const double low = std::fmin(from, to), high = std::fmax(from, to);
    return x < low ? low : x > high ? high : x + 0.0;
  };
  Point c = a.center;
  c.x = at(a.center.x, b.center.x), c.y = at(a.center.y, b.center.y);
  if constexpr (requires { c.z; }) c.z = at(a.center.z, b.center.z);
  return c;
}

/// Whether differences, sums and doubles of these numbers may leave the doubles, where the guess is made of smaller ones.
template <class Ball>
bool is_large(const Ball& ball) {
  double most = ball.radius;
  for (const double x : coordinates(ball.center)) most = std::fmax(most, std::fabs(x));
  constexpr double large = 0x1p1000;  // a guess of where sums might overflow on the way
  return most > large;
}

template <class Ball>
Ball merged(std::string_view function, const Ball& one, const Ball& other) {
  const bool swap = comes_first(other, one);
  const Ball &a = swap ? other : one, &b = swap ? one : other;
  if (holds(a, b)) return a;
  if (holds(b, a)) return b;
  auto center = a.center;
  if (is_large(a) || is_large(b)) {
    constexpr double up = 0x1p16, down = 1 / up;  // powers of two, for the guess
    center = times(Ball{center_between(times(a, down), times(b, down)), 0}, up).center;
  } else {
    center = center_between(a, b);
  }
  const double r = std::fmax(reach_of(center, a), reach_of(center, b));
  return {center, figure::within_doubles(r, function, "radius")};
}

template <class Ball>
Ball merged(const Ball& a, const Ball& b) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  return merged("merge", a, b);
}

template <class Ball>
Ball merged(std::string_view name, const Ball& ball, const decltype(ball.center)& p) {
  figure::require_sound("merge", name, ball);
  require_finite_parts("merge", {"p"}, p);
  return merged("merge", ball, Ball{p, 0});
}

template <class Ball>
Ball merged(std::string_view name, std::span<const Ball> balls) {
  if (balls.empty()) throw InvalidShape(std::string("merge: no ").append(name).append("; give at least one"));
  for (std::size_t i = 0; i < balls.size(); ++i)
    figure::require_sound("merge", std::string(name).append("[").append(std::to_string(i)).append("]"), balls[i]);
  Ball all = balls[0];
  for (const Ball& ball : balls) all = merged("merge", all, ball);
  double r = 0;
  for (const Ball& ball : balls) r = std::fmax(r, reach_of(all.center, ball));
  return {all.center, r};
}

}  // namespace

void require_ball(std::string_view function, std::string_view name, const Circle2& ball) {
  figure::require_sound(function, name, ball);
}
void require_ball(std::string_view function, std::string_view name, const Sphere3& ball) {
  figure::require_sound(function, name, ball);
}

double reach(const Point2& from, const Circle2& ball) { return reach_of(from, ball); }
double reach(const Point3& from, const Sphere3& ball) { return reach_of(from, ball); }

bool holds(const Circle2& outer, const Circle2& inner) {
  return reaches(outer.center, outer.radius, inner.center, inner.radius);
}
bool holds(const Sphere3& outer, const Sphere3& inner) {
  return reaches(outer.center, outer.radius, inner.center, inner.radius);
}

}  // namespace figure::sphere

namespace figure::sphere {

Sign gap_exactly(std::string_view function, const Circle2& a, const Circle2& b) {
  return figure::sphere::exact_gap(function, a, b);
}
Sign gap_exactly(std::string_view function, const Sphere3& a, const Sphere3& b) {
  return figure::sphere::exact_gap(function, a, b);
}

}  // namespace figure::sphere

bool contains(const Circle2& outer, const Circle2& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  return figure::sphere::holds(outer, inner);
}
bool contains(const Sphere3& outer, const Sphere3& inner) {
  figure::require_sound("contains", "outer", outer);
  figure::require_sound("contains", "inner", inner);
  return figure::sphere::holds(outer, inner);
}

Circle2 merge(const Circle2& a, const Circle2& b) { return figure::sphere::merged(a, b); }
Sphere3 merge(const Sphere3& a, const Sphere3& b) { return figure::sphere::merged(a, b); }
Circle2 merge(const Circle2& circle, const Point2& p) { return figure::sphere::merged("circle", circle, p); }
Sphere3 merge(const Sphere3& sphere, const Point3& p) { return figure::sphere::merged("sphere", sphere, p); }
Circle2 merge(std::span<const Circle2> circles) { return figure::sphere::merged("circles", circles); }
Sphere3 merge(std::span<const Sphere3> spheres) { return figure::sphere::merged("spheres", spheres); }

}  // namespace plumb

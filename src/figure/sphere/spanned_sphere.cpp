#include "plumb/figure/sphere/spanned_sphere.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "arith/big_rounding.hpp"
#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/spanned_ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

using predicates::cross, predicates::difference, predicates::difference2, predicates::dot, predicates::squared;

// Centers are a + offset / weight; the formulas give weight and a weight + offset, of the first axis alone: the other
// axes follow by turning the axes.

struct CircleWeight {
  static constexpr std::string_view name = "center";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto w = cross(difference2(p, 0, 1), difference2(p, 0, 2));
    return w + w;
  }
};
struct CircleCenter {
  static constexpr std::string_view name = "center";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto b = difference2(p, 0, 1), c = difference2(p, 0, 2);
    return p[0] * CircleWeight{}(p) + (squared(b) * c.y - squared(c) * b.y);
  }
};

struct TriangleWeight {
  static constexpr std::string_view name = "center";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    const auto w = squared(cross(difference(p, 0, 1), difference(p, 0, 2)));
    return w + w;
  }
};
struct TriangleCenter {
  static constexpr std::string_view name = "center";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    const auto b = difference(p, 0, 1), c = difference(p, 0, 2);
    const auto n = cross(b, c);
    return p[0] * TriangleWeight{}(p) + (squared(c) * (n.y * b.z - n.z * b.y) + squared(b) * (c.y * n.z - c.z * n.y));
  }
};

struct TetrahedronWeight {
  static constexpr std::string_view name = "center";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto w = predicates::triple(difference(p, 0, 1), difference(p, 0, 2), difference(p, 0, 3));
    return w + w;
  }
};
struct TetrahedronCenter {
  static constexpr std::string_view name = "center";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto b = difference(p, 0, 1), c = difference(p, 0, 2), d = difference(p, 0, 3);
    const auto x = [](const auto& u, const auto& v) { return u.y * v.z - u.z * v.y; };
    return p[0] * TetrahedronWeight{}(p) + (squared(d) * x(b, c) + squared(c) * x(d, b) + squared(b) * x(c, d));
  }
};

Point2 turned(const Point2& p) { return {p.y, -p.x}; }
Point3 turned(const Point3& p) { return {p.y, p.z, p.x}; }

template <class Center, class Weight, class Ball, std::size_t... I>
double first_axis(const Ball& ball, std::index_sequence<I...>) {
  return rounded_quotient(Rounding::nearest, Center{}, Weight{}, ball.points[I]...);
}

double first_axis(const SpannedCircle2& ball) {
  return first_axis<CircleCenter, CircleWeight>(ball, std::make_index_sequence<3>());
}
double first_axis(const SpannedSphere3& ball) {
  if (ball.count == 3) return first_axis<TriangleCenter, TriangleWeight>(ball, std::make_index_sequence<3>());
  return first_axis<TetrahedronCenter, TetrahedronWeight>(ball, std::make_index_sequence<4>());
}

template <class Center, class Weight, class Spanned, std::size_t... I>
Ball fine_first_axis(const Spanned& ball, std::index_sequence<I...>) {
  const auto p = coordinates_of<Center>(ball.points[I]...);
  return quotient(certify::rounding::ball<Center>(p), certify::rounding::ball<Weight>(p));
}

Ball fine_first_axis(const SpannedCircle2& ball) {
  return fine_first_axis<CircleCenter, CircleWeight>(ball, std::make_index_sequence<3>());
}
Ball fine_first_axis(const SpannedSphere3& ball) {
  if (ball.count == 3) return fine_first_axis<TriangleCenter, TriangleWeight>(ball, std::make_index_sequence<3>());
  return fine_first_axis<TetrahedronCenter, TetrahedronWeight>(ball, std::make_index_sequence<4>());
}

template <class Ball>
Ball turned(Ball ball) {
  for (auto& p : ball.points) p = turned(p);
  return ball;
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
  const auto difference_of = [&](auto make) {
    const auto x = a(make), y = b(make);
    return (x.numerator * y.denominator - y.numerator * x.denominator).sign();
  };
  if (const auto quick = difference_of([](double x) { return Interval(x); }); quick.certain()) return quick.value();
  return difference_of([](double x) { return BigDyadic(x); });
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
  const Ball y = fine_first_axis(turned(ball));
  return with_square({{fine_first_axis(ball), y}, Ball{0}}, ball);
}
FineBall<SpannedSphere3> fine_ball(const SpannedSphere3& ball) {
  if (ball.count <= 2) return fine_middle(ball, std::make_index_sequence<3>());
  const SpannedSphere3 second = turned(ball);
  return with_square({{fine_first_axis(ball), fine_first_axis(second), fine_first_axis(turned(second))}, Ball{0}},
                     ball);
}

Point2 center_of(const SpannedCircle2& ball) {
  const auto& [a, b, c] = ball.points;
  if (ball.count == 1) return {a.x + 0.0, a.y + 0.0};
  if (ball.count == 2) return {std::midpoint(a.x, b.x) + 0.0, std::midpoint(a.y, b.y) + 0.0};
  return {first_axis(ball), first_axis(turned(ball))};
}

Point3 center_of(const SpannedSphere3& ball) {
  const auto& [a, b, c, d] = ball.points;
  if (ball.count == 1) return {a.x + 0.0, a.y + 0.0, a.z + 0.0};
  if (ball.count == 2)
    return {std::midpoint(a.x, b.x) + 0.0, std::midpoint(a.y, b.y) + 0.0, std::midpoint(a.z, b.z) + 0.0};
  const SpannedSphere3 second = turned(ball);
  return {first_axis(ball), first_axis(second), first_axis(turned(second))};
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

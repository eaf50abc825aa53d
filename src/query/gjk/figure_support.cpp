#include "plumb/query/gjk/figure_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "arith/big_rounding.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {
namespace {

/// x times two to the e.
BigDyadic scaled(BigDyadic x, long e) {
  while (e != 0) {
    const long part = std::clamp(e, -1000L, 1000L);
    x = x * BigDyadic(std::ldexp(1.0, static_cast<int>(part)));
    e -= part;
  }
  return x;
}

/// The power of two that is above it, of x other than zero.
long power_above(const BigDyadic& x) {
  return static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2)) + x.exponent();
}

Interval magnitude(const Interval& x) { return Interval(std::max(std::fabs(x.lower), std::fabs(x.upper))); }
Interval magnitudes(const Vec3<Interval>& v) { return magnitude(v.x) + magnitude(v.y) + magnitude(v.z); }
/// The length of what has three coordinates up to this.
Interval diagonal(const Interval& side) { return side * root(Interval(3.0)); }
/// What rounding to nearest moves a number up to this.
Interval moved_by_rounding(double largest) {
  constexpr double last = std::numeric_limits<double>::max();  // as far apart as the doubles around it are those below
  const double below = largest < last ? largest : std::nextafter(last, 0);
  return (Interval(std::nextafter(below, HUGE_VAL)) - Interval(below)) * Interval(0.5);
}

/// f of what tells farthest points of the figure.
template <class F>
auto with_support(const AnyFigure& figure, const F& f) {
  using Answer = decltype(f(FigureSupport3<Sphere3>(Sphere3{})));
  return visit(
      [&]<class Shape>(const Shape& s) -> Answer {
        if constexpr (figure_dimension<Shape> == 3 && SupportedFigure3<Shape>) {
          return std::visit(
              [&]<class By>(const By& pose) -> Answer {
                if constexpr (PoseOfSpace<By>) {
                  return f(ImageSupport3<Shape>(s, pose));
                } else {
                  return f(FigureSupport3<Shape>(s));
                }
              },
              figure.pose());
        }
        refuse_figure("what takes farthest points", figure.figure());
      },
      figure);
}

}  // namespace

Vector3 direction_before(PoseView pose, const Vector3& direction) {
  const Vec3<BigDyadic> n = vector_of<BigDyadic>(direction);
  const auto numbers = figure::pose_numbers<BigDyadic>(pose);
  std::array<BigDyadic, 3> along;
  for (std::size_t k = 0; k < 3; ++k) along[k] = dot(numbers.columns[k], n);
  std::optional<long> above;
  for (const BigDyadic& x : along) {
    if (x.sign() != Sign::zero) above = above ? std::max(*above, power_above(x)) : power_above(x);
  }
  if (!above) return {0, 0, 0};
  const auto part = [&](std::size_t k) { return rounded(Rounding::nearest, scaled(along[k], -*above)); };
  return {part(0), part(1), part(2)};
}

double rounding_of_point(double largest) { return diagonal(moved_by_rounding(largest)).upper; }

double rounding_of_image(PoseView pose, double largest, double off) {
  figure::require_sound("support_point", pose);
  const auto [columns, translation, weight] = figure::pose_numbers<Interval>(pose);
  // What stretches most: no coordinate of an image is larger than this times that of the point.
  const Interval stretch = quotient(magnitudes(columns[0]) + magnitudes(columns[1]) + magnitudes(columns[2]), weight);
  const Interval reach = Interval(largest) + Interval(off);
  const double size = (stretch * reach + quotient(magnitudes(translation), weight)).upper;
  const Interval moved = diagonal(moved_by_rounding(size));
  // The farthest point is told along a rounded direction, whose largest coordinate is in [1/2, 1]: along the exact one
  // another point can be farther by what the directions differ times how far both points are apart.
  constexpr double least_of_direction = 0.5, most_of_direction = 1;
  const Interval turn = quotient(diagonal(moved_by_rounding(most_of_direction)), Interval(least_of_direction));
  const Interval across = Interval(2.0) * diagonal(reach);
  const double most = (stretch * (Interval(off) + (across + Interval(off)) * turn) + moved).upper;
  if (!figure::is_real(most) || !figure::is_real(size))
    throw BeyondDoubles("support_point: the image of a figure under its pose is beyond all doubles");
  return most;
}

}  // namespace plumb::query

namespace plumb {

Point3 FigureSupport3<AnyFigure>::operator()(const Vector3& direction) const {
  return query::with_support(*figure_, [&](const auto& support) { return support(direction); });
}
double FigureSupport3<AnyFigure>::rounding() const {
  return query::with_support(*figure_, [](const auto& support) { return support.rounding(); });
}

}  // namespace plumb

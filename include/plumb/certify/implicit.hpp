// Indirect predicates: on which side, and inside or outside, when points are constructed or posed?  The classic signs
// for any mix of kinds.
//
// Each function takes points as given (Point2 or Point3) beside implicit ones (arith/implicit_point.hpp) and posed ones
// (arith/pose.hpp), in any order.
// Laws: (1) the sign is that of the exact points: swapping flips it, an even permutation keeps it, and a point that
// equals another may stand for it.  (2) A common pose multiplies the sign of an orientation by that of the matrix's
// determinant.  (3) Two points are equal exactly when they compare as zero.
// A construction without a point (parallel lines and the like) throws DegeneratePoint, a number that is NaN or infinite
// NonFinite; both name the argument.
// Source: RTCD 3.1.6, 5.1.9.1, 5.3.1, 5.4.5; docs/implicit_points.md.
// Cost: a filter of 10 to 500 ns where it is sure, microseconds where it is not.
#pragma once

#include "plumb/arith/implicit_point.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/detail/mixed.hpp"
#include "plumb/certify/detail/point_kind.hpp"

namespace plumb {
namespace certify::mixed {

/// What a failure is told by.
struct Question {
  std::string_view predicate;
  std::span<const std::span<const PointPart>> arguments;
  std::span<const double> numbers;  // of all arguments
};

/// Throws NonFinite for the first number that is none: "orient2d: b.c.x is nan, not a real number; give ...".
void require_finite(const Question& question);

/// Says why the argument has no point; for a weight that is zero.
[[noreturn]] void throw_degenerate(std::string_view predicate, char argument, const LineLinePoint2& point);
[[noreturn]] void throw_degenerate(std::string_view predicate, char argument, const LinePlanePoint3& point);
[[noreturn]] void throw_degenerate(std::string_view predicate, char argument, const ThreePlanePoint3& point);

template <Formula F>
[[gnu::noinline]] Sign exact_sign(const Coordinates<F>& p, const Question& question) {
  require_finite(question);
  return decide_exactly<F>(p).sign;
}

template <Formula F>
PLUMB_CHECKABLE Sign sign(const Coordinates<F>& p, const Question& question) {
  assert_sound_thread();
  if (const int s = filter<F>(p); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return exact_sign<F>(p, question);
}

/// The sign of the point's weight, which is not zero.
template <class Point>
Sign weight_sign(const Point& point, std::size_t argument, const Question& question) {
  if constexpr (predicates::has_weight<KindOf<Point>>) {
    const Sign s = sign<Weight<KindOf<Point>>>(coordinates(point), question);
    if (s == Sign::zero) throw_degenerate(question.predicate, static_cast<char>('a' + argument), point);
    return s;
  } else {
    return Sign::positive;
  }
}

template <class... Points>
inline constexpr std::array parts_of{std::span<const PointPart>(PointTraits<Points>::parts)...};

/// The signs of the predicates in turn, until one is not zero.
template <class... Predicates, class... Points>
Sign first_sign(const Points&... points) {
  std::array<double, (static_cast<std::size_t>(KindOf<Points>::numbers) + ...)> numbers;
  double* to = numbers.data();
  const auto append = [&to](const auto& coordinates) {
    for (const double x : coordinates) *to++ = x;
  };
  (append(coordinates(points)), ...);
  std::string_view name;
  ((name = Predicates::name), ...);
  const Question question{name, parts_of<Points...>, numbers};
  // Degenerate constructions are found first: a polynomial may well have a sign where a weight is zero.
  Sign weights = Sign::positive;
  std::size_t argument = 0;
  ((weights = weights * weight_sign(points, argument++, question)), ...);
  Sign result = Sign::zero;
  const auto ask = [&]<class Predicate>() {
    const Sign s = sign<Mixed<Predicate, KindOf<Points>...>>(numbers, question);
    result = Predicate::weights_are_squared ? s : s * weights;
    return result != Sign::zero;
  };
  [[maybe_unused]] const bool decided = (ask.template operator()<Predicates>() || ...);
  return result;
}

}  // namespace certify::mixed

/// Positive when a, b, c turn counterclockwise; zero when collinear.
template <AnyPoint2 A, AnyPoint2 B, AnyPoint2 C>
requires SomeImplicit<A, B, C> Sign orient2d(const A& a, const B& b, const C& c) {
  return certify::mixed::first_sign<predicates::HomogeneousOrient2d>(a, b, c);
}

/// Positive when d lies below the plane of a, b, c, where 'above' sees them counterclockwise; zero when coplanar.
template <AnyPoint3 A, AnyPoint3 B, AnyPoint3 C, AnyPoint3 D>
requires SomeImplicit<A, B, C, D> Sign orient3d(const A& a, const B& b, const C& c, const D& d) {
  return certify::mixed::first_sign<predicates::HomogeneousOrient3d>(a, b, c, d);
}

/// For counterclockwise a, b, c positive when d is inside their circle; zero when cocircular (or all collinear).
template <AnyPoint2 A, AnyPoint2 B, AnyPoint2 C, AnyPoint2 D>
requires SomeImplicit<A, B, C, D> Sign incircle(const A& a, const B& b, const C& c, const D& d) {
  return certify::mixed::first_sign<predicates::HomogeneousInCircle>(a, b, c, d);
}

/// For orient3d(a, b, c, d) > 0 positive when e is inside their sphere; zero when cospherical (or all coplanar).
template <AnyPoint3 A, AnyPoint3 B, AnyPoint3 C, AnyPoint3 D, AnyPoint3 E>
requires SomeImplicit<A, B, C, D, E> Sign insphere(const A& a, const B& b, const C& c, const D& d, const E& e) {
  return certify::mixed::first_sign<predicates::HomogeneousInSphere>(a, b, c, d, e);
}

/// Lexicographic order: negative when a comes before b by x, or by y where the x are equal; zero when a equals b.
template <AnyPoint2 A, AnyPoint2 B>
Sign compare_xy(const A& a, const B& b) {
  return certify::mixed::first_sign<predicates::HomogeneousOrder<0>, predicates::HomogeneousOrder<1>>(a, b);
}

/// The same by x, y and z.
template <AnyPoint3 A, AnyPoint3 B>
Sign compare_xyz(const A& a, const B& b) {
  return certify::mixed::first_sign<predicates::HomogeneousOrder<0>, predicates::HomogeneousOrder<1>,
                                    predicates::HomogeneousOrder<2>>(a, b);
}

}  // namespace plumb

// Signs at exact points: by the doubles that they keep, by pairs of doubles, by the integers that they keep.
#include "plumb/certify/exact_point.hpp"

#include <cmath>
#include <string>

#include "arith/approximate.hpp"
#include "arith/big_rounding.hpp"
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "certify/exact_place.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/detail/exact_incircle.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace certify {

template const ExactPlace<2>* shared(const ExactPlace<2>*);
template const ExactPlace<3>* shared(const ExactPlace<3>*);
template void release(const ExactPlace<2>*);
template void release(const ExactPlace<3>*);

namespace {

using certify::meeting::Weighted, predicates::Located, predicates::TagOne, predicates::TagZero;

template <class Point>
concept RationalPoint = std::same_as<Point, RationalPoint2> || std::same_as<Point, RationalPoint3>;
template <class Point>
concept GivenPoint = std::same_as<Point, Point2> || std::same_as<Point, Point3>;

// A question and which of its arguments a failure is about.
struct Asker {
  const char* question;
  char argument;
};

template <class Point>
auto nearest_doubles(Asker asker, const Point& p) {
  if constexpr (GivenPoint<Point>) {
    const std::array<std::string_view, 1> names{std::string_view(&asker.argument, 1)};
    const auto numbers = coordinates(p);
    throw_non_finite(asker.question, std::array{static_cast<int>(numbers.size())}, numbers, "xyz", names);
    return NearestDoubles<KindOf<Point>::dimension>{};
  } else if constexpr (RationalPoint<Point>) {
    const auto x = certify::meeting::parts(p);
    NearestDoubles<x.size()> result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result.at[i] = x[i]->rounded();
      result.is_exact[i] = !std::isinf(result.at[i]) && Rational(result.at[i]) == *x[i];
    }
    return result;
  } else {
    return plumb::nearest_doubles(asker.question, asker.argument, p);
  }
}

/// Fills the cache with doubles; throws where there is no point.
template <class Point>
void settle(Asker asker, const Point& point) {
  if (point.cache().is_known()) return;
  const auto found = std::visit([&](const auto& p) { return nearest_doubles(asker, p); }, point.as());
  point.cache().keep(found.at, found.is_exact);
}
template <class... Points>
void settle_all(const char* question, const Points&... points) {
  char argument = 'a';
  (settle({question, argument++}, points), ...);
}

/// Of a point that is settled.
template <std::size_t N>
const Weighted<BigDyadic, N>& place_of(const ExactPointCache<N>& cache, const auto& point) {
  if (const auto* known = cache.place(); known != nullptr) return known->point;
  const auto in_integers = [](const auto& p) {
    auto found = certify::meeting::weighted<BigDyadic>(p);
    if constexpr (RationalPoint<std::remove_cvref_t<decltype(p)>>) return found;  // they have no common factor
    return primitive(found);
  };
  return cache.keep(new ExactPlace<N>(std::visit(in_integers, point.as()))).point;
}

template <class T, std::size_t N>
auto located(const std::array<T, N>& at) {
  return Located{at, std::array<TagZero, N>{}, TagOne{}};
}

/// What rounds to x is no farther from it than a product that does.
template <std::size_t N>
auto in_doubles(const ExactPointCache<N>& cache) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return located(std::array{Running(cache.nearest(I)) * Running(1.0)...});
  }
  (std::make_index_sequence<N>{});
}

/// A rational number and what the second of two doubles leaves of it, rounded up.
Ball ball(const Rational& x) {
  const double high = x.rounded();
  if (std::isinf(high)) return {high, 0, Ball::infinity};
  const Rational rest = x - Rational(high);
  const double low = rest.rounded();
  const Rational off = rest - Rational(low);
  return {high, low, (off.sign() == Sign::negative ? -off : off).rounded(Rounding::up)};
}

template <class Point>
auto balls_of(const Point& point) {
  const auto balls = [](const auto& p) {
    using P = std::remove_cvref_t<decltype(p)>;
    if constexpr (GivenPoint<P>) {
      return std::apply([](auto... x) { return std::array{Ball(x)...}; }, coordinates(p));
    } else if constexpr (RationalPoint<P>) {
      return std::apply([](const auto*... x) { return std::array{ball(*x)...}; }, certify::meeting::parts(p));
    } else {
      return coordinate_balls(p);
    }
  };
  return std::visit(balls, point.as());
}

template <class Point>
bool is_rational(const Point& point) {
  return std::visit([](const auto& p) { return RationalPoint<std::remove_cvref_t<decltype(p)>>; }, point.as());
}

/// Looks which coordinates of a settled point are doubles.
template <std::size_t N, class Point>
void settle_axes(const Point& point) {
  const auto& cache = point.cache();
  if (cache.place() != nullptr || cache.are_axes_settled()) return;
  std::array<bool, N> exact;
  const auto is_nearest = [&](std::size_t i, const Rational& x) {
    return std::isfinite(cache.nearest(i)) && x == Rational(cache.nearest(i));
  };
  const auto look = [&](const auto& p) {
    if constexpr (RationalPoint<std::remove_cvref_t<decltype(p)>>) {
      std::size_t i = 0;
      std::apply([&](const auto*... x) { ((exact[i] = is_nearest(i, *x), ++i), ...); }, certify::meeting::parts(p));
    } else {
      const std::array<Ball, N> balls = balls_of(point);
      for (std::size_t i = 0; i < N; ++i) exact[i] = balls[i].radius == 0 && balls[i].low == 0;
    }
  };
  std::visit(look, point.as());
  cache.keep_exact(exact);
}

/// In proportion; of a point as given its coordinates, for which no place is made and kept.
template <std::size_t N, class Point>
auto in_integers(const Point& point) {
  using Place = Weighted<BigDyadic, N>;
  const auto located_at = [](const Place& p) { return Located{std::array<TagZero, N>{}, p.at, p.weight}; };
  using Given = std::conditional_t<N == 2, Point2, Point3>;
  if (const auto* given = std::get_if<Given>(&point.as()))
    return located_at(certify::meeting::weighted<BigDyadic>(*given));
  return located_at(place_of(point.cache(), point));
}

/// Where doubles do not tell, or are not known.
template <std::size_t N, class Value, class... Points>
[[gnu::noinline]] Sign by_all_means(const char* question, const Value& value, const Points&... points) {
  if (!(points.cache().is_known() && ...)) {
    settle_all(question, points...);
    if (const Unsure<Sign> s = value(in_doubles(points.cache())...).sign(); s.certain()) return s.value();
  }
  // The integers of rational coordinates cost no more than their balls, and they are kept.
  if (!((points.cache().place() != nullptr) && ...) && !(is_rational(points) || ...)) {
    CertainSigns ask;
    const Sign s = ask(value(located(balls_of(points))...));
    if (ask.certain()) return s;
  }
  return value(in_integers<N>(points)...).sign();
}

template <std::size_t N, class Value, class... Points>
Sign sign_at(const char* question, const Value& value, const Points&... points) {
  if (const Unsure<Sign> s = value(in_doubles(points.cache())...).sign(); s.certain()) [[likely]]
    return s.value();
  return by_all_means<N>(question, value, points...);
}

template <std::size_t N, class Point>
Sign exact_order(const char* question, const Point& a, const Point& b) {
  settle_all(question, a, b);
  if (const Unsure<Sign> s = order_by_doubles(a.cache(), b.cache()); s.certain()) return s.value();
  if (a.as() == b.as()) return Sign::zero;
  settle_axes<N>(a);
  settle_axes<N>(b);
  if (const Unsure<Sign> s = order_by_doubles(a.cache(), b.cache()); s.certain()) return s.value();
  const Weighted<BigDyadic, N>&p = place_of(a.cache(), a), &q = place_of(b.cache(), b);
  if (are_equal(p, q)) return Sign::zero;
  Sign s = Sign::zero;
  for (std::size_t axis = 0; axis < N && s == Sign::zero; ++axis)
    s = (p.at[axis] * q.weight - q.at[axis] * p.weight).sign();
  return s;
}

template <std::size_t N, class Point>
auto approximate(const Point& a) {
  settle({"approximate", 'a'}, a);
  std::array<double, N> at;
  for (std::size_t axis = 0; axis < N; ++axis) {
    at[axis] = a.cache().nearest(axis);
    if (std::isinf(at[axis]))
      throw BeyondDoubles(
          std::string("approximate: a.").append(1, "xyz"[axis]).append(" is beyond the largest double"));
  }
  return at;
}

template <std::size_t N, class Point>
auto rational_of(const Point& a) {
  using Rationals = decltype(certify::meeting::rational(place_of(a.cache(), a)));
  if (const auto* held = std::get_if<Rationals>(&a.as())) return *held;
  settle({"rational_point", 'a'}, a);
  using Given = std::conditional_t<N == 2, Point2, Point3>;
  if (const auto* given = std::get_if<Given>(&a.as()))
    return std::apply([](auto... x) { return Rationals{Rational(x)...}; }, coordinates(*given));
  return certify::meeting::rational(place_of(a.cache(), a));
}

template <std::size_t N, class Point>
std::size_t hash_of(const Point& a) {
  settle({"hash_value", 'a'}, a);
  std::size_t hash = 0;
  for (std::size_t axis = 0; axis < N; ++axis)
    hash = (hash << 5 | hash >> (sizeof(hash) * 8 - 5)) ^ std::hash<double>{}(a.cache().nearest(axis) + 0.0);
  return hash;
}

/// The points seen along an axis.
template <std::size_t Right, std::size_t Up, class Base, class Offset, class Weight>
auto seen(const Located<Base, Offset, Weight, 3>& p) {
  return Located{std::array{p.base[Right], p.base[Up]}, std::array{p.offset[Right], p.offset[Up]}, p.weight};
}
template <std::size_t Right, std::size_t Up>
Sign turn_of_shadows(const char* question, const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  const auto turn = [](const auto& p, const auto& q, const auto& r) {
    return predicates::HomogeneousOrient2d{}(seen<Right, Up>(p), seen<Right, Up>(q), seen<Right, Up>(r));
  };
  return sign_at<3>(question, turn, a, b, c);
}

}  // namespace

Sign exact_order(const ExactPoint2& a, const ExactPoint2& b) { return exact_order<2>("compare_xy", a, b); }
Sign exact_order(const ExactPoint3& a, const ExactPoint3& b) { return exact_order<3>("compare_xyz", a, b); }

Sign turn_along(int axis, const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  return axis == 2   ? turn_of_shadows<0, 1>("turn_along", a, b, c)
         : axis == 0 ? turn_of_shadows<1, 2>("turn_along", a, b, c)
                     : turn_of_shadows<2, 0>("turn_along", a, b, c);
}

}  // namespace certify

Point2 approximate(const ExactPoint2& a) {
  const auto [x, y] = certify::approximate<2>(a);
  return {x, y};
}
Point3 approximate(const ExactPoint3& a) {
  const auto [x, y, z] = certify::approximate<3>(a);
  return {x, y, z};
}

RationalPoint2 rational_point(const ExactPoint2& a) { return certify::rational_of<2>(a); }
RationalPoint3 rational_point(const ExactPoint3& a) { return certify::rational_of<3>(a); }

std::size_t hash_value(const ExactPoint2& a) { return certify::hash_of<2>(a); }
std::size_t hash_value(const ExactPoint3& a) { return certify::hash_of<3>(a); }

Sign orient2d(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c) {
  return certify::sign_at<2>("orient2d", predicates::HomogeneousOrient2d{}, a, b, c);
}

Sign incircle(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c, const ExactPoint2& d) {
  return certify::sign_at<2>("incircle", predicates::HomogeneousInCircle{}, a, b, c, d);
}

Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d) {
  return certify::sign_at<3>("orient3d", predicates::HomogeneousOrient3d{}, a, b, c, d);
}

bool collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  return certify::turn_of_shadows<0, 1>("collinear", a, b, c) == Sign::zero &&
         certify::turn_of_shadows<1, 2>("collinear", a, b, c) == Sign::zero &&
         certify::turn_of_shadows<2, 0>("collinear", a, b, c) == Sign::zero;
}

}  // namespace plumb

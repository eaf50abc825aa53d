// Rounds constructed points: by pairs of doubles where they leave one nearest double only, else by integers.
#include "plumb/certify/constructed.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "arith/big_rounding.hpp"
#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/implicit.hpp"

namespace plumb {
namespace {

template <class Point>
constexpr std::span<const PointPart> parts{PointTraits<Point>::parts};

template <class Point>
constexpr auto dimension = static_cast<std::size_t>(KindOf<Point>::dimension);

/// Cold: where the quick way leaves a choice.
template <class Point>
[[gnu::noinline]] double exact_coordinate(std::string_view question, char argument, const Point& point,
                                          std::size_t axis) {
  const auto numbers = coordinates(point);
  std::array<std::span<const PointPart>, 4> arguments{};  // those before have no part in it
  const auto place = static_cast<std::size_t>(argument - 'a');
  arguments[place] = parts<Point>;
  certify::mixed::require_finite({question, std::span(arguments).first(place + 1), numbers});
  const auto h = homogeneous(point, [](double x) { return BigDyadic(x); });
  if constexpr (predicates::has_weight<KindOf<Point>>) {
    if (h.weight.sign() == Sign::zero) certify::mixed::throw_degenerate(question, argument, point);
  }
  return rounded_quotient(Rounding::nearest, h.coordinate[axis], h.weight);
}

template <class Point>
std::array<Ball, dimension<Point>> balls(const Point& point) {
  using Kind = KindOf<Point>;
  const auto numbers = coordinates(point);
  const auto p = [&]<std::size_t... I>(std::index_sequence<I...>) {
    const std::array<Ball, numbers.size()> all{Ball{numbers[I]}...};
    return Kind::at(all.data());
  }
  (std::make_index_sequence<numbers.size()>{});
  const auto coordinate = [&](std::size_t axis) {
    if constexpr (predicates::has_weight<Kind>) {
      return p.base[axis] + quotient(p.offset[axis], p.weight);
    } else {
      return p.base[axis] + p.offset[axis];
    }
  };
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return std::array{coordinate(I)...}; }
  (std::make_index_sequence<dimension<Point>>{});
}

/// Of points that share a coordinate: that.
template <class... Points>
std::optional<double> common(std::size_t axis, const Points&... points) {
  const std::array all{coordinates(points)[axis]...};
  for (const double x : all) {
    if (x != all[0]) return {};
  }
  return all[0];
}

/// The coordinate of a line or plane across the axis that the point lies on.
std::optional<double> shared_coordinate(const LineLinePoint2& p, std::size_t axis) {
  const auto x = common(axis, p.a, p.b);
  return x ? x : common(axis, p.c, p.d);
}
std::optional<double> shared_coordinate(const LinePlanePoint3& p, std::size_t axis) {
  const auto x = common(axis, p.p, p.q);
  return x ? x : common(axis, p.a, p.b, p.c);
}
std::optional<double> shared_coordinate(const ThreePlanePoint3& p, std::size_t axis) {
  for (const auto& [a, b, c] : {p.first, p.second, p.third}) {
    if (const auto x = common(axis, a, b, c)) return x;
  }
  return {};
}
template <class Point>
std::optional<double> shared_coordinate(const Point&, std::size_t) {
  return {};
}

/// A coordinate as given, for pairs of doubles: differences are exact.
template <bool Fma>
struct Given {
  double value;

  friend Twofold<Fma> operator-(Given a, Given b) { return Twofold<Fma>::difference(a.value, b.value); }
  friend Twofold<Fma> operator*(Given a, const Twofold<Fma>& b) { return Twofold<Fma>(a.value) * b; }
  friend Twofold<Fma> operator*(Given a, Given b) { return a * Twofold<Fma>(b.value); }
  friend Twofold<Fma> operator+(Given a, const Twofold<Fma>& b) { return Twofold<Fma>(a.value) + b; }
};

/// False where pairs of doubles leave a choice, or nothing.
template <bool Fma, class Point>
[[gnu::always_inline]] inline bool round_quickly(const Point& point, std::array<double, dimension<Point>>& out) {
  using Kind = KindOf<Point>;
  const auto numbers = coordinates(point);
  std::array<Given<Fma>, numbers.size()> given;
  for (std::size_t i = 0; i < numbers.size(); ++i) given[i].value = numbers[i];
  const auto p = Kind::at(given.data());
  bool sure = true;
  for (std::size_t axis = 0; axis < out.size(); ++axis) {
    std::optional<double> x;
    if constexpr (predicates::has_weight<Kind>) {
      x = (p.base[axis] + quotient(p.offset[axis], p.weight)).nearest();
    } else {
      x = (p.base[axis] + p.offset[axis]).nearest();
    }
    sure = sure && x.has_value();
    out[axis] = x.value_or(0);
  }
  return sure;
}
template <class Point>
PLUMB_WITH_FMA bool with_fma(const Point& point, std::array<double, dimension<Point>>& out) {
  return round_quickly<true>(point, out);
}
template <class Point>
PLUMB_WITHOUT bool without(const Point& point, std::array<double, dimension<Point>>& out) {
  return round_quickly<false>(point, out);
}

template <class Point>
NearestDoubles<dimension<Point>> nearest_of(std::string_view question, char argument, const Point& point) {
  NearestDoubles<dimension<Point>> result{};
  if (has_fma ? with_fma(point, result.at) : without(point, result.at)) [[likely]] {
    for (std::size_t axis = 0; axis < result.at.size(); ++axis) {
      const std::optional<double> shared = shared_coordinate(point, axis);  // of a point that there is
      result.is_exact[axis] = shared.has_value();
    }
  } else {
    for (std::size_t axis = 0; axis < result.at.size(); ++axis)
      result.at[axis] = exact_coordinate(question, argument, point, axis);
  }
  return result;
}

template <class Point>
auto nearest(const Point& point) {
  const auto at = nearest_of("approximate", 'a', point).at;
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    if (std::isinf(at[axis]))
      throw BeyondDoubles(
          std::string("approximate: a.").append(1, "xyz"[axis]).append(" is beyond the largest double"));
  }
  return at;
}

template <class Point>
Point2 nearest2(const Point& p) {
  const auto [x, y] = nearest(p);
  return {x, y};
}
template <class Point>
Point3 nearest3(const Point& p) {
  const auto [x, y, z] = nearest(p);
  return {x, y, z};
}

}  // namespace

Point2 approximate(const Point2& a) {
  certify::mixed::require_finite({"approximate", {&parts<Point2>, 1}, coordinates(a)});
  return a;
}
Point2 approximate(const LineLinePoint2& a) { return nearest2(a); }
Point2 approximate(const SegmentPoint2& a) { return nearest2(a); }
Point2 approximate(const Posed<Point2, Pose2>& a) { return nearest2(a); }
Point3 approximate(const Point3& a) {
  certify::mixed::require_finite({"approximate", {&parts<Point3>, 1}, coordinates(a)});
  return a;
}
Point3 approximate(const LinePlanePoint3& a) { return nearest3(a); }
Point3 approximate(const ThreePlanePoint3& a) { return nearest3(a); }
Point3 approximate(const SegmentPoint3& a) { return nearest3(a); }
Point3 approximate(const Posed<Point3>& a) { return nearest3(a); }

NearestDoubles<2> nearest_doubles(std::string_view question, char argument, const LineLinePoint2& point) {
  return nearest_of(question, argument, point);
}
NearestDoubles<2> nearest_doubles(std::string_view question, char argument, const SegmentPoint2& point) {
  return nearest_of(question, argument, point);
}
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const LinePlanePoint3& point) {
  return nearest_of(question, argument, point);
}
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const ThreePlanePoint3& point) {
  return nearest_of(question, argument, point);
}
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const SegmentPoint3& point) {
  return nearest_of(question, argument, point);
}

std::array<Ball, 2> coordinate_balls(const LineLinePoint2& point) { return balls(point); }
std::array<Ball, 2> coordinate_balls(const SegmentPoint2& point) { return balls(point); }
std::array<Ball, 3> coordinate_balls(const LinePlanePoint3& point) { return balls(point); }
std::array<Ball, 3> coordinate_balls(const ThreePlanePoint3& point) { return balls(point); }
std::array<Ball, 3> coordinate_balls(const SegmentPoint3& point) { return balls(point); }

}  // namespace plumb

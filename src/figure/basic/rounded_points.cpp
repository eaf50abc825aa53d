#include "plumb/figure/basic/rounded_points.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error_free.hpp"

namespace plumb {
namespace {

constexpr Rounding nearest = Rounding::nearest;

/// The coordinates of both, one after the other.
template <class To, class A, class B, class Make>
To each(std::string_view function, const std::array<std::string_view, 2>& names, const A& a, const B& b, Make make) {
  require_finite_parts(function, names, a, b);
  const auto x = coordinates(a), y = coordinates(b);
  if constexpr (x.size() == 2) {
    return {make(x[0], y[0]), make(x[1], y[1])};
  } else {
    return {make(x[0], y[0]), make(x[1], y[1]), make(x[2], y[2])};
  }
}

double difference_of(double x, double y) { return (x - y) + 0.0; }
double sum_of(double x, double y) { return (x + y) + 0.0; }
/// Rounded once: a sum so small that its half is rounded is exact, and where the sum is beyond all doubles both halves
/// are doubles.
double middle_of(double x, double y) {
  const double sum = x + y;
  return (std::isfinite(sum) ? sum / 2 : x / 2 + y / 2) + 0.0;
}

template <class To, class A, class B>
To difference(const A& a, const B& b) {
  return each<To>("rounded_difference", {"a", "b"}, a, b, difference_of);
}
template <class To, class A, class B>
To sum(const A& a, const B& v) {
  return each<To>("rounded_sum", {"a", "v"}, a, v, sum_of);
}

/// By what the sum of a coordinate of a and one of b, or of its negative, loses.
template <class To, class A, class B>
std::optional<To> without_loss(std::string_view function, std::string_view second, const A& a, const B& b,
                               double sign) {
  bool exact = true;
  const To to = each<To>(function, {"a", second}, a, b, [&](double x, double y) {
    const Rounded s = two_sum(x, sign * y);
    exact = exact && std::isfinite(s.value) && s.error == 0;
    return s.value + 0.0;
  });
  return exact ? std::optional(to) : std::nullopt;
}

template <class Point>
Point lerp(const Point& a, const Point& b, double t) {
  require_finite_parts("rounded_lerp", {"a", "b", "t"}, a, b, t);
  const auto x = coordinates(a), y = coordinates(b);
  const auto at = [&](std::size_t i) {
    return rounded_value(
        nearest, [](auto p, auto q, auto s) { return p + s * (q - p); }, x[i], y[i], t);
  };
  if constexpr (x.size() == 2) {
    return {at(0), at(1)};
  } else {
    return {at(0), at(1), at(2)};
  }
}

double minor(double a, double b, double c, double d) {
  return rounded_value(
      nearest, [](auto p, auto q, auto r, auto s) { return p * s - q * r; }, a, b, c, d);
}

}  // namespace

Vector2 rounded_difference(const Point2& a, const Point2& b) { return difference<Vector2>(a, b); }
Vector3 rounded_difference(const Point3& a, const Point3& b) { return difference<Vector3>(a, b); }
Vector2 rounded_difference(const Vector2& a, const Vector2& b) { return difference<Vector2>(a, b); }
Vector3 rounded_difference(const Vector3& a, const Vector3& b) { return difference<Vector3>(a, b); }

Point2 rounded_sum(const Point2& a, const Vector2& v) { return sum<Point2>(a, v); }
Point3 rounded_sum(const Point3& a, const Vector3& v) { return sum<Point3>(a, v); }
Vector2 rounded_sum(const Vector2& a, const Vector2& v) { return sum<Vector2>(a, v); }
Vector3 rounded_sum(const Vector3& a, const Vector3& v) { return sum<Vector3>(a, v); }

std::optional<Vector2> exact_difference(const Point2& a, const Point2& b) {
  return without_loss<Vector2>("exact_difference", "b", a, b, -1);
}
std::optional<Vector3> exact_difference(const Point3& a, const Point3& b) {
  return without_loss<Vector3>("exact_difference", "b", a, b, -1);
}
std::optional<Point2> exact_sum(const Point2& a, const Vector2& v) {
  return without_loss<Point2>("exact_sum", "v", a, v, 1);
}
std::optional<Point3> exact_sum(const Point3& a, const Vector3& v) {
  return without_loss<Point3>("exact_sum", "v", a, v, 1);
}

Point2 rounded_midpoint(const Point2& a, const Point2& b) {
  return each<Point2>("rounded_midpoint", {"a", "b"}, a, b, middle_of);
}
Point3 rounded_midpoint(const Point3& a, const Point3& b) {
  return each<Point3>("rounded_midpoint", {"a", "b"}, a, b, middle_of);
}

Point2 rounded_lerp(const Point2& a, const Point2& b, double t) { return lerp(a, b, t); }
Point3 rounded_lerp(const Point3& a, const Point3& b, double t) { return lerp(a, b, t); }

Vector2 rounded_multiple(double t, const Vector2& v) {
  require_finite_parts("rounded_multiple", {"t", "v"}, t, v);
  return {t * v.x + 0.0, t * v.y + 0.0};
}
Vector3 rounded_multiple(double t, const Vector3& v) {
  require_finite_parts("rounded_multiple", {"t", "v"}, t, v);
  return {t * v.x + 0.0, t * v.y + 0.0, t * v.z + 0.0};
}

double rounded_dot(const Vector2& u, const Vector2& v) {
  require_finite_parts("rounded_dot", {"u", "v"}, u, v);
  return rounded_value(
      nearest, [](auto a, auto b, auto x, auto y) { return a * x + b * y; }, u, v);
}
double rounded_dot(const Vector3& u, const Vector3& v) {
  require_finite_parts("rounded_dot", {"u", "v"}, u, v);
  return rounded_value(
      nearest, [](auto a, auto b, auto c, auto x, auto y, auto z) { return a * x + b * y + c * z; }, u, v);
}
double rounded_cross(const Vector2& u, const Vector2& v) {
  require_finite_parts("rounded_cross", {"u", "v"}, u, v);
  return minor(u.x, u.y, v.x, v.y);
}
Vector3 rounded_cross(const Vector3& u, const Vector3& v) {
  require_finite_parts("rounded_cross", {"u", "v"}, u, v);
  return {minor(u.y, u.z, v.y, v.z), minor(u.z, u.x, v.z, v.x), minor(u.x, u.y, v.x, v.y)};
}
double rounded_triple(const Vector3& u, const Vector3& v, const Vector3& w) {
  require_finite_parts("rounded_triple", {"u", "v", "w"}, u, v, w);
  return rounded_value(
      nearest,
      [](auto a, auto b, auto c, auto d, auto e, auto f, auto g, auto h, auto i) {
        return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g);
      },
      u, v, w);
}
double rounded_length(const Vector2& v) {
  require_finite_parts("rounded_length", {"v"}, v);
  return rounded_root(
      nearest, [](auto x, auto y) { return x * x + y * y; }, v);
}
double rounded_length(const Vector3& v) {
  require_finite_parts("rounded_length", {"v"}, v);
  return rounded_root(
      nearest, [](auto x, auto y, auto z) { return x * x + y * y + z * z; }, v);
}

Vector3 rounded_normal(const Point3& a, const Point3& b, const Point3& c) {
  require_finite_parts("rounded_normal", {"a", "b", "c"}, a, b, c);
  const auto turn = [](double ax, double ay, double bx, double by, double cx, double cy) {
    return rounded_value(
        nearest,
        [](auto px, auto py, auto qx, auto qy, auto rx, auto ry) {
          return (qx - px) * (ry - py) - (qy - py) * (rx - px);
        },
        ax, ay, bx, by, cx, cy);
  };
  return {turn(a.y, a.z, b.y, b.z, c.y, c.z), turn(a.z, a.x, b.z, b.x, c.z, c.x), turn(a.x, a.y, b.x, b.y, c.x, c.y)};
}

}  // namespace plumb

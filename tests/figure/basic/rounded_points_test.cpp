// Is each number the exact one, rounded once?  Against rational numbers, on coordinates of all sizes.
#include "plumb/figure/basic/rounded_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// As a user has it who rounds as he likes.
namespace own {
Vector3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector3 operator*(double t, const Vector3& v) { return {t * v.x, t * v.y, t * v.z}; }

TEST(RoundedPoints, OperatorsOfOnesOwnAreTaken) {
  EXPECT_EQ(2 * (Point3{3, 2, 1} - Point3{1, 1, 1}), (Vector3{4, 2, 0}));
  EXPECT_TRUE((Point3{3, 2, 1} != Point3{1, 1, 1}));
}
}  // namespace own

constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max(),
                 least = std::numeric_limits<double>::denorm_min();

/// Equal, zero being +0.
void expect_rounded(double x, const Rational& exact, const std::string& about) {
  const double wanted = exact.rounded();
  EXPECT_EQ(x, wanted) << about;
  EXPECT_FALSE(x == 0 && std::signbit(x)) << about;
}

struct Drawn {
  std::array<double, 3> a, b, c;
  double t;
  std::string about;
  [[nodiscard]] static Point3 point(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }
  [[nodiscard]] static Vector3 vector(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }
};

Drawn drawn(std::uint64_t index) {
  Entropy entropy(801, index);
  std::array<double, 10> x{};
  const auto any = [&] { return static_cast<CoordinateClass>(entropy.below(coordinate_class_count)); };
  const CoordinateClass all = any();
  for (double& c : x) c = coordinate_of(entropy.below(8) == 0 ? any() : all, entropy);
  if (entropy.below(4) == 0) {  // neighbors, and sums that are beyond doubles
    x[3] = std::nextafter(x[0], infinity), x[4] = -x[1], x[7] = largest, x[8] = entropy.coin() ? largest : -least;
  }
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, x[9], "start 801 index " + std::to_string(index)};
}

TEST(RoundedPoints, AreTheExactOnesRoundedOnce) {
  int lost = 0, kept = 0, infinite = 0;
  for (std::uint64_t index = 0; index < 3000; ++index) {
    const Drawn d = drawn(index);
    if (!std::isfinite(d.b[0])) continue;
    const Point3 a = Drawn::point(d.a), b = Drawn::point(d.b), c = Drawn::point(d.c);
    const Vector3 u = Drawn::vector(d.a), v = Drawn::vector(d.b);
    const std::array<Rational, 3> p{d.a[0], d.a[1], d.a[2]}, q{d.b[0], d.b[1], d.b[2]}, r{d.c[0], d.c[1], d.c[2]};
    const auto look = [&](const auto& made, const auto& exact) {
      const std::array<double, 3> x{made.x, made.y, made.z};
      for (std::size_t k = 0; k < 3; ++k) expect_rounded(x[k], exact(k), d.about);
    };
    const auto difference = [&](std::size_t k) { return p[k] - q[k]; };
    const auto sum = [&](std::size_t k) { return p[k] + q[k]; };
    look(rounded_difference(a, b), difference);
    look(rounded_difference(u, v), difference);
    look(rounded_sum(a, v), sum);
    look(rounded_sum(u, v), sum);
    look(rounded_midpoint(a, b), [&](std::size_t k) { return (p[k] + q[k]) / 2; });
    look(rounded_lerp(a, b, d.t), [&](std::size_t k) { return p[k] + Rational(d.t) * (q[k] - p[k]); });
    look(rounded_multiple(d.t, v), [&](std::size_t k) { return Rational(d.t) * q[k]; });
    look(rounded_cross(u, v), [&](std::size_t k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      return p[i] * q[j] - p[j] * q[i];
    });
    look(rounded_normal(a, b, c), [&](std::size_t k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    });
    Rational volume;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      volume = volume + r[k] * (p[i] * q[j] - p[j] * q[i]);
    }
    expect_rounded(rounded_triple(u, v, Drawn::vector(d.c)), volume, d.about);
    expect_rounded(rounded_dot(u, v), p[0] * q[0] + p[1] * q[1] + p[2] * q[2], d.about);
    EXPECT_EQ(rounded_length(u), rounded_root(Rounding::nearest, p[0] * p[0] + p[1] * p[1] + p[2] * p[2])) << d.about;

    const auto exact = exact_difference(a, b);
    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = difference(k).rounded();
      holds = holds && std::isfinite(x) && Rational(x) == difference(k);
    }
    EXPECT_EQ(exact.has_value(), holds) << d.about;
    EXPECT_EQ(exact.value_or(rounded_difference(a, b)), rounded_difference(a, b)) << d.about;
    const auto moved = exact_sum(a, v);
    if (moved) look(*moved, sum);
    (holds ? kept : lost) += 1;
    infinite += std::isinf(rounded_dot(u, v)) ? 1 : 0;

    const Point2 a2{a.x, a.y}, b2{b.x, b.y};
    const Vector2 u2{u.x, u.y}, v2{v.x, v.y};
    const Vector3 flat = rounded_difference(a, b);
    EXPECT_EQ(rounded_difference(a2, b2), (Vector2{flat.x, flat.y})) << d.about;
    EXPECT_EQ(rounded_cross(u2, v2), rounded_cross(u, v).z) << d.about;
    EXPECT_EQ(rounded_dot(u2, v2), rounded_dot(Vector3{u.x, u.y, 0}, v)) << d.about;
    EXPECT_EQ(rounded_length(u2), rounded_length(Vector3{u.x, u.y, 0})) << d.about;
    EXPECT_EQ(rounded_midpoint(a2, b2), (Point2{rounded_midpoint(a, b).x, rounded_midpoint(a, b).y})) << d.about;
  }
  EXPECT_GT(lost, 100);
  EXPECT_GT(kept, 100);
  EXPECT_GT(infinite, 20);
}

TEST(RoundedPoints, Laws) {
  const Point3 a{0.1, -3, 0x1p-1074}, b{0x1p60, 0.3, largest};
  EXPECT_EQ(rounded_difference(a, b), negated(rounded_difference(b, a)));
  EXPECT_EQ(rounded_midpoint(a, b), rounded_midpoint(b, a));
  EXPECT_EQ(rounded_lerp(a, b, 0), a);
  EXPECT_EQ(rounded_lerp(a, b, 1), b);
  EXPECT_EQ(rounded_midpoint(Point2{largest, least}, Point2{largest, 2 * least}), (Point2{largest, 2 * least}));
  EXPECT_EQ(rounded_difference(Point2{largest, 0}, Point2{-largest, 0}).x, infinity);
  EXPECT_FALSE(exact_difference(Point2{largest, 0}, Point2{-largest, 0}));
  EXPECT_FALSE(exact_difference(Point2{1, 0}, Point2{0x1p-60, 0}));
  EXPECT_EQ(exact_difference(Point2{1, 0.25}, Point2{0.5, 0.5}), (Vector2{0.5, -0.25}));
  EXPECT_EQ(exact_sum(Point3{1, 2, 3}, Vector3{0.5, 0, -3}), (Point3{1.5, 2, 0}));
  // The plain cross product of 2^27 + 1 twice loses what is left.
  EXPECT_EQ(rounded_cross(Vector2{0x1p27 + 1, 0x1p27}, Vector2{0x1p27 + 2, 0x1p27 + 1}), 1);
}

TEST(RoundedPoints, NameWhatIsNoNumber) {
  const double nan = std::nan("");
  EXPECT_THAT(
      [&] {
        (void)rounded_difference(Point3{0, 0, 0}, Point3{0, nan, 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_difference: b.y is nan")));
  EXPECT_THAT(
      [&] {
        (void)rounded_lerp(Point2{0, 0}, Point2{0, 0}, infinity);
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_lerp: t is inf")));
  EXPECT_THAT(
      [&] {
        (void)rounded_normal({0, 0, 0}, {0, 0, 0}, {0, 0, -infinity});
      },
      ThrowsMessage<NonFinite>(HasSubstr("rounded_normal: c.z is -inf")));
  EXPECT_THAT(
      [&] {
        (void)exact_sum(Point2{0, 0}, Vector2{nan, 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("exact_sum: v.x is nan")));
}

}  // namespace
}  // namespace plumb

// Is the smallest ball around balls around them, and could none be smaller?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/shape_cases.hpp"
#include "figure/sphere/rational_ball.hpp"
#include "oracle/cgal_spheres_of_points.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {
namespace {

using namespace plumb_test;
using shape_cases::Material;
using shape_cases::on_shapes;
using testing::ElementsAre;

MinimumCircleOfCircles minimum(std::span<const Circle2> b) { return minimum_circle(b); }
MinimumSphereOfSpheres minimum(std::span<const Sphere3> b) { return minimum_sphere(b); }
MinimumCircle minimum(std::span<const Point2> p) { return minimum_circle(p); }
MinimumSphere minimum(std::span<const Point3> p) { return minimum_sphere(p); }
const Circle2& round_of(const MinimumCircleOfCircles& m) { return m.circle; }
const Sphere3& round_of(const MinimumSphereOfSpheres& m) { return m.sphere; }

template <class Ball>
bool is_around(const Ball& ball, const Ball& part) {
  const mpq_class rest = mpq_class(ball.radius) - mpq_class(part.radius);
  return rest >= 0 && squared_distance(rationals(ball.center), rationals(part.center)) <= rest * rest;
}

/// A point of the ball that is as far from the center as doubles find one.
template <class Ball>
auto far_side(const Ball& ball, const decltype(Ball::center)& from) {
  auto p = ball.center;
  std::array<double, 3> d{ball.center.x - from.x, ball.center.y - from.y, 0};
  if constexpr (requires { p.z; }) d[2] = ball.center.z - from.z;
  const double length = std::hypot(d[0], d[1], d[2]);
  for (double r = ball.radius, less = 0x1p-45;; r *= 1 - less, less *= 2) {
    const double by = length > 0 ? r / length : 0;
    p.x = ball.center.x + by * d[0] + (length > 0 ? 0 : r), p.y = ball.center.y + by * d[1];
    if constexpr (requires { p.z; }) p.z = ball.center.z + by * d[2];
    for (const double x : coordinates(p)) {
      if (!std::isfinite(x)) return ball.center;
    }
    const mpq_class radius(ball.radius);
    if (squared_distance(rationals(p), rationals(ball.center)) <= radius * radius) return p;
    if (less > 0.1) return ball.center;
  }
}

template <class Ball>
void expect_smallest(std::uint64_t start, std::uint64_t cases) {
  std::map<std::size_t, int> supports;
  int beyond = 0, many = 0, bounded = 0;
  on_shapes(start, cases, [&](Material& m) {
    std::vector<Ball> balls;
    for (std::size_t n = 1 + m.below(8); n-- > 0;) balls.push_back(m.shape<Ball>());
    std::string about = m.about();
    for (const Ball& b : balls) about.append(m.about(b));
    ++many;
    try {
      const auto found = minimum(balls);
      const Ball& ball = round_of(found);
      ++supports[found.support.size()];
      double size = ball.radius;
      for (const double x : coordinates(ball.center)) size = std::max(size, std::fabs(x));
      for (const Ball& b : balls) EXPECT_TRUE(is_around(ball, b)) << about;
      // Points of the support's balls alone need one that is as large, but for what doubles lose: of a ball about the
      // center they cannot tell where that is.
      std::vector<decltype(Ball::center)> far;
      double nearest = size, least = size;
      for (const std::uint32_t i : found.support) {
        far.push_back(far_side(balls[i], ball.center));
        nearest = std::min(nearest, ball.radius - balls[i].radius);
        if (balls[i].radius > 0) least = std::min(least, balls[i].radius);
      }
      const double spare = size * 0x1p-24;
      if (found.support.size() > 1 && nearest > size * 0x1p-16 && least > 0x1p-900 && size < 0x1p1000) {
        EXPECT_NE(compare_radius(minimum(far).exact, ball.radius - spare), Sign::negative) << about;
        ++bounded;
      }
      if (found.support.size() == 1) {
        EXPECT_EQ(ball, balls[found.support[0]]) << about;
      }
      std::vector<Ball> support;
      for (const std::uint32_t i : found.support) support.push_back(balls[i]);
      std::ranges::reverse(balls);
      std::swap(balls[0], balls[m.below(balls.size())]);
      const auto again = minimum(balls);
      EXPECT_EQ(round_of(again), ball) << about;
      std::vector<Ball> supported;
      for (const std::uint32_t i : again.support) supported.push_back(balls[i]);
      EXPECT_TRUE(supported == support) << about;
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_LT(beyond, many / 10);
  EXPECT_GT(bounded, many / 4);
  for (std::size_t k = 1; k <= coordinates(Ball{}.center).size(); ++k) EXPECT_GT(supports[k], many / 50) << k;
}

TEST(MinimumSphereOfSpheres, IsAroundThemAndNoLarger) { expect_smallest<Sphere3>(91, 500); }
TEST(MinimumCircleOfCircles, IsAroundThemAndNoLarger) { expect_smallest<Circle2>(92, 500); }

TEST(MinimumSphereOfSpheres, AgreesWithCgal) {
  std::map<std::size_t, int> supports;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Entropy entropy(93, i);
    std::vector<Sphere3> balls;
    std::vector<double> numbers;
    for (std::uint64_t n = 2 + entropy.below(60); n-- > 0;) {
      const Sphere3 b{
          {signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)},
          unit_coordinate(entropy) / 4};
      balls.push_back(b);
      numbers.insert(numbers.end(), {b.center.x, b.center.y, b.center.z, b.radius});
    }
    const MinimumSphereOfSpheres m = minimum_sphere(balls);
    ++supports[m.support.size()];
    const std::vector<double> other = oracle::smallest_ball_of_balls(numbers);
    EXPECT_NEAR(m.sphere.radius, other[3], 0x1p-40) << "start 93 index " << i;
    EXPECT_NEAR(m.sphere.center.x, other[0], 0x1p-30) << "start 93 index " << i;
  }
  EXPECT_GT(supports[4], 5);
  EXPECT_GT(supports[3], 5);
}

TEST(MinimumSphereOfSpheres, OfRadiusZeroIsThatOfPoints) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Entropy entropy(94, i);
    const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
    const Family family = families[entropy.below(9)].family;  // up to the wide ones
    const std::vector<Point3> points = points3(family, degeneracy, 1 + entropy.below(30), entropy);
    std::vector<Sphere3> balls;
    for (const Point3& p : points) balls.push_back({p, 0});
    const MinimumSphere a = minimum_sphere(points);
    const MinimumSphereOfSpheres b = minimum_sphere(balls);
    EXPECT_EQ(a.sphere, b.sphere) << "start 94 index " << i;
    EXPECT_EQ(a.support.size(), b.support.size()) << "start 94 index " << i;
  }
}

TEST(MinimumSphereOfSpheres, FindsNestedAndTouchingOnes) {
  const Sphere3 unit{{0, 0, 0}, 1}, within{{0.5, 0, 0}, 0.5};
  const std::vector<Sphere3> nested{within, unit, within, {{0, 0, 0}, 0.25}};
  EXPECT_EQ(minimum_sphere(nested).sphere, unit);
  EXPECT_THAT(minimum_sphere(nested).support, ElementsAre(1));
  const std::vector<Sphere3> row{unit, {{4, 0, 0}, 1}, {{2, 0, 0}, 3}, {{2, 0, 0}, 3}};
  EXPECT_EQ(minimum_sphere(row).sphere, (Sphere3{{2, 0, 0}, 3}));
  EXPECT_THAT(minimum_sphere(row).support, testing::SizeIs(1));
  // Four unit balls in the corners of a square, the fifth of radius 0 above: they touch a ball of radius 1 + sqrt 2.
  const std::vector<Sphere3> square{{{1, 1, 0}, 1}, {{-1, 1, 0}, 1}, {{1, -1, 0}, 1}, {{-1, -1, 0}, 1}, {{0, 0, 2}, 0}};
  const Sphere3 s = minimum_sphere(square).sphere;
  EXPECT_EQ(s.center, (Point3{0, 0, 0}));
  EXPECT_NEAR(s.radius, 1 + std::sqrt(2.0), 0x1p-50);
  // Balls of radii that differ: the smaller one outside of the line; (3, 4, 5).
  const std::vector<Circle2> circles{{{-3, 0}, 2}, {{3, 0}, 2}, {{0, 4}, 1}};
  EXPECT_EQ(minimum_circle(circles).circle.center.x, 0);
  EXPECT_EQ(minimum_circle(circles).circle.radius, 5);
}

// The line through both centers is 2^600 long and off an axis by 1: of the center in doubles 600 places vanish.
TEST(MinimumSphereOfSpheres, RoundsACenterThatCancels) {
  const double next = std::nextafter(0x1p600, HUGE_VAL);
  const std::vector<Sphere3> spheres{{{-0x1p600, 0, 0x1p600}, 0}, {{-0x1p600, 1, -1}, 0x1p600}};
  EXPECT_EQ(minimum_sphere(spheres).sphere, (Sphere3{{-0x1p600, 1, -0.5}, next}));
  const std::vector<Circle2> circles{{{0, 0x1p600}, 0}, {{1, -1}, 0x1p600}};
  EXPECT_EQ(minimum_circle(circles).circle, (Circle2{{1, -0.5}, next}));
  const std::vector<Circle2> least{{{0, 0x1p1000}, 0}, {{0x1p-1074, -0x1p-1074}, 0x1p1000}};
  EXPECT_EQ(minimum_circle(least).circle, (Circle2{{0x1p-1074, 0}, std::nextafter(0x1p1000, HUGE_VAL)}));
}

TEST(MinimumSphereOfSpheres, RefusesWhatIsNoBall) {
  const std::vector<Sphere3> negative{{{0, 0, 0}, 1}, {{0, 0, 0}, -1}},
      far{{{-0x1p1023, 0, 0}, 0x1p1023}, {{0x1p1023, 0, 0}, 0x1p1023}};
  EXPECT_THROW(minimum_sphere(negative), InvalidShape);
  EXPECT_THROW(minimum_sphere(std::span<const Sphere3>()), InvalidShape);
  EXPECT_THROW(minimum_circle(std::span<const Circle2>()), InvalidShape);
  EXPECT_THROW(minimum_sphere(far), BeyondDoubles);
  const std::vector<Circle2> bad{{{0, std::numeric_limits<double>::infinity()}, 1}};
  try {
    minimum_circle(bad);
    ADD_FAILURE();
  } catch (const NonFinite& e) {
    EXPECT_THAT(e.what(), testing::StartsWith("minimum_circle: circles[0].center.y is inf"));
  }
}

}  // namespace
}  // namespace plumb

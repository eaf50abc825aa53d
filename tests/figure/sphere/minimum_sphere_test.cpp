// Is the smallest ball the smallest, of every set of points, and does its rounding enclose them?
#include "plumb/figure/sphere/minimum_sphere.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/thrown.hpp"
#include "figure/sphere/rational_ball.hpp"
#include "oracle/cgal_spheres_of_points.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using namespace plumb_test;
using testing::ElementsAre;

constexpr double largest = std::numeric_limits<double>::max();

MinimumCircle minimum(std::span<const Point2> p) { return minimum_circle(p); }
MinimumSphere minimum(std::span<const Point3> p) { return minimum_sphere(p); }
const Circle2& round_of(const MinimumCircle& m) { return m.circle; }
const Sphere3& round_of(const MinimumSphere& m) { return m.sphere; }

template <class Point>
std::vector<Rationals> all_rationals(std::span<const Point> points) {
  std::vector<Rationals> all;
  for (const Point& p : points) all.push_back(rationals(p));
  return all;
}

/// The support's ball by rationals, proved to be the smallest: it holds all points, and its center is a convex
/// combination of the support.
template <class Point, class Minimum>
RationalBall proved(std::span<const Point> points, const Minimum& m, const std::string& replay) {
  std::vector<Rationals> support;
  for (const std::uint32_t i : m.support) support.push_back(rationals(points[i]));
  const auto ball = ball_through(support);
  EXPECT_TRUE(ball.has_value()) << replay;
  if (!ball) return smallest_ball(all_rationals(points));
  EXPECT_TRUE(ball->is_optimal()) << replay;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(ball->holds(rationals(points[i]))) << replay << " point " << i;
  }
  return *ball;
}

template <class Point, class Minimum>
void expect_rounded(std::span<const Point> points, const Minimum& m, const RationalBall& ball,
                    const std::string& replay) {
  const auto& round = round_of(m);
  const auto c = coordinates(round.center);
  for (std::size_t a = 0; a < c.size(); ++a) EXPECT_TRUE(is_nearest(c[a], ball.center[a])) << replay << " axis " << a;
  EXPECT_EQ(center(m.exact), round.center) << replay;
  EXPECT_TRUE(encloses(round.center, round.radius, points)) << replay;
  if (round.radius > 0) {
    EXPECT_FALSE(encloses(round.center, std::nextafter(round.radius, 0), points)) << replay;
  }
}

template <class Point>
std::vector<Point> family_points(Family family, Degeneracy degeneracy, std::size_t count, Entropy& entropy) {
  if constexpr (std::is_same_v<Point, Point2>) {
    return points2(family, degeneracy, count, entropy);
  } else {
    return points3(family, degeneracy, count, entropy);
  }
}

std::vector<double> numbers(std::span<const Point3> points) {
  std::vector<double> all;
  for (const Point3& p : points) all.insert(all.end(), {p.x, p.y, p.z});
  return all;
}
std::vector<double> numbers(std::span<const Point2> points) {
  std::vector<double> all;
  for (const Point2& p : points) all.insert(all.end(), {p.x, p.y});
  return all;
}

template <class Point>
void shuffle(std::vector<Point>& points, Entropy& entropy) {
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[entropy.below(i)]);
}

struct Count {
  int cases = 0, crowded = 0, beyond = 0;  // crowded: more points on the boundary than support it
  std::map<std::size_t, int> supports;
};

#if defined(PLUMB_LONG_TESTS)
constexpr int more = 20;
#else
constexpr int more = 1;
#endif

template <class Point>
Count on_families(std::uint64_t start) {
  Count count;
  std::uint64_t index = 0;
  for (int round = 0; round < 16 * more; ++round) {
    for (const FamilyInfo& family : families) {
      for (const Degeneracy degeneracy : degeneracies) {
        Entropy entropy(start, ++index);
        const std::string replay = "start " + std::to_string(start) + " index " + std::to_string(index);
        const std::size_t size = round % 2 == 0 ? 1 + entropy.below(6) : 5 + entropy.below(60);
        std::vector<Point> points = family_points<Point>(family.family, degeneracy, size, entropy);
        const std::span<const Point> all(points);
        ++count.cases;
        decltype(minimum(all)) m;
        try {
          m = minimum(all);
        } catch (const BeyondDoubles&) {
          const RationalBall ball = smallest_ball(all_rationals(all.first(std::min<std::size_t>(size, 7))));
          EXPECT_TRUE(size > 7 || ball.square > mpq_class(largest) * mpq_class(largest) / 2) << replay;
          ++count.beyond;
          continue;
        }
        ++count.supports[m.support.size()];
        const RationalBall ball = proved(all, m, replay);
        expect_rounded(all, m, ball, replay);
        if (size <= 6) {
          EXPECT_EQ(smallest_ball(all_rationals(all)).square, ball.square) << replay;
        }
        std::size_t on = 0;
        for (const Point& p : points) {
          const Location where = locate(m.exact, p);
          const mpq_class d = squared_distance(ball.center, rationals(p));
          EXPECT_EQ(static_cast<int>(where), cmp(ball.square, d) > 0 ? 1 : cmp(ball.square, d) < 0 ? -1 : 0) << replay;
          on += where == Location::boundary ? 1 : 0;
        }
        count.crowded += on > m.support.size() ? 1 : 0;
        if (family.family != Family::extreme && family.family != Family::mixture) {
          const auto exact = oracle::exact_smallest_ball(numbers(all), static_cast<int>(ball.center.size()));
          EXPECT_EQ(exact.back(), ball.square.get_str()) << replay;
        }
        std::vector<Point> support;
        for (const std::uint32_t i : m.support) support.push_back(points[i]);
        shuffle(points, entropy);
        const auto again = minimum(points);
        EXPECT_EQ(round_of(again), round_of(m)) << replay;
        std::vector<Point> supported;
        for (const std::uint32_t i : again.support) supported.push_back(points[i]);
        EXPECT_TRUE(supported == support) << replay;
      }
    }
  }
  return count;
}

TEST(MinimumSphere, IsProvedOnEveryFamilyInSpace) {
  const Count count = on_families<Point3>(61);
  for (std::size_t k = 1; k <= 4; ++k) EXPECT_GT(count.supports.at(k), count.cases / 50) << k;
  EXPECT_GT(count.crowded, count.cases / 20);
  EXPECT_LT(count.beyond, count.cases / 10);
}

TEST(MinimumCircle, IsProvedOnEveryFamilyInThePlane) {
  const Count count = on_families<Point2>(62);
  for (std::size_t k = 1; k <= 3; ++k) EXPECT_GT(count.supports.at(k), count.cases / 50) << k;
  EXPECT_GT(count.crowded, count.cases / 20);
}

// Boxes of integers are held by two opposite corners, or by others as far: solvers in doubles err here.
TEST(MinimumSphere, HoldsBoxesOfIntegers) {
  for (const double w : {1.0, 3.0, 7.0, 1023.0}) {
    for (const double h : {0.0, 1.0, 2.0, 100.0}) {
      std::vector<Point3> corners;
      for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? w : 0, i & 2 ? h : 0, i & 4 ? 5.0 : 0});
      const MinimumSphere m = minimum_sphere(corners);
      EXPECT_EQ(m.sphere.center, (Point3{w / 2, h / 2, 2.5}));
      EXPECT_TRUE(encloses<Point3>(m.sphere.center, m.sphere.radius, corners));
      EXPECT_NE(compare_radius(m.exact, m.sphere.radius), Sign::positive);
      EXPECT_EQ(compare_radius(m.exact, std::nextafter(m.sphere.radius, 0)), Sign::positive);
    }
  }
}

TEST(MinimumSphere, HoldsAWholeGridAndAllOfASphereOfIntegers) {
  std::vector<Point3> grid, sphere;
  for (int x = -12; x <= 12; ++x) {
    for (int y = -12; y <= 12; ++y) {
      for (int z = -12; z <= 12; ++z) {
        const Point3 p{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        if (x * x + y * y + z * z == 81) sphere.push_back(p);
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) <= 9) grid.push_back(p);
      }
    }
  }
  ASSERT_EQ(sphere.size(), 102u);
  EXPECT_EQ(minimum_sphere(sphere).sphere, (Sphere3{{0, 0, 0}, 9}));
  EXPECT_EQ(minimum_sphere(grid).sphere.center, (Point3{0, 0, 0}));
  EXPECT_TRUE(encloses<Point3>({0, 0, 0}, minimum_sphere(grid).sphere.radius, grid));
  EXPECT_EQ(compare_radius(minimum_sphere(grid).exact, minimum_sphere(sphere).exact), Sign::positive);
}

TEST(MinimumSphere, HoldsPointsOffASphereByUlps) {
  Entropy entropy(63);
  std::vector<Point3> points;
  while (points.size() < 3000) {
    const double x = signed_unit_coordinate(entropy), y = signed_unit_coordinate(entropy),
                 z = signed_unit_coordinate(entropy), d = std::sqrt(x * x + y * y + z * z);
    if (d > 0.1) points.push_back({x / d, y / d, z / d});
  }
  std::vector<SpannedSphere3> history;
  const MinimumSphere m = minimum_sphere(points, {&history});
  expect_rounded<Point3>(points, m, proved<Point3>(points, m, "ulps"), "ulps");
  for (std::size_t i = 1; i < history.size(); ++i) {
    EXPECT_EQ(compare_radius(history[i], history[i - 1]), Sign::positive);
  }
  EXPECT_EQ(compare_radius(history.back(), m.exact), Sign::zero);
}

/// Proved by rationals of the support and exact signs of all.
MinimumSphere proved_by_signs(std::span<const Point3> points) {
  std::vector<SpannedSphere3> history;
  const MinimumSphere m = minimum_sphere(points, {&history});
  std::vector<Rationals> support;
  for (const std::uint32_t i : m.support) support.push_back(rationals(points[i]));
  const auto ball = ball_through(support);
  EXPECT_TRUE(ball && ball->is_optimal());
  EXPECT_TRUE(std::ranges::none_of(points, [&](const Point3& p) { return locate(m.exact, p) == Location::outside; }));
  for (std::size_t i = 1; i < history.size(); ++i) {
    EXPECT_EQ(compare_radius(history[i], history[i - 1]), Sign::positive);
  }
  return m;
}

// Of so many points the ball of every 32nd is found first.
TEST(MinimumSphere, HoldsManyPointsWhoeverIsLookedAtFirst) {
  Entropy entropy(65);
  const auto unit = [&] { return signed_unit_coordinate(entropy); };
  constexpr std::size_t many = 32 * 1024 + 5;
  std::vector<Point3> sphere, cloud, lattice;
  while (sphere.size() < many) {
    const double x = unit(), y = unit(), z = unit(), d = std::sqrt(x * x + y * y + z * z);
    if (d > 0.1) sphere.push_back({x / d, y / d, z / d});
  }
  for (std::size_t i = 0; i < many; ++i) {
    const bool first = i % 32 == 0;
    cloud.push_back(first ? Point3{1, 2, 3} : Point3{unit(), unit() * 3, unit()});
    lattice.push_back(first ? Point3{9, 0, 0} : Point3{i % 3 == 0 ? -7.0 : 7.0, i % 5 == 0 ? -4.0 : 4.0, 4});
  }
  for (std::vector<Point3>* const points : {&sphere, &cloud, &lattice}) {
    const MinimumSphere m = proved_by_signs(*points);
    std::ranges::reverse(*points);
    const MinimumSphere again = minimum_sphere(*points);
    EXPECT_EQ(again.sphere, m.sphere);
    EXPECT_EQ(again.exact.points, m.exact.points);
  }
}

TEST(MinimumSphere, NamesTheFirstOfEqualPoints) {
  const std::vector<Point3> points{{1, 0, 0}, {0.0, 0, 0}, {-0.0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  EXPECT_THAT(minimum_sphere(points).support, ElementsAre(1, 0));
  EXPECT_EQ(minimum_sphere(points).sphere, (Sphere3{{0.5, 0, 0}, 0.5}));
  const std::vector<Point3> equal(5, Point3{3, -0.0, 5});
  EXPECT_THAT(minimum_sphere(equal).support, ElementsAre(0));
  EXPECT_EQ(minimum_sphere(equal).sphere.radius, 0);
}

TEST(MinimumSphere, RefusesWhatIsNoSetOfPoints) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(text_of<InvalidShape>([] { minimum_sphere(std::span<const Point3>()); }),
            "minimum_sphere: no points; give at least one");
  EXPECT_EQ(text_of<InvalidShape>([] { minimum_circle(std::span<const Point2>()); }),
            "minimum_circle: no points; give at least one");
  const std::vector<Point3> bad{{0, 0, 0}, {1, nan, 0}};
  EXPECT_THAT(text_of<NonFinite>([&] { minimum_sphere(bad); }),
              testing::StartsWith("minimum_sphere: points[1].y is nan"));
  const std::vector<Point2> wide{{0, -infinity}, {1, 0}};
  EXPECT_THAT(text_of<NonFinite>([&] { minimum_circle(wide); }),
              testing::StartsWith("minimum_circle: points[0].y is -inf"));
  const std::vector<Point3> far{{-largest, -largest, -largest}, {largest, largest, largest}};
  EXPECT_THAT(text_of<BeyondDoubles>([&] { minimum_sphere(far); }), testing::StartsWith("minimum_sphere: radius"));
  const std::vector<Point3> wide_line{{-largest, 0, 0}, {largest, 0, 0}};
  EXPECT_EQ(minimum_sphere(wide_line).sphere, (Sphere3{{0, 0, 0}, largest}));
}

TEST(SpannedBall, RefusesWhatSpansNone) {
  EXPECT_THROW(center(SpannedSphere3{{}, 0}), InvalidShape);
  EXPECT_THROW(center(SpannedCircle2{{}, 4}), InvalidShape);
  EXPECT_THROW(center(SpannedSphere3{{Point3{1, 1, 1}, {1, 1, 1}}, 2}), InvalidShape);
  EXPECT_THROW(radius(Rounding::up, SpannedCircle2{{Point2{0, 0}, {1, 1}, {2, 2}}, 3}), InvalidShape);
  EXPECT_THROW(locate(SpannedSphere3{{Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 4}, Point3{}), InvalidShape);
  EXPECT_THROW(locate(SpannedSphere3{{}, 1}, Point3{0, 0, HUGE_VAL}), NonFinite);
  EXPECT_THROW(center(SpannedSphere3{{Point3{0, 0, HUGE_VAL}}, 1}), NonFinite);
  EXPECT_THROW(compare_radius(SpannedSphere3{{}, 1}, HUGE_VAL), NonFinite);
}

TEST(SpannedBall, ComparesAndRoundsRadii) {
  const SpannedSphere3 unit{{Point3{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, 4};
  const SpannedSphere3 flat{{Point3{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, 3}, line{{Point3{7, 7, 6}, {7, 7, 8}}, 2};
  EXPECT_EQ(compare_radius(unit, flat), Sign::zero);
  EXPECT_EQ(compare_radius(unit, line), Sign::zero);
  EXPECT_EQ(compare_radius(unit, 1), Sign::zero);
  EXPECT_EQ(compare_radius(unit, -1), Sign::positive);
  EXPECT_EQ(compare_radius(line, std::nextafter(1, 2)), Sign::negative);
  const SpannedCircle2 root{{Point2{0, 0}, {1, 1}}, 2};  // sqrt(1/2)
  EXPECT_EQ(radius(Rounding::down, root), std::nextafter(radius(Rounding::up, root), 0));
  EXPECT_EQ(compare_radius(root, radius(Rounding::down, root)), Sign::positive);
  EXPECT_EQ(compare_radius(root, radius(Rounding::up, root)), Sign::negative);
}

}  // namespace
}  // namespace plumb

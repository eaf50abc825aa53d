// Do the quick spheres hold their points, and are they as good as their names promise?
#include "plumb/figure/sphere/fits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure/sphere/rational_ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb {
namespace {

using namespace plumb_test;

struct Fit {
  const char* name;
  Sphere3 (*fit)(std::span<const Point3>);
};
constexpr Fit fits[] = {
    {"fit_sphere_box", fit_sphere_box},
    {"fit_sphere_ritter", fit_sphere_ritter},
    {"fit_sphere_principal", fit_sphere_principal},
    {"fit_sphere_iterated_ritter", [](std::span<const Point3> p) { return fit_sphere_iterated_ritter(p); }},
};

#if defined(PLUMB_LONG_TESTS)
constexpr int more = 20;
#else
constexpr int more = 1;
#endif

TEST(SphereFits, HoldTheirPointsOnEveryFamily) {
  std::uint64_t index = 0;
  int beyond = 0;
  for (int round = 0; round < 20 * more; ++round) {
    for (const FamilyInfo& family : families) {
      for (const Degeneracy degeneracy : degeneracies) {
        Entropy entropy(81, ++index);
        const std::vector<Point3> points = points3(family.family, degeneracy, 1 + entropy.below(80), entropy);
        for (const Fit& f : fits) {
          const std::string replay = std::string(f.name).append(" start 81 index ").append(std::to_string(index));
          try {
            const Sphere3 s = f.fit(points);
            EXPECT_TRUE(encloses<Point3>(s.center, s.radius, points)) << replay;
            EXPECT_TRUE(s.radius == 0 || !encloses<Point3>(s.center, std::nextafter(s.radius, 0), points)) << replay;
            EXPECT_EQ(f.fit(points), s) << replay;
            const MinimumSphere least = minimum_sphere(points);
            EXPECT_NE(compare_radius(least.exact, s.radius), Sign::positive) << replay;
            // No center in the points' box is worse than its diagonal, three minimal radii away.
            EXPECT_LE(s.radius / 4, least.sphere.radius) << replay;
          } catch (const BeyondDoubles&) {
            ++beyond;
          }
        }
      }
    }
  }
  EXPECT_LT(beyond, 300 * more);
}

// Figure 4.8: a cloud along a diagonal, where the axes of the world see least of its spread.
TEST(SphereFits, FollowTheDirectionOfMaximumSpread) {
  std::vector<Point3> points;
  Entropy entropy(82);
  for (int i = 0; i < 500; ++i) {
    const double t = signed_unit_coordinate(entropy), w = signed_unit_coordinate(entropy) / 8;
    points.push_back({t + w, t - w, t});
  }
  const double principal = fit_sphere_principal(points).radius, least = minimum_sphere(points).sphere.radius;
  EXPECT_LT(principal, least * 1.01);
  EXPECT_LT(least, std::sqrt(3.0) * 1.1);
}

// The mean of points that are crowded in one place is a bad center, the middle of the box is not (4.3.2).
TEST(SphereFits, DoNotMindCrowds) {
  std::vector<Point3> points(1000, Point3{0, 0, 0});
  points.push_back({2, 0, 0});
  for (const Fit& f : fits) EXPECT_EQ(f.fit(points), (Sphere3{{1, 0, 0}, 1})) << f.name;
}

TEST(SphereFits, RefineByIteration) {
  Entropy entropy(83);
  std::vector<Point3> points = points3(Family::uniform, Degeneracy::coplanar, 400, entropy);
  std::vector<Sphere3> history;
  const Sphere3 s = fit_sphere_iterated_ritter(points, {20, 0.95, &history});
  EXPECT_EQ(history.size(), 21u);
  EXPECT_LE(s.radius, fit_sphere_ritter(points).radius);
  EXPECT_LE(s.radius, minimum_sphere(points).sphere.radius * 1.05);
  EXPECT_EQ(fit_sphere_iterated_ritter(points, {0}), fit_sphere_ritter(points));
}

TEST(SphereFits, RefuseWhatIsNoSetOfPoints) {
  const std::vector<Point3> bad{{0, 0, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
  const double largest = std::numeric_limits<double>::max();
  const std::vector<Point3> far{{-largest, -largest, -largest}, {largest, largest, largest}};
  for (const Fit& f : fits) {
    EXPECT_THROW(f.fit({}), InvalidShape) << f.name;
    EXPECT_THROW(f.fit(far), BeyondDoubles) << f.name;
    EXPECT_EQ(f.fit(std::vector<Point3>(3, Point3{1, 2, 3})), (Sphere3{{1, 2, 3}, 0})) << f.name;
    try {
      f.fit(bad);
      ADD_FAILURE() << f.name;
    } catch (const NonFinite& e) {
      EXPECT_THAT(e.what(), testing::StartsWith(std::string(f.name).append(": points[1].z is inf")));
    }
  }
  EXPECT_THROW(fit_sphere_iterated_ritter(bad, {1, 2.0}), Error);
}

}  // namespace
}  // namespace plumb

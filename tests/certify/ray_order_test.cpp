// Is the order in which a ray meets planes exact, and is it that of the points of intersection?
#include "plumb/certify/ray_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/space_cases.hpp"
#include "oracle/space.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/predicates/line_triangle.hpp"
#include "plumb/predicates/ray_order.hpp"

namespace plumb::space_cases {
namespace {

using Plane = std::array<Point3, 3>;

constexpr Plane floor_plane{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}};
constexpr Plane ceiling{Point3{0, 0, 3}, Point3{0, 1, 3}, Point3{1, 0, 3}};
constexpr Plane wall{Point3{2, 0, 0}, Point3{2, 1, 0}, Point3{2, 0, 1}};

TEST(RayOrderTest, MeansWhatItSays) {
  const Point3 eye{0, 0, 1};
  const Vector3 up{0, 0, 2}, slanted{2, 0, 2};
  EXPECT_EQ(compare_ray_parameters(eye, up, floor_plane, ceiling), Sign::negative);  // t = -1/2 and 1
  EXPECT_EQ(compare_ray_parameters(eye, up, ceiling, floor_plane), Sign::positive);
  EXPECT_EQ(compare_ray_parameters(eye, slanted, ceiling, wall), Sign::zero);  // along the edge of both
  EXPECT_EQ(compare_ray_parameters(eye, up, ceiling, wall), std::nullopt);     // parallel to the wall
  EXPECT_EQ(compare_ray_parameters(eye, {0, 0, 0}, ceiling, wall), std::nullopt);
  EXPECT_EQ(compare_ray_parameters(eye, up, ceiling, {eye, eye, Point3{1, 1, 1}}), std::nullopt);
  EXPECT_EQ(compare_ray_parameter(eye, up, ceiling, 1), Sign::zero);
  EXPECT_EQ(compare_ray_parameter(eye, up, ceiling, std::nextafter(1, 2)), Sign::negative);
  EXPECT_EQ(compare_ray_parameter(eye, up, ceiling, std::nextafter(1, 0)), Sign::positive);
  EXPECT_EQ(compare_ray_parameter(eye, up, floor_plane, 0), Sign::negative);  // behind the eye
  EXPECT_EQ(compare_segment_parameter(eye, {7, 8, 5}, ceiling, 0.5), Sign::zero);
  EXPECT_EQ(compare_segment_parameters(eye, {4, 0, 9}, ceiling, wall), Sign::negative);
}

Sign opposite(Sign s) { return -s; }

// One case of eight points: a ray by its origin and direction or by two points, and two planes.
struct Tally {
  Shares order, at_parameter;
  int parallel = 0;
};

void check(const std::vector<Point3>& p, double t, Tally& tally) {
  const Vector3 d = vector(p[1]);
  const Plane first{p[2], p[3], p[4]}, second{p[5], p[6], p[7]};
  const auto truth = oracle::compare_ray_parameters(p[0], d, first, second);
  ASSERT_EQ(compare_ray_parameters(p[0], d, first, second), truth) << shown(p);
  ASSERT_EQ(compare_ray_parameters(p[0], d, second, {p[3], p[2], p[4]}),
            truth ? std::optional(opposite(*truth)) : truth)
      << shown(p);
  const auto at = oracle::compare_ray_parameter(p[0], d, first, t);
  ASSERT_EQ(compare_ray_parameter(p[0], d, first, t), at) << shown(p) << " t " << t;
  if (truth) tally.order(*truth);
  if (at) tally.at_parameter(*at);
  if (!at) ++tally.parallel;
}

TEST(RayOrderTest, AgreesWithPointsOfIntersectionOnGrids) {
  Tally tally;
  on_grids(8, 10'000, [&](const std::vector<Point3>& p) {
    check(p, (p[7].x + p[7].y) / 4, tally);
    // On a grid q - p is exact: the segment is the ray.
    const Point3 q{p[0].x + p[1].x, p[0].y + p[1].y, p[0].z + p[1].z};
    const Plane first{p[2], p[3], p[4]}, second{p[5], p[6], p[7]};
    ASSERT_EQ(compare_segment_parameters(p[0], q, first, second),
              compare_ray_parameters(p[0], vector(p[1]), first, second))
        << shown(p);
    ASSERT_EQ(compare_segment_parameter(p[0], q, first, 0.5), compare_ray_parameter(p[0], vector(p[1]), first, 0.5))
        << shown(p);
  });
  EXPECT_GT(tally.order.least(), 0.02);
  EXPECT_GT(tally.at_parameter.least(), 0.02);
  EXPECT_GT(tally.parallel, battery::fitting(500));
}

TEST(RayOrderTest, AgreesWithPointsOfIntersectionOnFamilies) {
  Tally tally;
  on_families(8, 150, [&](const std::vector<Point3>& p) { check(p, p[7].z, tally); });
  EXPECT_GT(tally.order.of(Sign::negative), 0.2);
  EXPECT_GT(tally.order.of(Sign::positive), 0.2);
}

// Planes through one point of the ray are met together: points of one plane make such rays and planes.
TEST(RayOrderTest, KnowsWhenTwoPlanesAreMetTogether) {
  int together = 0, parallel = 0;
  for (std::uint64_t i = 0; i < 1000 * more; ++i) {
    Entropy entropy(51, i);
    // The ray goes through p[1]; so do both planes.
    const auto p = points3(i % 2 == 0 ? Family::grid : Family::uniform, Degeneracy::coplanar, 6, entropy);
    const auto order = compare_segment_parameters(p[0], p[1], {p[1], p[2], p[3]}, {p[4], p[1], p[5]});
    const auto end = compare_segment_parameter(p[0], p[1], {p[1], p[2], p[3]}, 1);
    ASSERT_EQ(order.value_or(Sign::zero), Sign::zero) << shown(p);
    ASSERT_EQ(end.value_or(Sign::zero), Sign::zero) << shown(p);
    ++(order ? together : parallel);
  }
  EXPECT_GT(together, 900);
}

TEST(RayOrderTest, FormulasAreExactOnEveryFamily) {
  Shares ray, segment, against;
  on_families(8, 600, [&](const std::vector<Point3>& p) {
    using predicates::RayOrder, predicates::SegmentOrder, predicates::SegmentAgainst, predicates::OrientSeenAlong;
    const Plane first{p[2], p[3], p[4]}, second{p[5], p[6], p[7]};
    const auto signs = [&](const Plane& s) {
      return in_rationals<OrientSeenAlong>(gathered<OrientSeenAlong>(p[0], p[1], s[0], s[1], s[2]));
    };
    const Sign denominators = signs(first) * signs(second);
    const auto truth =
        segment(in_rationals<SegmentOrder>(gathered<SegmentOrder>(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]))) *
        denominators;
    const auto said = compare_segment_parameters(p[0], p[1], first, second);
    ASSERT_EQ(said, denominators == Sign::zero ? std::nullopt : std::optional(truth)) << shown(p);
    const auto eight = gathered<RayOrder>(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
    ASSERT_EQ(decide<RayOrder>(eight), ray(in_rationals<RayOrder>(eight))) << shown(p);
    auto five = gathered<SegmentAgainst>(p[0], p[1], p[2], p[3], p[4]);
    five.back() = p[5].x;
    ASSERT_EQ(decide<SegmentAgainst>(five), against(in_rationals<SegmentAgainst>(five))) << shown(p);
  });
  EXPECT_GT(ray.least(), 0.1);
  EXPECT_GT(segment.least(), 0.1);
  EXPECT_GT(against.least(), 0.1);
}

TEST(RayOrderTest, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)compare_ray_parameters({0, 0, nan}, {0, 0, 1}, floor_plane, ceiling), NonFinite);
  EXPECT_THROW((void)compare_ray_parameters({0, 0, nan}, {1, 0, 0}, floor_plane, ceiling), NonFinite);  // parallel
  EXPECT_THROW((void)compare_ray_parameters({0, 0, 1}, {0, infinity, 1}, floor_plane, ceiling), NonFinite);
  EXPECT_THROW((void)compare_ray_parameter({0, 0, 1}, {0, 0, 1}, floor_plane, nan), NonFinite);
  EXPECT_THROW((void)compare_ray_parameter({0, 0, 1}, {1, 0, 0}, floor_plane, infinity), NonFinite);
  EXPECT_THROW((void)compare_segment_parameter({0, 0, 1}, {1, 0, nan}, floor_plane, 0), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases

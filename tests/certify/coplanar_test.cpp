// Is the orientation of points of a plane in space exact, consistent in the plane, and as CGAL has it?
#include "plumb/certify/coplanar.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "certify/space_cases.hpp"
#include "oracle/space.hpp"

namespace plumb::space_cases {
namespace {

constexpr Sign plus = Sign::positive, zero = Sign::zero, minus = Sign::negative;

TEST(CoplanarTest, MeansWhatItSays) {
  const Point3 a{0, 0, 1}, b{4, 0, 1}, c{0, 4, 1};
  EXPECT_EQ(coplanar_orientation(a, b, c), plus);  // from above
  EXPECT_EQ(coplanar_orientation(a, c, b), minus);
  EXPECT_EQ(coplanar_orientation({1, 0, 0}, {1, 2, 0}, {1, 0, 2}), plus);  // from the right
  EXPECT_EQ(coplanar_orientation({0, 1, 0}, {2, 1, 0}, {0, 1, 2}), plus);  // from the front
  EXPECT_EQ(coplanar_orientation({0, 0, 0}, {1, 2, 3}, {-2, -4, -6}), zero);
  EXPECT_EQ(coplanar_orientation(a, a, b), zero);
  EXPECT_EQ(coplanar_orientation(a, b, c, {3, 3, 1}), plus);
  EXPECT_EQ(coplanar_orientation(a, b, c, {3, -3, 1}), minus);
  EXPECT_EQ(coplanar_orientation(a, b, c, {9, 0, 1}), zero);
  EXPECT_EQ(coplanar_orientation(a, b, c, {1, 0, 7}), zero);  // a right angle
  EXPECT_EQ(orient_seen_from(Vector3{0, 0, 1}, a, b, c), plus);
  EXPECT_EQ(orient_seen_from(Vector3{5, 5, -1}, a, b, c), minus);
  EXPECT_EQ(orient_seen_from(Vector3{1, 2, 0}, a, b, c), zero);
  EXPECT_EQ(orient_seen_from(Point3{1, 1, 2}, a, b, c), plus);
  EXPECT_EQ(orient_seen_from(Point3{1, 1, 0}, a, b, c), minus);
  EXPECT_EQ(orient_seen_from(Point3{9, 9, 1}, a, b, c), zero);
}

// Points of one plane: four, of which CGAL is asked, and a fifth and sixth for consistency.
void agree_with_cgal(const std::vector<Point3>& p, Shares& three, Shares& four) {
  const Sign s = coplanar_orientation(p[0], p[1], p[2]), t = coplanar_orientation(p[0], p[1], p[3]);
  ASSERT_EQ(s, three(oracle::coplanar_orientation(p[0], p[1], p[2]))) << shown(p);
  const auto side = oracle::coplanar_orientation(p[0], p[1], p[2], p[3]);
  if (!side) return;
  ASSERT_EQ(coplanar_orientation(p[0], p[1], p[2], p[3]), four(*side)) << shown(p);
  ASSERT_EQ(s * t, *side) << shown(p);
}

TEST(CoplanarTest, AgreesWithCgalOnPlanes) {
  Shares three, four;
  for (const Family family : {Family::degenerate_short, Family::degenerate_long, Family::repeated}) {
    for (std::uint64_t i = 0; i < 2000 * more; ++i) {
      Entropy entropy(41, i);
      agree_with_cgal(points3(family, i % 8 == 0 ? Degeneracy::collinear : Degeneracy::coplanar, 4, entropy), three,
                      four);
    }
  }
  EXPECT_GT(three.least(), 0.05);
  EXPECT_GT(four.least(), 0.02);
}

TEST(CoplanarTest, AgreesWithCgalOnGrids) {
  Shares three, four;
  on_grids(4, 12'000, [&](std::vector<Point3> p) {
    // Into a plane of constant x, of constant y or of constant z, or as they are.
    const int axis = static_cast<int>(p[0].x + p[1].y + p[2].z + 12) % 4;
    for (Point3& q : p) {
      if (axis == 0) q.x = p[0].x;
      if (axis == 1) q.y = p[0].y;
      if (axis == 2) q.z = p[0].z;
    }
    agree_with_cgal(p, three, four);
  });
  EXPECT_GT(three.least(), 0.1);
  EXPECT_GT(four.least(), 0.1);
}

// Law 3: with a, b, c, d in one plane, orientations obey the relation that areas do.
TEST(CoplanarTest, IsConsistentInAPlane) {
  for (std::uint64_t i = 0; i < 3000 * more; ++i) {
    Entropy entropy(43, i);
    const Family family = i % 2 == 0 ? Family::degenerate_short : Family::degenerate_long;
    const auto p = points3(family, Degeneracy::coplanar, 4, entropy);
    const Sign abc = coplanar_orientation(p[0], p[1], p[2]), abd = coplanar_orientation(p[0], p[1], p[3]),
               bcd = coplanar_orientation(p[1], p[2], p[3]), cad = coplanar_orientation(p[2], p[0], p[3]);
    // abc = abd + bcd + cad as areas.
    if (abd == bcd && bcd == cad) {
      ASSERT_EQ(abc, abd) << shown(p);
    }
    if (abc == zero && abd == zero && bcd == zero) {
      ASSERT_EQ(cad, zero) << shown(p);
    }
    // Law 1.
    ASSERT_EQ(coplanar_orientation(p[1], p[0], p[2]), -abc) << shown(p);
    ASSERT_EQ(coplanar_orientation(p[1], p[2], p[0]), abc) << shown(p);
  }
}

TEST(CoplanarTest, AnyFourPointsHaveAnAngle) {
  Shares angles;
  on_families(4, 1000, [&](const std::vector<Point3>& p) {
    using predicates::CoplanarSide;
    const Sign truth = in_rationals<CoplanarSide>(gathered<CoplanarSide>(p[0], p[1], p[2], p[3]));
    ASSERT_EQ(coplanar_orientation(p[0], p[1], p[2], p[3]), angles(truth)) << shown(p);
    ASSERT_EQ(coplanar_orientation(p[1], p[0], p[3], p[2]), truth) << shown(p);
  });
  EXPECT_GT(angles.least(), 0.05);
}

TEST(CoplanarTest, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_THROW(coplanar_orientation(a, {1, 0, nan}, c), NonFinite);
  EXPECT_THROW(coplanar_orientation(a, b, {0, 1, -infinity}), NonFinite);
  EXPECT_THROW(coplanar_orientation(a, b, {0, nan, 1}), NonFinite);
  EXPECT_THROW(coplanar_orientation(a, b, c, {0, nan, 1}), NonFinite);
  EXPECT_THROW(orient_seen_from(Vector3{0, 0, nan}, a, b, c), NonFinite);
  EXPECT_THROW(orient_seen_from(Point3{0, 0, infinity}, a, b, c), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases

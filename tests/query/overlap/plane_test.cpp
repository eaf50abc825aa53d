// Planes and halfspaces against a linear program in rationals.
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/relation_counts.hpp"

namespace plumb {
namespace {

template <class Plane>
struct OverlapPlane : testing::Test {};
using Planes = testing::Types<Plane3, ThreePointPlane3, Halfspace3>;
TYPED_TEST_SUITE(OverlapPlane, Planes);

TYPED_TEST(OverlapPlane, AgreesWithTheOracle) {
  expect_as_oracle<Point3, TypeParam>(54, 1000);
  expect_as_oracle<Segment3, TypeParam>(55, 1000);
  expect_as_oracle<TypeParam, Triangle3>(56, 1000);
  expect_as_oracle<TypeParam, Tetrahedron3>(57, 500);
  expect_as_oracle<TypeParam, Aabb3>(58, 500);
  expect_as_oracle<TypeParam, Obb3>(59, 500);
}

// RTCD figure 5.16: the box reaches the plane by the sum of what its three extents reach along the normal.
TEST(OverlapPlaneCases, OrientedBoxAndPlane) {
  const Obb3 box{{0, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  EXPECT_EQ(relate(Plane3{{1, 0, 0}, 2}, box), Relation::touching);  // along an edge, at x = 2
  EXPECT_EQ(relate(Plane3{{1, 0, 0}, 0x1.0000000000001p1}, box), Relation::disjoint);
  EXPECT_EQ(relate(Plane3{{-3, 0, 0}, 5}, box), Relation::overlapping);
  EXPECT_EQ(relate(ThreePointPlane3{{2, 0, 0}, {2, 1, 0}, {2, 0, 7}}, box), Relation::touching);
  EXPECT_EQ(relate(Halfspace3{{1, 0, 0}, -2}, box), Relation::touching);
  EXPECT_EQ(relate(Halfspace3{{1, 0, 0}, -2.5}, box), Relation::disjoint);
  EXPECT_EQ(relate(Plane3{{0, 0, 0}, 0}, box), Relation::overlapping);  // all of space
  EXPECT_EQ(relate(Plane3{{0, 0, 0}, 1}, box), Relation::disjoint);     // nothing
}

// RTCD figure 5.20: a segment against a plane; in it, along it, and only with an end.
TEST(OverlapPlaneCases, SegmentAndPlane) {
  const Plane3 plane{{1, 1, 1}, 1};
  EXPECT_EQ(relate(Segment3{{0, 0, 0}, {1, 1, 1}}, plane), Relation::overlapping);
  EXPECT_EQ(relate(Segment3{{0, 0, 0}, {1, 0, 0}}, plane), Relation::touching);
  EXPECT_EQ(relate(Segment3{{0, 0, 0}, {0x1.fffffffffffffp-1, 0, 0}}, plane), Relation::disjoint);
  EXPECT_EQ(relate(Segment3{{1, 0, 0}, {0, 1, 0}}, plane), Relation::overlapping);
  EXPECT_EQ(relate(Segment3{{2, 0, 0}, {0, 2, 0}}, plane), Relation::disjoint);
  // Three points on a line are that line.
  EXPECT_EQ(relate(Segment3{{0, 0, 1}, {0, 1, 0}}, ThreePointPlane3{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}),
            Relation::disjoint);
  EXPECT_EQ(relate(Segment3{{1, 0, 1}, {1, 2, 1}}, ThreePointPlane3{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}),
            Relation::overlapping);
}

}  // namespace
}  // namespace plumb

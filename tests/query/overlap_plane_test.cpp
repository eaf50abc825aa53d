// Planes and halfspaces against a linear program in rationals.
#include "plumb/query/overlap_plane.hpp"

#include "query/relation_counts.hpp"

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

}  // namespace
}  // namespace plumb

// Figures of the plane against a linear program in rationals.
#include <cmath>

#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/flat_lattices.hpp"

namespace plumb {
namespace {

template <class Pair>
struct Overlap2 : testing::Test {};
template <class A, class B>
struct Of {
  using First = A;
  using Second = B;
};
using Pairs =
    testing::Types<Of<Line2, Line2>, Of<Line2, Ray2>, Of<Line2, Segment2>, Of<Line2, Triangle2>, Of<Line2, Aabb2>,
                   Of<Ray2, Ray2>, Of<Ray2, Segment2>, Of<Ray2, Triangle2>, Of<Ray2, Aabb2>, Of<Segment2, Segment2>,
                   Of<Segment2, Triangle2>, Of<Segment2, Aabb2>, Of<Triangle2, Triangle2>, Of<Triangle2, Aabb2>>;
TYPED_TEST_SUITE(Overlap2, Pairs);

TYPED_TEST(Overlap2, AgreesWithTheOracle) {
  expect_as_oracle<typename TypeParam::First, typename TypeParam::Second>(51, 1000);
}

TEST(Overlap2Cases, LatticesOfEveryWidth) {
  expect_as_oracle_on_lattices<Triangle2, Triangle2, 2>(63, 2000);
  expect_as_oracle_on_lattices<Segment2, Triangle2, 2>(64, 2000);
  expect_as_oracle_on_lattices<Segment2, Segment2, 2>(65, 2000);
}

// RTCD figure 5.10: the lines cross, but beyond an end; within both; and with an end on the other segment.
TEST(Overlap2Cases, SegmentsWhoseLinesCross) {
  const Segment2 ab{{0, 0}, {4, 4}};
  EXPECT_EQ(relate(ab, Segment2{{6, 0}, {8, -2}}), Relation::disjoint);
  EXPECT_EQ(relate(ab, Segment2{{3, 0}, {4, -1}}), Relation::disjoint);  // the line of ab passes it, the boxes meet
  EXPECT_EQ(relate(ab, Segment2{{0, 2}, {2, 0}}), Relation::overlapping);
  EXPECT_EQ(relate(ab, Segment2{{1, 1}, {9, 0}}), Relation::touching);
  EXPECT_EQ(relate(ab, Segment2{{4, 4}, {9, 0}}), Relation::touching);
  EXPECT_EQ(relate(ab, Segment2{{4, 4}, {6, 6}}), Relation::touching);
  EXPECT_EQ(relate(ab, Segment2{{3, 3}, {6, 6}}), Relation::overlapping);
  EXPECT_EQ(relate(ab, Segment2{{5, 5}, {6, 6}}), Relation::disjoint);
  EXPECT_EQ(relate(ab, Segment2{{1, 1}, {1, 1}}), Relation::overlapping);  // a point is its own inside
  EXPECT_EQ(relate(ab, Segment2{{0, 0}, {0, 0}}), Relation::touching);
  EXPECT_EQ(relate(Segment2{{0, 0}, {0, 0}}, Segment2{{0, 0}, {-0.0, 0}}), Relation::overlapping);
}

// The point where they meet is no double: a third of the way.
TEST(Overlap2Cases, AnUlpTellsTouchingApart) {
  const Segment2 s{{0, 0}, {3, 1}};
  EXPECT_EQ(relate(s, Segment2{{1.5, 0.5}, {2, 5}}), Relation::touching);
  EXPECT_EQ(relate(s, Segment2{{1.5, 0x1.0000000000001p-1}, {2, 5}}), Relation::disjoint);
  EXPECT_EQ(relate(s, Segment2{{1.5, 0x1.fffffffffffffp-2}, {2, 5}}), Relation::overlapping);
  EXPECT_EQ(relate(Segment2{{0, 0}, {0x1p1000, 0x1p-1000}}, Segment2{{0x1p999, 0x1p-1001}, {0x1p999, 1}}),
            Relation::touching);
}

TEST(Overlap2Cases, EmptyAndFlatBoxes) {
  const Triangle2 t{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(relate(t, Aabb2{{1, 1}, {0, 2}}), Relation::disjoint);
  EXPECT_EQ(relate(t, Aabb2{{1, 1}, {1, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(t, Aabb2{{2, 2}, {2, 2}}), Relation::touching);
  EXPECT_EQ(relate(t, Aabb2{{2, 2}, {3, 3}}), Relation::touching);
  EXPECT_EQ(relate(t, Aabb2{{-1, 1}, {5, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(t, Aabb2{{-1, 0}, {5, 0}}), Relation::touching);
}

TEST(Overlap2Cases, NamesWhatIsNoNumber) {
  try {
    relate(Ray2{{0, 0}, {1, INFINITY}}, Triangle2{});
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_EQ(std::string(e.what()).rfind("relate: ray.direction.y is inf", 0), 0u) << e.what();
  }
}

}  // namespace
}  // namespace plumb

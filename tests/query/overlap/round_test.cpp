// Balls, circles, capsules and lozenges against everything that the table has: against brute force over rationals.
#include <gtest/gtest.h>

#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/round_oracle.hpp"

namespace plumb {
namespace {

TEST(OverlapRound, AllPairsOfSpaceAsBruteForce) { pair_cases::expect_all_round(pair_cases::Space{}, 500); }
TEST(OverlapRound, AllPairsOfThePlaneAsBruteForce) { pair_cases::expect_all_round(pair_cases::Plane{}, 620); }

TEST(OverlapRound, BoxesWhoseAxesAllButVanishReachFar) {
  const auto box = [](Point3 center, double axis, Vector3 half) {
    return Obb3{center, {Vector3{axis, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, half};
  };
  const auto met = [](const Sphere3& ball, const Obb3& b) {
    EXPECT_EQ(relate(ball, b), Relation::overlapping);
    EXPECT_TRUE(intersects(b, ball));
  };
  met({{0x1.8p-81, 0, 0}, 0x1p-81}, box({0, 0, 0}, 0x1p-1000, {0x1p919, 0, 0}));
  met({{0x1.8p-51, 0, 0}, 0x1p-51}, box({0, 0, 0}, 0x1p-1074, {0x1p1023, 0x1p-30, 0x1p-30}));
  met({{1 + 0x1p-40 + 0x1p-45, 2, 3}, 0x1p-44}, box({1, 2, 3}, 0x1p-1040, {0x1p1000, 0x1p-50, 0x1p-50}));
}

TEST(OverlapRound, AnEndThatOverflowsIsNotLeftOut) {
  const Point3 a{1e76, -1e76, 0}, b{1e300, 2e301, 0}, c{1e76, -1e76, 1e70};
  const Capsule3 ball{{0, 0, 0}, {0, 0, 0}, 1.2e76};
  EXPECT_EQ(relate(Triangle3{a, b, c}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, c, b}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, b, c}, Sphere3{{0, 0, 0}, 1.2e76}), Relation::overlapping);
}

}  // namespace
}  // namespace plumb

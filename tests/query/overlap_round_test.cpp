// Balls, circles, capsules and lozenges against everything that the table has: against brute force over rationals.
#include "plumb/query/overlap_round.hpp"

#include <gtest/gtest.h>

#include "plumb/query/overlap.hpp"
#include "query/round_oracle.hpp"

namespace plumb {
namespace {

TEST(OverlapRound, AllPairsOfSpaceAsBruteForce) { expect_all_round(pair_cases::Space{}, 500, 60); }
TEST(OverlapRound, AllPairsOfThePlaneAsBruteForce) { expect_all_round(pair_cases::Plane{}, 620, 80); }

TEST(OverlapRound, AnEndThatOverflowsIsNotLeftOut) {
  const Point3 a{1e76, -1e76, 0}, b{1e300, 2e301, 0}, c{1e76, -1e76, 1e70};
  const Capsule3 ball{{0, 0, 0}, {0, 0, 0}, 1.2e76};
  EXPECT_EQ(relate(Triangle3{a, b, c}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, c, b}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, b, c}, Sphere3{{0, 0, 0}, 1.2e76}), Relation::overlapping);
}

}  // namespace
}  // namespace plumb

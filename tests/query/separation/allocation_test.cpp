// Do distances of boxes, capsules and balls under rigid poses take memory where doubles decide?
#include <gtest/gtest.h>

#include <cmath>

#include "counted_allocations.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/rotation.hpp"
#include "plumb/query/separation/posed.hpp"

namespace plumb {
namespace {

class Links {
 public:
  explicit Links(std::uint64_t i) : entropy_(17, i) {}
  RigidPose pose(double x) {
    return {rotation({number(), number(), number() + 2}, number()).turn, {x + number() / 8, number() / 8, number()}};
  }
  double number() { return std::ldexp(static_cast<double>(entropy_.within(1 << 20)), -20); }

 private:
  Entropy entropy_;
};

const Capsule3 capsule{{0, 0, 0}, {0, 0, 0.5}, 0.125};
const Aabb3 box{{-0.25, -0.25, 0}, {0.25, 0.25, 0.5}};
const Sphere3 ball{{0, 0, 0.25}, 0.25};

template <class A, class B>
int takers(const A& a, const B& b) {
  int count = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Links links(i);
    const Posed at_a{a, links.pose(0)};
    const Posed at_b{b, links.pose(4)};
    const int before = allocations;
    const double alone = distance(at_a, at_b);
    const Closest c = closest_points(at_a, at_b);
    count += allocations == before ? 0 : 1;
    EXPECT_EQ(c.distance, alone) << i;
    EXPECT_GT(alone, 0) << i;
  }
  return count;
}

TEST(SeparationAllocation, NoneWhereNearestPointsAreInGeneralPosition) {
  EXPECT_EQ(takers(capsule, capsule), 0);
  EXPECT_EQ(takers(capsule, box), 0);
  EXPECT_EQ(takers(box, box), 0);
  EXPECT_EQ(takers(ball, box), 0);
  EXPECT_EQ(takers(ball, capsule), 0);
  EXPECT_EQ(takers(ball, ball), 0);
}

TEST(SeparationAllocation, IsCounted) {
  Links links(0);
  const RigidPose low = links.pose(0), high = links.pose(4);
  const int before = allocations;
  EXPECT_EQ(exact_distance(Posed{box, low}, Posed{box, high}).square.sign(), Sign::positive);
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace plumb

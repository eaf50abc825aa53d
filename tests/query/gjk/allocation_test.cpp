// Does GJK allocate where doubles decide?  Every allocation of this program is counted.
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "counted_allocations.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"

namespace plumb {
namespace {

ConvexPolyhedron3 ball_of(std::size_t vertices, const Vector3& by, Entropy& entropy) {
  std::vector<Point3> points = cloud3(Cloud::sphere, vertices, entropy);
  for (Point3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return convex_polyhedron(convex_hull(points), points);
}

/// How many of `asked` the question allocated for.
template <class Question>
std::size_t allocating(std::size_t asked, Question question) {
  std::size_t some = 0;
  for (std::size_t i = 0; i < asked; ++i) {
    const int before = allocations;
    question(i);
    some += allocations != before ? 1 : 0;
  }
  return some;
}

TEST(GjkAllocations, AreNoneWhereDoublesDecide) {
  { const std::vector<int> one(1); }
  EXPECT_GT(allocations, 0);  // so they are counted
  const std::size_t pairs = battery::sanitized ? 20 : 200;
  for (const std::size_t n : {std::size_t{8}, std::size_t{32}, std::size_t{128}}) {
    Entropy entropy(77, n);
    std::vector<ConvexPolyhedron3> a, b;
    std::size_t meet = 0;
    while (a.size() < pairs) {
      const auto way = [&] { return 1.75 * (static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1); };
      a.push_back(ball_of(n, {0, 0, 0}, entropy));
      b.push_back(ball_of(n, {way(), way(), way()}, entropy));
      meet += gjk_intersects(a.back(), b.back()) ? 1 : 0;
    }
    if (battery::reaches_rare) {
      EXPECT_GT(meet * 4, pairs) << n;
      EXPECT_LT(meet * 4, pairs * 3) << n;
    }
    const auto hull = [](const ConvexPolyhedron3& p) { return VertexHull3{p.mesh.vertices}; };
    GjkCache cache;
    std::size_t sum = 0;
    EXPECT_EQ(allocating(pairs, [&](std::size_t i) { sum += gjk_intersects(a[i], b[i]) ? 1 : 0; }), 0U) << n;
    EXPECT_EQ(allocating(pairs, [&](std::size_t i) { sum += gjk_intersects(hull(a[i]), hull(b[i])) ? 1 : 0; }), 0U)
        << n;
    EXPECT_EQ(allocating(pairs, [&](std::size_t i) { sum += gjk_intersects(a[i], b[i], {.cache = &cache}) ? 1 : 0; }),
              0U)
        << n;
    EXPECT_EQ(sum, 3 * meet) << n;
    double apart = 0;
    EXPECT_EQ(allocating(pairs, [&](std::size_t i) { apart += gjk_distance(a[i], b[i]); }), 0U) << n;
    EXPECT_EQ(allocating(pairs, [&](std::size_t i) { apart += gjk_distance(a[i], b[i], {.cache = &cache}); }), 0U) << n;
    EXPECT_GT(apart, 0) << n;
    EXPECT_EQ(allocating(pairs,
                         [&](std::size_t i) {
                           if (!gjk_intersects(a[i], b[i])) apart += gjk(a[i], b[i]).closest.distance;
                         }),
              0U)
        << n;
  }
}

/// Of whatever is asked, as it stands and under rigid poses.
template <class A, class B>
std::size_t allocating_pair(const A& a, const B& b) {
  const RigidPose stays{{1, 0, 0, 0}, {0.125, 0.25, 0.375}};
  const Posed p{a, stays};
  Posed q{b, stays};  // here, as both copy what they hold
  std::size_t told = 0;
  const std::size_t some = allocating(64, [&](std::size_t i) {
    const double by = static_cast<double>(i) / 16;
    q.pose = {{3, 1, 0.5, 0.25}, {by, by / 2, 0.0625}};
    told += (intersects(a, b) ? 1 : 0) + (relate(a, b) != Relation::disjoint ? 1 : 0) + (gjk_intersects(a, b) ? 1 : 0);
    told += (intersects(p, q) ? 1 : 0) + (relate(p, q) != Relation::disjoint ? 1 : 0) + (gjk_intersects(p, q) ? 1 : 0);
  });
  EXPECT_GT(told, 0U);
  return some;
}
TEST(GjkAllocations, AreNoneOfAnyPairThatDoublesDecide) {
  Entropy entropy(79, 1);
  const ConvexPolyhedron3 solid = ball_of(32, {0, 0, 0}, entropy), other = ball_of(32, {0.5, 0.25, 0.125}, entropy);
  const Capsule3 capsule{{0.75, 0.0625, 0.375}, {1.5, 1.25, 0.25}, 0.25};
  const Lozenge3 lozenge{{0.125, 0.375, 0.25}, {Vector3{1, 0.25, 0}, Vector3{0, 0.5, 1.25}}, 0.125};
  const Sphere3 ball{{0.5, 0.625, 0.25}, 0.5};
  const Tetrahedron3 tetrahedron{{0, 0, 0}, {1, 0.25, 0}, {0, 1.5, 0.125}, {0.25, 0.375, 1.25}};
  EXPECT_EQ(allocating_pair(solid, other), 0U);
  EXPECT_EQ(allocating_pair(capsule, solid), 0U);
  EXPECT_EQ(allocating_pair(lozenge, solid), 0U);
  EXPECT_EQ(allocating_pair(ball, solid), 0U);
  EXPECT_EQ(allocating_pair(tetrahedron, capsule), 0U);
  EXPECT_EQ(allocating_pair(tetrahedron, lozenge), 0U);
  EXPECT_EQ(allocating_pair(tetrahedron, tetrahedron), 0U);
  EXPECT_EQ(allocating_pair(capsule, lozenge), 0U);
}

/// In motion, by a cache that is kept.
TEST(GjkAllocations, AreNoneInMotion) {
  Entropy entropy(78, 1);
  const ConvexPolyhedron3 a = ball_of(32, {0, 0, 0}, entropy), start = ball_of(32, {1.5, 0, 0}, entropy);
  std::vector<ConvexPolyhedron3> frames;
  for (int k = 0; k < 100; ++k) {
    frames.push_back(start);
    for (Point3& p : frames.back().mesh.vertices) p.x += 0.01 * k;
  }
  GjkCache meeting, apart;
  std::size_t meet = 0;
  EXPECT_EQ(allocating(frames.size(),
                       [&](std::size_t i) { meet += gjk_intersects(a, frames[i], {.cache = &meeting}) ? 1 : 0; }),
            0U);
  EXPECT_GT(meet, 10U);
  EXPECT_LT(meet, 90U);
  EXPECT_EQ(allocating(frames.size(), [&](std::size_t i) { (void)gjk_distance(a, frames[i], {.cache = &apart}); }), 0U);
}

}  // namespace
}  // namespace plumb

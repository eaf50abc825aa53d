// Does penetration take memory where doubles decide?  Every allocation of this program is counted, those of GMP as well.
#include <gtest/gtest.h>

#include <cmath>

#include "counted_allocations.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/penetration/penetration.hpp"

namespace plumb {
namespace {

/// In [-1, 1], of 20 bits.
class Numbers {
 public:
  explicit Numbers(std::uint64_t i) : entropy_(81, i) {}
  double operator()() { return std::ldexp(static_cast<double>(entropy_.within(1 << 20)), -20); }
  Vector3 vector() { return {(*this)(), (*this)(), (*this)()}; }
  Point3 point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  Entropy entropy_;
};

/// How often memory was taken; pairs that do not overlap are passed over.
template <class Make>
void expect_none(int pairs, Make make) {
  int deep = 0;
  for (std::uint64_t i = 0; deep < pairs; ++i) {
    Numbers n(i);
    const auto a = make(n), b = make(n);
    if (!penetration(a, b)) continue;
    const int before = allocations;
    const auto p = penetration(a, b);
    EXPECT_EQ(allocations, before) << i;
    deep += p->depth > 0 ? 1 : 0;
    ASSERT_LT(i, 100000U);
  }
}

TEST(PenetrationAllocations, NoneOfBoxes) {
  expect_none(200, [](Numbers& n) { return Obb3{n.point(), {n.vector(), n.vector(), n.vector()}, {1, 2, 1}}; });
  expect_none(200, [](Numbers& n) {
    const Point3 p = n.point();
    return Aabb3{p, {p.x + 1, p.y + 1, p.z + 1}};
  });
}

TEST(PenetrationAllocations, NoneOfAlignedBoxesThatAreAsNearEveryWay) {
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  const Obb3 same{{1, 1, 1}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  const int before = allocations;
  EXPECT_EQ(penetration(box, same)->depth, 2);
  EXPECT_EQ(penetration(box, box)->depth, 2);
  EXPECT_EQ(allocations, before);
}

TEST(PenetrationAllocations, NoneOfTetrahedraAndSmallHulls) {
  expect_none(100, [](Numbers& n) { return Tetrahedron3{n.point(), n.point(), n.point(), n.point()}; });
  std::vector<ConvexPolyhedron3> hulls;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Numbers n(i);
    std::vector<Point3> points;
    for (int k = 0; k < 8; ++k) points.push_back(n.point());
    hulls.push_back(convex_polyhedron(convex_hull(points), points));
  }
  int deep = 0;
  for (std::size_t i = 0; i + 1 < hulls.size(); ++i) {
    if (!penetration(hulls[i], hulls[i + 1])) continue;
    const int before = allocations;
    deep += penetration(hulls[i], hulls[i + 1])->depth > 0 ? 1 : 0;
    EXPECT_EQ(allocations, before) << i;
  }
  EXPECT_GE(deep, 20);
}

TEST(PenetrationAllocations, AreCounted) {
  const int before = allocations;
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  EXPECT_TRUE(exact_penetration(box, box));  // in rational numbers
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace plumb

// Two Dobkin-Kirkpatrick hierarchies against one another: their separation is that of the polyhedra, number for number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certify/sanitized.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/polytope_hierarchy/polytope_hierarchy.hpp"
#include "plumb/query/separation/separation.hpp"
#include "query/polytope_hierarchy/polyhedra.hpp"

namespace plumb {
namespace {

struct Seen {
  int pairs = 0, meet = 0, touch = 0;
};

void expect_separation(const PolytopeHierarchy& a, const PolytopeHierarchy& b, const std::string& name, Seen& seen) {
  const bool meet = gjk_intersects(a.polyhedron, b.polyhedron);
  const Rational square = exact_distance(a.polyhedron, b.polyhedron).square;
  ASSERT_EQ(square.sign() == Sign::zero, meet) << name;
  ASSERT_EQ(intersects(a, b), meet) << name;
  ASSERT_EQ(distance(a, b), gjk_distance(a.polyhedron, b.polyhedron)) << name;
  ASSERT_EQ(squared_distance_exact(a, b), square) << name;
  ++seen.pairs, seen.meet += meet ? 1 : 0;
}

/// So that the least corner along x of one is where the greatest of the other is, but for a gap.
ConvexPolyhedron3 beside(const ConvexPolyhedron3& to, ConvexPolyhedron3 moved, double gap) {
  const auto by_x = [](const Point3& p) { return p.x; };
  const Point3 at = *std::ranges::max_element(to.mesh.vertices, {}, by_x),
               from = *std::ranges::min_element(moved.mesh.vertices, {}, by_x);
  for (Point3& p : moved.mesh.vertices) p = {p.x + (at.x - from.x) + gap, p.y + (at.y - from.y), p.z + (at.z - from.z)};
  return convex_polyhedron(convex_hull(moved.mesh.vertices), moved.mesh.vertices);
}

TEST(HierarchiesOfTwo, AreAsFarApartAsTheirPolyhedra) {
  const std::size_t large = battery::sanitized ? 40 : 150;
  Seen seen;
  std::vector<PolytopeHierarchy> all;
  for (const std::size_t n : {std::size_t{5}, std::size_t{30}, large}) {
    for (hierarchy_cases::NamedPolyhedron& p : hierarchy_cases::polyhedra_of(n, 27))
      all.push_back(build_polytope_hierarchy(std::move(p.polyhedron)));
  }
  Entropy entropy(28, 1);
  const int pairs = battery::sanitized ? 40 : 400;
  for (int k = 0; k < pairs; ++k) {
    const PolytopeHierarchy &a = all[entropy.below(all.size())], &other = all[entropy.below(all.size())];
    const double gap = entropy.below(3) == 0 ? 0 : std::ldexp(1.0, static_cast<int>(entropy.below(12)) - 6);
    const ConvexPolyhedron3 moved = beside(a.polyhedron, other.polyhedron, entropy.below(4) == 0 ? -gap : gap);
    const PolytopeHierarchy b = build_polytope_hierarchy(moved);
    const std::string name = "pair " + std::to_string(k);
    ASSERT_NO_FATAL_FAILURE(expect_separation(a, b, name, seen));
    ASSERT_NO_FATAL_FAILURE(expect_separation(b, a, name + ", turned round", seen));
    seen.touch += gap == 0 ? 1 : 0;
  }
  std::printf("%d pairs, %d meet; %d are moved to one corner\n", seen.pairs, seen.meet, seen.touch);
  EXPECT_GT(seen.meet * 10, seen.pairs);
  EXPECT_LT(seen.meet * 4, seen.pairs * 3);
  EXPECT_GT(seen.touch * 10, pairs);
}

/// Numbers that take more bits than the stack holds are left to the search.
TEST(HierarchiesOfTwo, OfFarExponents) {
  Entropy entropy(29, 1);
  std::vector<Point3> points = cloud3(Cloud::sphere, 30, entropy);
  const PolytopeHierarchy a = build_polytope_hierarchy(convex_polyhedron(convex_hull(points), points));
  for (const int exponent : {-300, -60, 60, 300}) {
    std::vector<Point3> scaled = points;
    for (Point3& p : scaled)
      p = {std::ldexp(p.x, exponent) + 3, std::ldexp(p.y, exponent) * 0.5, std::ldexp(p.z, exponent)};
    const Hull3 hull = convex_hull(scaled);
    if (hull.dimension < 3) continue;
    Seen seen;
    const PolytopeHierarchy b = build_polytope_hierarchy(convex_polyhedron(hull, scaled));
    ASSERT_NO_FATAL_FAILURE(expect_separation(a, b, std::to_string(exponent), seen));
  }
}

}  // namespace
}  // namespace plumb

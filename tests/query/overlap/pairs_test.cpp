// Every pair of figures with straight edges in space, against brute force in rationals, both ways round; and all that
// CGAL has.
#include <cmath>

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/overlap/all_pairs.hpp"

namespace plumb::pair_cases {
namespace {

TEST(OverlapPairs, AllFlatFiguresOfSpaceAsBruteForce) { expect_all_as_oracle(Space{}, 501); }
TEST(OverlapPairs, AllThatCgalHasOfSpace) { expect_all_as_cgal(Space{}, 1501); }

/// The hull of points of a small lattice; of one without inside, that of a corner of it besides.
ConvexPolyhedron3 lattice_hull(Material& m) {
  const auto number = [&m] { return static_cast<double>(m.below(9)) - 4; };
  std::vector<Point3> points;
  for (std::uint64_t n = 4 + m.below(8); n > 0; --n) points.push_back({number(), number(), number()});
  Hull3 hull = convex_hull(points);
  if (hull.dimension < 3) {
    points.insert(points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    hull = convex_hull(points);
  }
  return convex_polyhedron(hull, points);
}

/// Every coordinate times a power of two, and moved before.
void place(ConvexPolyhedron3& p, const Vector3& by, int e) {
  const auto scaled = [e](double x) { return std::ldexp(x, e); };
  for (Point3& v : p.mesh.vertices) v = {scaled(v.x + by.x), scaled(v.y + by.y), scaled(v.z + by.z)};
}

// Farthest points that way and back are put upon one another, so that most of them touch there.
TEST(OverlapPairs, PolyhedraThatTouchAsBruteForce) {
  Answers answers;
  const int cases = battery::sanitized ? 15 : 60;
  shape_cases::on_shapes(503, cases, [&](Material& m) {
    ConvexPolyhedron3 a = lattice_hull(m), b = lattice_hull(m);
    const Vector3 way{static_cast<double>(m.below(7)) - 3, static_cast<double>(m.below(7)) - 3, 1};
    const auto height = [&](const Point3& p) { return p.x * way.x + p.y * way.y + p.z * way.z; };
    const auto used = [&](const ConvexPolyhedron3& p) {
      std::vector<Point3> corners;
      for (const std::uint32_t c : p.mesh.corners) corners.push_back(p.mesh.vertices[c]);
      return corners;
    };
    const Point3 top = std::ranges::max(used(a), {}, height), bottom = std::ranges::min(used(b), {}, height);
    const int e = static_cast<int>(m.below(5)) * 490 - 980;
    place(b, {top.x - bottom.x, top.y - bottom.y, top.z - bottom.z + (m.below(4) == 0 ? 1 : 0)}, e);
    place(a, {0, 0, 0}, e);
    const Relation expected = oracle::relation(oracle::cells(a), oracle::cells(b));
    answers.add(expected);
    EXPECT_EQ(relate(a, b), expected) << m.about(a, b);
    EXPECT_EQ(relate(b, a), expected) << m.about(b, a);
    const KDop3 around_b = fit_k_dop(used(b), 14);
    const Relation of_k_dop = oracle::relation(oracle::cells(a), oracle::cells(around_b));
    EXPECT_EQ(relate(a, around_b), of_k_dop) << m.about(a, around_b);
    EXPECT_EQ(relate(around_b, a), of_k_dop) << m.about(a, around_b);
  });
  EXPECT_GT(answers.of(Relation::touching), cases / 3);
  EXPECT_GT(answers.of(Relation::disjoint), cases / 20);
}

}  // namespace
}  // namespace plumb::pair_cases

// How do planes meet, where is a point in a convex polygon, and do tests on a lattice say what the general ones say?
#include "plumb/query/section/planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "oracle/intersections.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/convex/location.hpp"
#include "plumb/query/overlap/lattice2.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;
using enum PlaneArrangement;

Point3 at(const FlatIntersection& flat) { return approximate(*flat.point); }

TEST(Planes, TwoPlanes) {
  const FlatIntersection line = intersection(Plane3{{1, 0, 0}, 1}, Plane3{{0, 2, 0}, 4});
  ASSERT_EQ(line.kind, FlatKind::line);
  EXPECT_EQ(at(line), (Point3{1, 2, 0}));
  EXPECT_EQ(approximate(line.directions[0]), (Vector3{0, 0, 1}));
  EXPECT_EQ(intersection(Plane3{{1, 2, 3}, 1}, Plane3{{2, 4, 6}, 2}).kind, FlatKind::plane);
  EXPECT_EQ(intersection(Plane3{{1, 2, 3}, 1}, Plane3{{2, 4, 6}, 3}).kind, FlatKind::nothing);
  EXPECT_EQ(intersection(Plane3{{1, 2, 3}, 6}, ThreePointPlane3{{6, 0, 0}, {0, 3, 0}, {0, 0, 2}}).kind,
            FlatKind::plane);
  EXPECT_EQ(intersection(Plane3{{0, 0, 0}, 0}, Plane3{{0, 0, 0}, 0}).kind, FlatKind::space);
  EXPECT_EQ(intersection(Plane3{{0, 0, 0}, 1}, Plane3{{0, 0, 1}, 0}).kind, FlatKind::nothing);
  // Three points on a line, or at one place.
  EXPECT_EQ(at(intersection(ThreePointPlane3{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, Plane3{{0, 0, 1}, 2})),
            (Point3{2, 2, 2}));
  EXPECT_EQ(intersection(ThreePointPlane3{{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}, Plane3{{0, 0, 1}, 2}).kind,
            FlatKind::point);
  // All but parallel.
  EXPECT_EQ(intersection(Plane3{{0.1, 0.3, 0}, 1}, Plane3{{0.2, 0.6, 0x1p-1074}, 3}).kind, FlatKind::line);
}

TEST(Planes, Figure531TheFiveArrangements) {
  const Plane3 x{{1, 0, 0}, 0}, y{{0, 1, 0}, 0}, z{{0, 0, 1}, 5};
  struct Case {
    AnyPlane3 a, b, c;
    PlaneArrangement arrangement;
    int distinct;
    FlatKind kind;
  };
  const std::vector<Case> cases{
      {x, y, z, point, 3, FlatKind::point},
      {x, y, Plane3{{1, 1, 0}, 0}, line, 3, FlatKind::line},
      {x, y, Plane3{{-3, 0, 0}, 0}, line, 2, FlatKind::line},
      {x, y, Plane3{{1, 1, 0}, 1}, prism, 3, FlatKind::nothing},
      {x, Plane3{{2, 0, 0}, 1}, y, two_parallel, 3, FlatKind::nothing},
      {x, Plane3{{2, 0, 0}, 1}, Plane3{{-1, 0, 0}, 4}, parallel, 3, FlatKind::nothing},
      {x, Plane3{{2, 0, 0}, 1}, Plane3{{-1, 0, 0}, 0}, parallel, 2, FlatKind::nothing},
      {x, Plane3{{2, 0, 0}, 0}, Plane3{{-1, 0, 0}, 0}, parallel, 1, FlatKind::plane},
      {x, y, Plane3{{0, 0, 0}, 0}, degenerate, 3, FlatKind::line},
      {x, ThreePointPlane3{{1, 1, 1}, {2, 1, 1}, {3, 1, 1}}, z, degenerate, 3, FlatKind::nothing},
  };
  for (const Case& c : cases) {
    const std::array planes{c.a, c.b, c.c};
    for (const auto& order :
         {std::array{0u, 1u, 2u}, {1u, 2u, 0u}, {2u, 0u, 1u}, {1u, 0u, 2u}, {0u, 2u, 1u}, {2u, 1u, 0u}}) {
      const ThreePlanes told = intersection(planes[order[0]], planes[order[1]], planes[order[2]]);
      EXPECT_EQ(told.arrangement, c.arrangement);
      EXPECT_TRUE(c.arrangement == degenerate || told.distinct == c.distinct);
      EXPECT_EQ(told.common.kind, c.kind);
    }
  }
  EXPECT_EQ(at(intersection(x, y, z).common), (Point3{0, 0, 5}));
  const ThreePointPlane3 p{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, q{{0, 2, 0}, {1, 2, 0}, {0, 2, 1}},
      r{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}};
  const ThreePlanes corner = intersection(p, q, r);
  ASSERT_TRUE(std::holds_alternative<ThreePlanePoint3>(corner.common.point->as()));
  EXPECT_EQ(at(corner.common), (Point3{1, 2, 3}));
}

TEST(Planes, AgreeWithCgalAndTheirEquations) {
  std::array<int, 6> arrangements{};
  on_shapes(141, 1500, [&](Material& m) {
    const auto a = m.shape<Plane3>(), b = m.shape<Plane3>(), c = m.shape<Plane3>();
    const ThreePlanes told = intersection(a, b, c);
    ++arrangements[static_cast<std::size_t>(told.arrangement)];
    if (told.common.point) {  // on all three, and so is where the directions lead
      std::vector<RationalPoint3> on{rational_point(*told.common.point)};
      for (const ExactVector3& d : told.common.directions) on.push_back({on[0].x + d.x, on[0].y + d.y, on[0].z + d.z});
      for (const RationalPoint3& p : on) {
        for (const Plane3& plane : {a, b, c})
          EXPECT_EQ(p.x * plane.normal.x + p.y * plane.normal.y + p.z * plane.normal.z, Rational(plane.offset))
              << m.about(a, b, c);
      }
    }
    const oracle::CommonVertices cgal = oracle::common_vertices(a, b, c);
    if (!cgal || told.arrangement == degenerate) return;
    EXPECT_EQ(cgal->empty(), told.common.kind == FlatKind::nothing) << m.about(a, b, c);
    if (told.common.kind == FlatKind::point && cgal->size() == 1) {
      const RationalPoint3 p = rational_point(*told.common.point);
      EXPECT_EQ((std::vector{p.x.text(), p.y.text(), p.z.text()}), (*cgal)[0]) << m.about(a, b, c);
    }
  });
  for (const int n : arrangements) EXPECT_GE(n, 5);
}

TEST(ConvexLocation, SaysWhatLocateSays) {
  std::array<int, 3> answers{};
  on_shapes(142, 1500, [&](Material& m) {
    const Polygon2 drawn = m.shape<Polygon2>();
    Polygon2 convex;
    for (const std::uint32_t i : convex_hull(drawn.vertices, {.all_boundary_points = m.below(2) == 0}).vertices) {
      for (std::size_t times = m.below(4) == 0 ? 3 : 1; times-- > 0;) convex.vertices.push_back(drawn.vertices[i]);
    }
    while (convex.vertices.size() < 3) convex.vertices.push_back(convex.vertices.back());
    auto& v = convex.vertices;
    std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(m.below(v.size())), v.end());
    if (m.below(2) == 0) std::ranges::reverse(convex.vertices);
    const ConvexLocator2 locator(convex);
    for (int probe = 0; probe < 6; ++probe) {
      const Point2 p = m.probe2();
      const Location expected = locate(convex, p);
      ++answers[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      EXPECT_EQ(locator.locate(p), expected) << m.about(p) << " probe " << probe;
    }
    for (const Point2& p : v) EXPECT_EQ(locator.locate(p), Location::boundary) << m.about(p);
  });
  for (const int n : answers) EXPECT_GE(n, 300);
}

TEST(ConvexLocation, Figure528AndWhatIsRefused) {
  const Polygon2 octagon{{{2, 0}, {4, 0}, {6, 2}, {6, 4}, {4, 6}, {2, 6}, {0, 4}, {0, 2}}};
  const ConvexLocator2 locator(octagon);
  EXPECT_EQ(locator.locate({3, 3}), Location::inside);
  EXPECT_EQ(locator.locate({5, 1}), Location::boundary);
  EXPECT_EQ(locator.locate({5.5, 1}), Location::outside);
  EXPECT_EQ(locator.locate({0, 3}), Location::boundary);
  EXPECT_EQ(locator.locate({6, 1.5}), Location::outside);
  EXPECT_EQ(locator.locate({6, 3}), Location::boundary);
  EXPECT_EQ(locator.locate({0, 5}), Location::outside);
  EXPECT_EQ(locator.corners().size(), 8u);
  EXPECT_TRUE(locator.contains({2, 0}));
  EXPECT_EQ(ConvexLocator2(Polygon2{{{1, 1}, {1, 1}, {1, 1}}}).corners().size(), 1u);
  EXPECT_THROW(ConvexLocator2(Polygon2{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}), InvalidShape);
  EXPECT_THROW(ConvexLocator2(Polygon2{{{0, 0}, {4, 0}}}), InvalidShape);
  EXPECT_THROW((void)locator.locate({NAN, 0}), NonFinite);
}

/// Points of small integers of so many bits, times a power of two; few of them, so that many coincide or line up.
std::vector<Point2> lattice_points(Entropy& e, int bits, int exponent) {
  std::vector<Point2> points;
  const auto large = [&] { return std::ldexp(grid_coordinate(e, bits), exponent); };
  const Point2 far{large(), large()};
  for (int i = 0; i < 6; ++i) {
    const auto near = [&](double x) {
      const double y = x + std::ldexp(static_cast<double>(e.within(2)), exponent);
      return std::fabs(y) < std::ldexp(1, bits + exponent) ? y : x;
    };
    if (e.coin()) {
      points.push_back({near(far.x), near(far.y)});
    } else {
      points.push_back({large(), large()});
    }
  }
  for (int i = 0; i < 3; ++i) points.push_back(points[e.below(6)]);
  return points;
}

TEST(LatticeTests, SayWhatTheGeneralOnesSay) {
  std::array<int, 3> relations{}, places{};
  for (std::uint64_t index = 0; index < 2000 * shape_cases::more; ++index) {
    Entropy e(143, index);
    constexpr std::array sizes{3, 12, 25, 26, 40, 51, 52, 53, 62, 70};
    const int bits = sizes[e.below(sizes.size())], exponent = static_cast<int>(e.within(60));
    const std::vector<Point2> given = lattice_points(e, bits < 53 ? bits : 53, exponent + (bits > 53 ? bits - 53 : 0));
    const Kernel kernel(plan(Lattice{exponent, bits}));
    const auto p = kernel.points(given);
    const LatticeTests2 tests(kernel);
    std::vector<LatticeSegment2> all;
    std::vector<Segment2> all_given;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      all.push_back({p[i], p[i + 1]});
      all_given.push_back({given[i], given[i + 1]});
    }
    for (std::size_t i = 0; i + 3 < p.size(); ++i) {
      const Relation told = tests.relate({p[i], p[i + 1]}, {p[i + 2], p[i + 3]});
      const Relation expected = relate(Segment2{given[i], given[i + 1]}, Segment2{given[i + 2], given[i + 3]});
      ++relations[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
      EXPECT_EQ(told, expected) << "start 143 index " << index << " from " << i;
      EXPECT_EQ(tests.intersects({p[i], p[i + 1]}, {p[i + 2], p[i + 3]}), expected != Relation::disjoint);
      const Location place = locate(Triangle2{given[i], given[i + 1], given[i + 2]}, given[i + 3]);
      ++places[static_cast<std::size_t>(static_cast<int>(place) + 1)];
      EXPECT_EQ(tests.locate(LatticeTriangle2{p[i], p[i + 1], p[i + 2]}, p[i + 3]), place) << "index " << index;
      EXPECT_EQ(tests.locate(LatticeSegment2{p[i], p[i + 1]}, p[i + 2]),
                locate(Segment2{given[i], given[i + 1]}, given[i + 2]))
          << "start 143 index " << index;
    }
    const Polygon2 polygon{{given.begin(), given.begin() + 6}};
    std::vector<Location> in(p.size());
    tests.locate(std::span(p).first(6), p, in);
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_EQ(in[i], locate(polygon, given[i])) << "start 143 index " << index << " point " << i;
      EXPECT_EQ(tests.locate(std::span(p).first(6), p[i]), in[i]);
    }
    std::vector<Relation> relation(all.size());
    const std::vector<LatticeSegment2> first(all.size(), all[0]);
    tests.relate(first, all, relation);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(relation[i], relate(all_given[0], all_given[i]));
  }
  for (const int n : relations) EXPECT_GE(n, 1000);
  for (const int n : places) EXPECT_GE(n, 500);
}

TEST(LatticeTests, WrongInputThrows) {
  const Kernel kernel(plan(Lattice{0, 20})), other(plan(Lattice{-1, 20}));
  const LatticeTests2 tests(kernel);
  EXPECT_THROW((void)kernel.point(Point2{0.5, 1}), OffLattice);
  EXPECT_THROW((void)kernel.point(Point2{NAN, 1}), NonFinite);
  const auto a = kernel.point(Point2{0, 0}), b = kernel.point(Point2{8, 0}), c = kernel.point(Point2{0, 8});
  const auto wrong = other.point(Point2{1, 1});
  EXPECT_THROW((void)tests.relate({a, b}, {c, wrong}), OffLattice);
  EXPECT_THROW((void)tests.locate(LatticeSegment2{a, b}, wrong), OffLattice);
  EXPECT_THROW((void)tests.locate(LatticeTriangle2{a, b, c}, wrong), OffLattice);
  const std::array polygon{a, b, c}, mixed{a, b, wrong};
  EXPECT_THROW((void)tests.locate(polygon, wrong), OffLattice);
  EXPECT_THROW((void)tests.locate(mixed, a), OffLattice);
  EXPECT_THROW((void)tests.locate(std::span(polygon).first(2), a), InvalidShape);
  EXPECT_EQ(tests.locate(polygon, kernel.point(Point2{1, 1})), Location::inside);
  std::vector<Location> out(2);
  EXPECT_THROW(tests.locate(polygon, polygon, out), UnequalLengths);
}

}  // namespace
}  // namespace plumb

// Polygons with holes: areas by rational numbers, every vertex kept, windings by the rule, any plane of space.
#include "plumb/surface/planar/triangulate_polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "certify/sanitized.hpp"
#include "surface/planar/triangulation_laws.hpp"

namespace plumb {
namespace {

using planar_laws::as_set, planar_laws::twice_area;

Polygon2 square(double from, double to, bool turned = false) {
  if (turned) return {{{from, from}, {from, to}, {to, to}, {to, from}}};
  return {{{from, from}, {to, from}, {to, to}, {from, to}}};
}

Rational area(const HoledPolygon2& polygon, WindingRule rule) {
  std::vector<Point2> points = polygon.outer.vertices;
  for (const Polygon2& hole : polygon.holes) points.insert(points.end(), hole.vertices.begin(), hole.vertices.end());
  return twice_area(points, triangulate(polygon, rule));
}

TEST(TriangulatePolygon, RulesSayWhatIsInside) {
  const HoledPolygon2 nested{square(0, 8), {square(1, 7), square(2, 6, true), square(3, 5, true)}};
  EXPECT_EQ(area(nested, WindingRule::odd), Rational(2 * (64 - 36 + 16 - 4)));
  EXPECT_EQ(area(nested, WindingRule::nonzero), Rational(2 * (64 - 4)));
  EXPECT_EQ(area(nested, WindingRule::positive), Rational(2 * (64 - 4)));
  const HoledPolygon2 backward{square(0, 8, true), {square(1, 7, true), square(2, 6)}};
  EXPECT_EQ(area(backward, WindingRule::nonzero), Rational(2 * 64));
  EXPECT_EQ(area(backward, WindingRule::positive), Rational(0));
}

TEST(TriangulatePolygon, TouchingRingsAndRepeatedEdges) {
  const HoledPolygon2 corner{square(0, 4), {{{{0, 0}, {2, 1}, {1, 2}}}, {{{4, 2}, {3, 3}, {3, 1}}}}};
  EXPECT_EQ(area(corner, WindingRule::odd), Rational(2 * 16 - 3 - 2));
  const HoledPolygon2 shared{square(0, 4), {square(0, 2), square(2, 4)}};
  EXPECT_EQ(area(shared, WindingRule::odd), Rational(2 * 8));
  const HoledPolygon2 twice{square(0, 4), {square(0, 4)}};
  EXPECT_TRUE(triangulate(twice).empty());
  EXPECT_EQ(area(twice, WindingRule::nonzero), Rational(32));
}

TEST(TriangulatePolygon, KeepsVerticesOnStraightEdges) {
  const Polygon2 polygon{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 1}}};
  const CornerTriangles triangles = triangulate(polygon);
  EXPECT_EQ(triangles.size(), polygon.vertices.size() - 2);
  std::set<std::uint32_t> corners;
  for (const auto& t : triangles) corners.insert(t.begin(), t.end());
  EXPECT_EQ(corners.size(), polygon.vertices.size());
}

// The winding number of a path about the middle of a triangle, edge by edge, in rational numbers.
int winding(const std::vector<Point2>& path, const Rational& x, const Rational& y) {
  int around = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point2 &a = path[i], &b = path[(i + 1) % path.size()];
    const bool up = Rational(a.y) <= y && y < Rational(b.y), down = Rational(b.y) <= y && y < Rational(a.y);
    if (!up && !down) continue;
    const Rational side =
        (Rational(b.x) - Rational(a.x)) * (y - Rational(a.y)) - (x - Rational(a.x)) * (Rational(b.y) - Rational(a.y));
    if (up && side.sign() == Sign::positive) ++around;
    if (down && side.sign() == Sign::negative) --around;
  }
  return around;
}

// Closed paths of a small lattice, those that do not cross themselves between points, under every rule.
TEST(TriangulatePolygon, AnyPathOfALattice) {
  std::size_t cut = 0, refused = 0;
  for (std::uint64_t round = 0; round < battery::fitting(8000U); ++round) {
    SCOPED_TRACE("Entropy(45, " + std::to_string(round) + ")");
    Entropy entropy(45, round);
    const std::uint64_t edge = 2 + entropy.below(4);
    Polygon2 polygon;
    polygon.vertices.resize(3 + entropy.below(12));
    for (Point2& p : polygon.vertices)
      p = {static_cast<double>(entropy.below(edge)), static_cast<double>(entropy.below(edge))};
    const auto& path = polygon.vertices;
    try {
      std::vector<PlanarSegment> edges;
      for (std::uint32_t i = 0; i < path.size(); ++i) edges.push_back({i, i + 1 == path.size() ? 0 : i + 1});
      const PlanarTriangulation all = delaunay(path, edges);
      for (const WindingRule rule : {WindingRule::odd, WindingRule::nonzero, WindingRule::positive}) {
        std::set<planar_laws::Corners> expected;
        for (const auto& t : all.triangles) {
          const auto middle = [&](double Point2::*axis) {
            return (Rational(path[t[0]].*axis) + Rational(path[t[1]].*axis) + Rational(path[t[2]].*axis)) *
                   Rational(1, 3);
          };
          const int w = winding(path, middle(&Point2::x), middle(&Point2::y));
          if (rule == WindingRule::odd ? w % 2 != 0 : rule == WindingRule::nonzero ? w != 0 : w > 0)
            expected.insert(planar_laws::turned(t));
        }
        EXPECT_EQ(as_set(triangulate(polygon, rule)), expected);
      }
      ++cut;
    } catch (const CrossingSegments&) {
      ++refused;
      EXPECT_THROW((void)triangulate(polygon), CrossingSegments);
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(cut, battery::fitting(1000U));
  EXPECT_GT(refused, battery::fitting(1000U));
}

TEST(TriangulatePolygon, InAnyPlaneOfSpaceItKeepsItsSide) {
  const HoledPolygon2 flat{{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}},
                           {{{{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}}}}};
  const auto lifted = [](const Polygon2& ring, int axis) {
    Polygon3 lift;
    for (const auto& [u, v] : ring.vertices) {
      const double w = axis < 3 ? 0 : u * 0.5 - v * 0.25;
      lift.vertices.push_back(axis % 3 == 0 ? Point3{w, u, v} : axis % 3 == 1 ? Point3{v, w, u} : Point3{u, v, w});
    }
    return lift;
  };
  for (int axis = 0; axis < 6; ++axis) {
    for (const bool turned : {false, true}) {
      HoledPolygon2 seen = flat;
      if (turned) std::reverse(seen.outer.vertices.begin(), seen.outer.vertices.end());
      const HoledPolygon3 polygon{lifted(seen.outer, axis), {lifted(seen.holes[0], axis)}};
      const CornerTriangles triangles = triangulate(polygon);
      EXPECT_EQ(triangles.size(), 9U);
      std::vector<Point2> points = seen.outer.vertices;
      points.insert(points.end(), seen.holes[0].vertices.begin(), seen.holes[0].vertices.end());
      const Rational whole = Rational(14) - Rational(0.0625);
      EXPECT_EQ(twice_area(points, triangles), turned ? -whole : whole) << axis;
    }
  }
}

TEST(TriangulatePolygon, RefusesWhatIsNoPolygon) {
  EXPECT_THROW((void)triangulate(Polygon2{{{0, 0}, {1, 1}}}), InvalidShape);
  EXPECT_THROW((void)triangulate(HoledPolygon2{square(0, 1), {{{{0, 0}}}}}), InvalidShape);
  EXPECT_THROW((void)triangulate(Polygon3{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}}), InvalidShape);
  EXPECT_THROW((void)triangulate(Polygon2{{{0, 0}, {1, 1}, {1, std::numeric_limits<double>::infinity()}}}), NonFinite);
  EXPECT_THROW((void)triangulate(Polygon2{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}), CrossingSegments);
  EXPECT_TRUE(triangulate(Polygon2{{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}).empty());
  EXPECT_TRUE(triangulate(Polygon3{{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}).empty());
}

Rational exact_area(const ExactTriangles& made) {
  Rational sum = 0;
  for (const auto& [a, b, c] : made.triangles) {
    const auto p = rational_point(made.vertices[a]), q = rational_point(made.vertices[b]),
               r = rational_point(made.vertices[c]);
    const Rational area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    EXPECT_EQ(area.sign(), Sign::positive);
    sum = sum + area;
  }
  return sum;
}

TEST(TriangulatePolygon, CrossingsAreDividedWhereThatIsAsked) {
  const Polygon2 bow{{{0, 0}, {3, 3}, {3, 0}, {0, 1}}};
  // Crossing at (3/4, 3/4): a triangle of twice the area 3/4 and one of 27/4, which are wound around differently.
  EXPECT_EQ(exact_area(triangulate_with_crossings(bow)), Rational(30, 4));
  EXPECT_EQ(exact_area(triangulate_with_crossings(bow, WindingRule::positive)), Rational(3, 4));
  for (std::uint64_t round = 0; round < battery::fitting(300U); ++round) {
    SCOPED_TRACE("Entropy(47, " + std::to_string(round) + ")");
    Entropy entropy(47, round);
    Polygon2 polygon;
    polygon.vertices.resize(3 + entropy.below(7));
    for (Point2& p : polygon.vertices)
      p = {static_cast<double>(entropy.below(6)), static_cast<double>(entropy.below(6))};
    // The nonzero rule covers what the positive one does of the path and of its reverse.
    Polygon2 reversed{{polygon.vertices.rbegin(), polygon.vertices.rend()}};
    EXPECT_EQ(exact_area(triangulate_with_crossings(polygon, WindingRule::nonzero)),
              exact_area(triangulate_with_crossings(polygon, WindingRule::positive)) +
                  exact_area(triangulate_with_crossings(reversed, WindingRule::positive)));
    try {
      for (const WindingRule rule : {WindingRule::odd, WindingRule::nonzero, WindingRule::positive})
        EXPECT_EQ(exact_area(triangulate_with_crossings(polygon, rule)),
                  twice_area(polygon.vertices, triangulate(polygon, rule)));
    } catch (const CrossingSegments&) {
    }
  }
}

TEST(TriangulatePolygon, StarsOfManyRays) {
  Polygon2 star;
  Entropy entropy(46);
  for (int k = 0; k < 3000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3000;
    const double r = 0.01 + 0.001 * static_cast<double>(entropy.below(990));
    star.vertices.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const CornerTriangles triangles = triangulate(star);
  EXPECT_EQ(triangles.size(), star.vertices.size() - 2);
  Rational whole = 0;
  for (std::size_t k = 1; k + 1 < star.vertices.size(); ++k)
    whole = whole + twice_area(star.vertices[0], star.vertices[k], star.vertices[k + 1]);
  EXPECT_EQ(twice_area(star.vertices, triangles), whole);
}

}  // namespace
}  // namespace plumb

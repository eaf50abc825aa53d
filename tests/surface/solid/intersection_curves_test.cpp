// Curves in which surfaces meet, and sheets in arrangements: by definition, in rationals.
#include "plumb/surface/solid/intersection_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "figure/basic/solids.hpp"
#include "plumb/query/section/intersection.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solids::box, solids::heap;

Rational twice_middle(const Rational& a, const Rational& b) { return (a + b) * Rational(1, 2); }

/// Is the point on the triangle?  By areas in rationals.
bool is_on(const RationalPoint3& p, const std::array<Point3, 3>& t) {
  if (orient3d(ExactPoint3(t[0]), ExactPoint3(t[1]), ExactPoint3(t[2]), ExactPoint3(p)) != Sign::zero) return false;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Sign, 3> turns{};
    for (std::size_t k = 0; k < 3; ++k)
      turns[k] = certify::turn_along(axis, ExactPoint3(t[k]), ExactPoint3(t[(k + 1) % 3]), ExactPoint3(p));
    if (std::ranges::count(turns, Sign::positive) > 0 && std::ranges::count(turns, Sign::negative) > 0) return false;
  }
  return true;
}
std::array<Point3, 3> points_of(const TriangleMesh& mesh, std::uint32_t t) {
  return {mesh.vertices[mesh.triangles[t][0]], mesh.vertices[mesh.triangles[t][1]],
          mesh.vertices[mesh.triangles[t][2]]};
}

std::size_t edges_of(const IntersectionCurve& c) { return c.points.size() - (c.closed ? 0 : 1); }

/// Edges and points lie in the triangles that they name, and the order is the one that the header says.
void expect_curves(const TriangleMesh& a, const TriangleMesh& b, const std::vector<IntersectionCurve>& curves) {
  for (const IntersectionCurve& c : curves) {
    ASSERT_EQ(c.faces.size(), c.points.size() == 1 ? 1 : edges_of(c));
    for (std::size_t i = 0; i < c.faces.size(); ++i) {
      const RationalPoint3 p = rational_point(c.points[i]), q = rational_point(c.points[(i + 1) % c.points.size()]);
      const RationalPoint3 middle{twice_middle(p.x, q.x), twice_middle(p.y, q.y), twice_middle(p.z, q.z)};
      for (const RationalPoint3& on : {p, middle, q}) {
        EXPECT_TRUE(is_on(on, points_of(a, c.faces[i][0])));
        EXPECT_TRUE(is_on(on, points_of(b, c.faces[i][1])));
      }
    }
    if (!c.closed && c.points.size() > 1) EXPECT_EQ(compare_xyz(c.points.front(), c.points.back()), Sign::negative);
  }
  EXPECT_TRUE(std::ranges::is_sorted(curves, [](const IntersectionCurve& l, const IntersectionCurve& r) {
    return std::ranges::lexicographical_compare(l.points, r.points);
  }));
}

std::vector<IntersectionCurve> checked_curves(const TriangleMesh& a, const TriangleMesh& b) {
  std::vector<IntersectionCurve> curves = intersection_curves(a, b), turned = intersection_curves(b, a);
  expect_curves(a, b, curves);
  EXPECT_EQ(curves.size(), turned.size());
  for (std::size_t i = 0; i < std::min(curves.size(), turned.size()); ++i) {
    EXPECT_TRUE(curves[i].points == turned[i].points);
    EXPECT_EQ(curves[i].closed, turned[i].closed);
    for (std::size_t k = 0; k < curves[i].faces.size(); ++k) {
      EXPECT_EQ(curves[i].faces[k][0], turned[i].faces[k][1]);
      EXPECT_EQ(curves[i].faces[k][1], turned[i].faces[k][0]);
    }
  }
  return curves;
}

TEST(IntersectionCurves, ABoxThroughAWall) {
  const TriangleMesh wall{{{0, -9, -9}, {0, 9, -9}, {0, 0, 18}}, {{0, 1, 2}}};
  const auto curves = checked_curves(box({-1, -1, -1}, {1, 1, 1}), wall);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(curves[0].points.size(), 8U);  // four corners, and where the diagonals of four sides are passed
  EXPECT_TRUE(curves[0].points[0] == ExactPoint3(Point3{0, -1, -1}));
}

TEST(IntersectionCurves, AnOpenOneEndsWhereASheetDoes) {
  const TriangleMesh sheet{{{0, 0, -1}, {0, 0, 1}, {0, 5, 0}}, {{0, 1, 2}}};
  const TriangleMesh floor{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
  const auto curves = checked_curves(sheet, floor);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_TRUE(curves[0].points.front() == ExactPoint3(Point3{0, 0, 0}));
  EXPECT_TRUE(curves[0].points.back() == ExactPoint3(Point3{0, 5, 0}));
  EXPECT_EQ(curves[0].points.size(), 2U);
}

TEST(IntersectionCurves, APointWhereTheyTouch) {
  const TriangleMesh tip{{{0.5, 0.25, 1}, {0, 0, 2}, {1, 0, 2}, {0.5, 1, 2}},
                         {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  const auto curves = checked_curves(box({0, 0, 0}, {1, 1, 1}), tip);
  ASSERT_EQ(curves.size(), 1U);
  ASSERT_EQ(curves[0].points.size(), 1U);
  EXPECT_TRUE(curves[0].points[0] == ExactPoint3(Point3{0.5, 0.25, 1}));
  EXPECT_TRUE(intersection_curves(box({0, 0, 0}, {1, 1, 1}), box({2, 2, 2}, {3, 3, 3})).empty());
}

TEST(IntersectionCurves, FacesInOnePlaneAreBounded) {
  // Boxes face to face, one moved: what the two faces have in common is a rectangle.
  const auto curves = checked_curves(box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, 0.5}, {2, 1.25, 1.5}));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  for (const ExactPoint3& p : curves[0].points) {
    EXPECT_EQ(rational_point(p).x, Rational(1));
    EXPECT_GE(rational_point(p).y, Rational(1, 4));
  }
  const TriangleMesh a = box({0, 0, 0}, {1, 2, 3});
  EXPECT_TRUE(intersection_curves(a, a).empty());  // all of it is common, and closed
}

TEST(IntersectionCurves, CurvesThatCrossEndWhereTheyDo) {
  // Two walls of a cross against a floor: four arms and a crossing.
  TriangleMesh cross{{{-2, 0, -1}, {2, 0, -1}, {0, 0, 3}, {0, -2, -1}, {0, 2, -1}, {0, 0, 3}}, {{0, 1, 2}, {3, 4, 5}}};
  const TriangleMesh floor{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
  const auto curves = checked_curves(cross, floor);
  ASSERT_EQ(curves.size(), 4U);
  for (const IntersectionCurve& c : curves) {
    EXPECT_FALSE(c.closed);
    EXPECT_TRUE(c.points.front() == ExactPoint3(Point3{0, 0, 0}) || c.points.back() == ExactPoint3(Point3{0, 0, 0}));
  }
}

/// All that pairs of triangles have in common is on the curves, or in a face of both.
TEST(IntersectionCurves, HoldWhatPairsOfTrianglesHaveInCommon) {
  std::size_t edges = 0, closed = 0, ends = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    TriangleMesh a = heap(random, 2, 2), b = heap(random, 1, 2);
    if (seed % 3 == 0) b = solids::turned(b);
    if (seed % 4 == 0) a = solids::torn(a, 3);
    const auto curves = checked_curves(a, b);
    std::vector<ExactPoint3> on;
    for (const IntersectionCurve& c : curves) {
      edges += c.points.size() == 1 ? 0 : edges_of(c);
      closed += c.closed ? 1 : 0;
      on.insert(on.end(), c.points.begin(), c.points.end());
    }
    const auto is_known = [&](const ExactPoint3& p) { return std::ranges::find(on, p) != on.end(); };
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
      for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
        const auto [p, q, r] = points_of(a, i);
        const auto [u, v, w] = points_of(b, k);
        if (collinear(p, q, r) || collinear(u, v, w)) continue;
        const auto common = intersection(Triangle3{p, q, r}, Triangle3{u, v, w});
        const bool in_one_plane = orient3d(p, q, r, u) == Sign::zero && orient3d(p, q, r, v) == Sign::zero &&
                                  orient3d(p, q, r, w) == Sign::zero;
        if (in_one_plane) continue;
        for (const ExactPoint3& end : common.vertices) {
          bool in_area = false;  // of two other triangles, in one plane
          for (std::uint32_t l = 0; l < a.triangles.size() && !in_area; ++l)
            for (std::uint32_t m = 0; m < b.triangles.size() && !in_area; ++m) {
              const auto [e, f, g] = points_of(a, l);
              const auto [x, y, z] = points_of(b, m);
              in_area = orient3d(e, f, g, x) == Sign::zero && orient3d(e, f, g, y) == Sign::zero &&
                        orient3d(e, f, g, z) == Sign::zero && is_on(rational_point(end), {e, f, g}) &&
                        is_on(rational_point(end), {x, y, z});
            }
          EXPECT_TRUE(in_area || is_known(end));
          ++ends;
        }
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(edges, 200U);
  EXPECT_GT(closed, 10U);
  EXPECT_GT(ends, 400U);
}

TEST(IntersectionCurves, RefuseByName) {
  TriangleMesh bad = box({0, 0, 0}, {1, 1, 1});
  bad.triangles[0][0] = 99;
  EXPECT_THROW(intersection_curves(bad, box({0, 0, 0}, {1, 1, 1})), InvalidShape);
  bad = box({0, 0, 0}, {1, 1, 1});
  bad.vertices[1].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(intersection_curves(bad, box({0, 0, 0}, {1, 1, 1})), NonFinite);
}

TEST(Sheets, CutAndWindAroundNothing) {
  const std::vector<TriangleMesh> solid{box({-1, -1, -1}, {1, 1, 1})};
  const std::vector<TriangleMesh> sheets{{{{0, -9, -9}, {0, 9, -9}, {0, 0, 18}}, {{0, 1, 2}}}};
  const Arrangement all = arrange(solid, sheets);
  EXPECT_EQ(all.meshes, 2U);
  std::size_t within = 0, around = 0;
  for (std::size_t f = 0; f < all.facets.size(); ++f) {
    const auto above = all.windings_of(all.sides[f].above), below = all.windings_of(all.sides[f].below);
    EXPECT_EQ(above[1], 0);
    EXPECT_EQ(below[1], 0);
    if (all.sources_of(f).front().face.mesh == 0) {
      EXPECT_NE(above[0], below[0]);
      continue;
    }
    EXPECT_EQ(above[0], below[0]);
    // Within the solid the sheet parts two regions; outside one can go around its edges.
    EXPECT_EQ(all.sides[f].above != all.sides[f].below, above[0] == 1);
    (above[0] == 1 ? within : around) += 1;
  }
  EXPECT_GT(within, 1U);
  EXPECT_GT(around, 1U);
  const auto is_solid = [](std::span<const std::int32_t> w) { return w[0] > 0; };
  EXPECT_EQ(exact_volume(solid_where(all, is_solid)), Rational(8));
  std::vector<TriangleMesh> twice = sheets;
  twice[0].triangles.push_back({0, 2, 1});  // both sides of it
  EXPECT_EQ(arrange(solid, twice).facets, all.facets);
  EXPECT_THROW(arrange(sheets), UnbalancedEdge);
}

TEST(Sheets, HeapsHaveTheWindingsByDefinition) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<TriangleMesh> solid{heap(random, 3, 2)};
    const std::vector<TriangleMesh> sheets{solids::torn(heap(random, 2, 2), 3)};
    const Arrangement all = arrange(solid, sheets);
    const std::vector<TriangleMesh> meshes{solid[0], {}};
    solid_laws::expect_windings(meshes, all, 5);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace plumb

// Delaunay triangulations: empty circles by exact signs, area by rational numbers, one result for every order.
#include "plumb/surface/planar/delaunay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

#include "certify/sanitized.hpp"
#include "oracle/triangulations.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "surface/planar/triangulation_laws.hpp"

namespace plumb {
namespace {

using planar_laws::as_set, planar_laws::expect_laws;

std::vector<PlanarSegment> random_segments(std::size_t points, std::size_t count, Entropy& entropy) {
  std::vector<PlanarSegment> segments(count);
  for (auto& [a, b] : segments) {
    a = static_cast<std::uint32_t>(entropy.below(points));
    b = static_cast<std::uint32_t>(entropy.below(points));
  }
  return segments;
}

std::vector<Point2> small_lattice(Entropy& entropy) {
  const std::uint64_t edge = 1 + entropy.below(8);
  std::vector<Point2> points(1 + entropy.below(40));
  for (Point2& p : points) p = {static_cast<double>(entropy.below(edge)), static_cast<double>(entropy.below(edge))};
  return points;
}

TEST(Delaunay, KeepsItsLawsOnSmallLattices) {
  std::size_t crossed = 0, kept = 0, triangles = 0;
  for (std::uint64_t round = 0; round < battery::fitting(600U); ++round) {
    SCOPED_TRACE("Entropy(39, " + std::to_string(round) + ")");
    Entropy entropy(39, round);
    const std::vector<Point2> points = small_lattice(entropy);
    const PlanarTriangulation bare = delaunay(points);
    expect_laws(points, {}, bare);
    triangles += bare.triangles.size();
    const auto segments =
        planar_laws::uncrossed(points, random_segments(points.size(), entropy.below(20), entropy), &crossed);
    kept += segments.size();
    if (!segments.empty()) expect_laws(points, segments, delaunay(points, segments));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(crossed, battery::fitting(500U));
  EXPECT_GT(kept, battery::fitting(1000U));
  EXPECT_GT(triangles, battery::fitting(5000U));
}

TEST(Delaunay, KeepsItsLawsOnEveryFamilyOfHardPoints) {
  for (const FamilyInfo& info : families) {
    for (const Degeneracy degeneracy : {Degeneracy::collinear, Degeneracy::cocircular}) {
      for (std::uint64_t round = 0; round < battery::fitting(20U); ++round) {
        SCOPED_TRACE(std::string(info.name) + ", Entropy(40, " + std::to_string(round) + ")");
        Entropy entropy(40, round);
        const auto points = points2(info.family, degeneracy, 1 + entropy.below(14), entropy);
        std::size_t crossed = 0;
        const auto segments =
            planar_laws::uncrossed(points, random_segments(points.size(), entropy.below(8), entropy), &crossed);
        expect_laws(points, segments, segments.empty() ? delaunay(points) : delaunay(points, segments));
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(Delaunay, KeepsItsLawsOnClouds) {
  for (const CloudInfo& info : clouds) {
    SCOPED_TRACE(info.name);
    Entropy entropy(41);
    const auto points = cloud2(info.cloud, 150, entropy);
    expect_laws(points, {}, delaunay(points));
  }
}

TEST(Delaunay, IsUnmovedByPowersOfTwo) {
  for (std::uint64_t round = 0; round < 100; ++round) {
    SCOPED_TRACE("Entropy(42, " + std::to_string(round) + ")");
    Entropy entropy(42, round);
    std::vector<Point2> points = small_lattice(entropy);
    const auto triangles = as_set(delaunay(points).triangles);
    for (const double scale : {0x1p300, 0x1p-300, 0x1p1000, 0x1p-1070}) {
      std::vector<Point2> scaled = points;
      for (auto& [x, y] : scaled) x *= scale, y *= scale;
      EXPECT_EQ(as_set(delaunay(scaled).triangles), triangles) << scale;
    }
  }
}

// Of points of which no four are on one circle the order does not matter at all; of others it is the index that tells.
TEST(Delaunay, IsTheSameForEveryOrder) {
  for (std::uint64_t round = 0; round < 60; ++round) {
    SCOPED_TRACE("Entropy(43, " + std::to_string(round) + ")");
    Entropy entropy(43, round);
    std::vector<Point2> points(3 + entropy.below(60));
    for (Point2& p : points) p = {static_cast<double>(entropy.bits(40)), static_cast<double>(entropy.bits(40))};
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[entropy.below(k)]);
    std::vector<Point2> shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(points[i]);
    std::vector<planar_laws::Corners> named;
    for (const auto& [a, b, c] : delaunay(shuffled).triangles) named.push_back({order[a], order[b], order[c]});
    EXPECT_EQ(as_set(named), as_set(delaunay(points).triangles));
  }
}

// All on one circle: a fan about the lowest index, under any perturbation of which that is the largest.
TEST(Delaunay, PointsOnACircleAreAFanAboutTheLowestIndex) {
  const std::vector<Point2> points{{3, 4}, {5, 0}, {-4, 3}, {0, 5}, {0, -5}, {-3, -4}, {4, -3}, {-5, 0}};
  const auto made = delaunay(points);
  EXPECT_EQ(made.triangles.size(), points.size() - 2);
  for (const auto& t : made.triangles) EXPECT_EQ(planar_laws::turned(t)[0], 0U);
}

TEST(Delaunay, AgreesWithCgal) {
  std::size_t same = 0;
  for (std::uint64_t round = 0; round < battery::fitting(200U); ++round) {
    SCOPED_TRACE("Entropy(44, " + std::to_string(round) + ")");
    Entropy entropy(44, round);
    std::vector<Point2> points = small_lattice(entropy);
    if (round % 2 == 0)
      for (Point2& p : points) p.x += static_cast<double>(entropy.bits(20)) * 0x1p-24, p.y -= p.x * 0x1p-20;
    std::size_t crossed = 0;
    const auto segments =
        planar_laws::uncrossed(points, random_segments(points.size(), 1 + entropy.below(20), entropy), &crossed);
    const auto made = delaunay(points, segments);
    const auto theirs = oracle::constrained_triangles(points, segments);
    EXPECT_EQ(made.triangles.size(), theirs.size());
    bool unique = true;
    for (std::uint32_t f = 0; f < made.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto over = made.neighbors[f][k];
        if (over == PlanarTriangulation::none) continue;
        const auto &t = made.triangles[f], &u = made.triangles[over];
        for (const std::uint32_t d : u)
          if (std::find(t.begin(), t.end(), d) == t.end())
            unique = unique && incircle(points[t[0]], points[t[1]], points[t[2]], points[d]) != Sign::zero;
      }
    if (!unique) continue;
    EXPECT_EQ(as_set(made.triangles), as_set(theirs));
    ++same;
  }
  EXPECT_GT(same, battery::fitting(60U));
}

TEST(Delaunay, FewPointsAndPointsOfALineHaveNoTriangle) {
  EXPECT_TRUE(delaunay(std::vector<Point2>{}).triangles.empty());
  const std::vector<Point2> line{{0, 0}, {3, 3}, {1, 1}, {3, 3}, {-0.0, 0.0}};
  const std::vector<PlanarSegment> segments{{0, 1}, {2, 3}};
  const auto made = delaunay(line, segments);
  EXPECT_TRUE(made.triangles.empty());
  EXPECT_EQ(made.same, (std::vector<std::uint32_t>{0, 1, 2, 1, 0}));
}

TEST(Delaunay, TellsWhichSegmentsCrossAndWhere) {
  const std::vector<Point2> points{{0, 0}, {3, 3}, {0, 1}, {1, 0}, {5, 0}};
  try {
    (void)delaunay(points, std::vector<PlanarSegment>{{3, 4}, {0, 1}, {2, 3}});
    FAIL();
  } catch (const CrossingSegments& crossing) {
    EXPECT_EQ(crossing.segments, (PlanarSegment{1, 2}));
    EXPECT_EQ(crossing.place, ExactPoint2(Point2{0.5, 0.5}));
    EXPECT_STREQ(crossing.what(), "segments 1 and 2 cross at (1/2, 1/2); divide them there, or ask arrange_segments");
  }
}

TEST(Delaunay, RefusesWhatIsNoInput) {
  std::vector<Point2> points{{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THROW((void)delaunay(points), NonFinite);
  points[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)delaunay(points, std::vector<PlanarSegment>{}), NonFinite);
  points[2].y = 1;
  EXPECT_THROW((void)delaunay(points, std::vector<PlanarSegment>{{0, 3}}), Error);
}

// A hub, and segments that cross all of its spokes: none of them is an edge to begin with.
TEST(Delaunay, LongSegmentsOverManyEdges) {
  std::vector<Point2> points;
  for (int k = 0; k < 400; ++k) points.push_back({static_cast<double>(k), k % 2 == 0 ? 0.0 : 1.0 / 64});
  std::vector<PlanarSegment> segments;
  const auto n = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), {{-1, 0x1p-8}, {1000, 0x1p-8}, {-1, 0x1p-9}, {1000, 0x1p-9}});
  segments = {{n, n + 1}, {n + 2, n + 3}};
  expect_laws(points, segments, delaunay(points, segments));
}

}  // namespace
}  // namespace plumb

// Convex pieces: each convex by exact signs, together the polygon, none to be joined with a neighbor.
#include "plumb/surface/planar/convex_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "surface/planar/triangulation_laws.hpp"

namespace plumb {
namespace {

using Pieces = std::vector<std::vector<std::uint32_t>>;

Rational twice_area_of(const std::vector<Point2>& points, const std::vector<std::uint32_t>& piece) {
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < piece.size(); ++k)
    sum = sum + planar_laws::twice_area(points[piece[0]], points[piece[k]], points[piece[k + 1]]);
  return sum;
}

bool is_convex_piece(const std::vector<Point2>& points, const std::vector<std::uint32_t>& piece) {
  // Once around: turns to the left alone, and one lexicographic minimum.
  const std::size_t n = piece.size();
  std::size_t lowest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 &a = points[piece[k]], &b = points[piece[(k + 1) % n]], &c = points[piece[(k + 2) % n]];
    if (orient2d(a, b, c) == Sign::negative) return false;
    lowest += compare_xy(a, b) == Sign::positive && compare_xy(b, c) == Sign::negative;
  }
  return lowest == 1;
}

void expect_pieces(const std::vector<Point2>& points, const CornerTriangles& triangles, const Pieces& pieces) {
  Rational sum = 0;
  for (const auto& piece : pieces) {
    EXPECT_TRUE(is_convex_piece(points, piece));
    sum = sum + twice_area_of(points, piece);
  }
  EXPECT_EQ(sum, planar_laws::twice_area(points, triangles));
}

Polygon2 star(std::size_t corners, Entropy& entropy) {
  Polygon2 polygon;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double r = 0.05 + 0.001 * static_cast<double>(entropy.below(950));
    polygon.vertices.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return polygon;
}

TEST(ConvexPieces, OfStarsAreConvexAndFew) {
  std::size_t pieces = 0, reflex = 0;
  for (std::uint64_t round = 0; round < 30; ++round) {
    SCOPED_TRACE("Entropy(51, " + std::to_string(round) + ")");
    Entropy entropy(51, round);
    const Polygon2 polygon = star(5 + entropy.below(200), entropy);
    const auto& v = polygon.vertices;
    for (std::size_t k = 0; k < v.size(); ++k)
      reflex += orient2d(v[k], v[(k + 1) % v.size()], v[(k + 2) % v.size()]) == Sign::negative;
    const Pieces found = convex_pieces(polygon);
    pieces += found.size();
    expect_pieces(v, triangulate(polygon), found);
  }
  EXPECT_LE(static_cast<double>(pieces), 1.36 * static_cast<double>(reflex)) << pieces << " of " << reflex;
}

TEST(ConvexPieces, KnownOnes) {
  const Polygon2 square{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}};
  EXPECT_EQ(convex_pieces(square).size(), 1U);
  EXPECT_EQ(convex_pieces(square)[0].size(), 5U) << "vertices on straight edges stay";
  const Polygon2 corner{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}};
  EXPECT_EQ(convex_pieces(corner).size(), 2U);
  const HoledPolygon2 frame{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}}, {{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}};
  const Pieces pieces = convex_pieces(frame);
  EXPECT_EQ(pieces.size(), 4U);
  std::vector<Point2> points = frame.outer.vertices;
  points.insert(points.end(), frame.holes[0].vertices.begin(), frame.holes[0].vertices.end());
  expect_pieces(points, triangulate(frame), pieces);
}

TEST(ConvexPieces, AnyPathOfALattice) {
  std::size_t cut = 0;
  for (std::uint64_t round = 0; round < 3000; ++round) {
    SCOPED_TRACE("Entropy(52, " + std::to_string(round) + ")");
    Entropy entropy(52, round);
    Polygon2 polygon;
    polygon.vertices.resize(3 + entropy.below(12));
    for (Point2& p : polygon.vertices)
      p = {static_cast<double>(entropy.below(5)), static_cast<double>(entropy.below(5))};
    try {
      expect_pieces(polygon.vertices, triangulate(polygon), convex_pieces(polygon));
      ++cut;
    } catch (const CrossingSegments&) {
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(cut, 300U);
}

}  // namespace
}  // namespace plumb

// Convex pieces: each convex by exact signs, together the polygon, none to be joined with a neighbor.
#include "plumb/surface/planar/convex_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

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

// The fewest pieces of the chain from corner i to corner k, tried out: every convex polygon of corners between.
class TriedOut {
 public:
  explicit TriedOut(const std::vector<Point2>& points) : points_(points), kept_(points.size() * points.size(), 0) {}

  std::size_t fewest() { return fewest(0, points_.size() - 1); }

 private:
  std::size_t fewest(std::size_t i, std::size_t k) {
    if (k == i + 1) return 0;
    std::size_t& kept = kept_[i * points_.size() + k];
    if (kept != 0) return kept;
    kept = 1'000'000;
    std::vector<std::size_t> piece{i};
    extend(piece, k, 1, kept);
    return kept;
  }

  void extend(std::vector<std::size_t>& piece, std::size_t k, std::size_t sum, std::size_t& best) {
    for (std::size_t next = piece.back() + 1; next <= k; ++next) {
      const std::size_t from = piece.back();
      if (piece.size() == 1 && next == k) continue;
      if (next != from + 1 && !sees(from, next)) continue;
      if (piece.size() > 1 && turn(piece[piece.size() - 2], from, next) == Sign::negative) continue;
      piece.push_back(next);
      if (next == k) {
        const bool closes = turn(piece[piece.size() - 2], k, piece[0]) != Sign::negative &&
                            turn(k, piece[0], piece[1]) != Sign::negative && has_area(piece);
        if (closes) best = std::min(best, sum + fewest(from, next));
      } else {
        extend(piece, k, sum + fewest(from, next), best);
      }
      piece.pop_back();
    }
  }
  bool has_area(const std::vector<std::size_t>& piece) {
    for (std::size_t j = 1; j + 1 < piece.size(); ++j)
      if (turn(piece[0], piece[j], piece[j + 1]) == Sign::negative) return false;
    return turn(piece[0], piece[1], piece.back()) == Sign::positive || piece.size() > 3;
  }
  Sign turn(std::size_t a, std::size_t b, std::size_t c) const { return orient2d(points_[a], points_[b], points_[c]); }

  // No corner on the diagonal, no edge across it, and its middle within.
  bool sees(std::size_t i, std::size_t k) const {
    if (i == 0 && k + 1 == points_.size()) return true;
    const Rational x = (Rational(points_[i].x) + Rational(points_[k].x)) * Rational(1, 2);
    const Rational y = (Rational(points_[i].y) + Rational(points_[k].y)) * Rational(1, 2);
    bool odd = false;
    for (std::size_t a = 0; a < points_.size(); ++a) {
      const std::size_t b = (a + 1) % points_.size();
      if (a != i && a != k && turn(i, k, a) == Sign::zero &&
          compare_xy(points_[i], points_[a]) == compare_xy(points_[a], points_[k]))
        return false;
      if (a != i && a != k && b != i && b != k && turn(i, k, a) != turn(i, k, b) && turn(a, b, i) != turn(a, b, k) &&
          turn(i, k, a) != Sign::zero && turn(i, k, b) != Sign::zero)
        return false;
      const Rational ay = points_[a].y, by = points_[b].y, ax = points_[a].x, bx = points_[b].x;
      if ((ay <= y) == (by <= y)) continue;
      if (x < ax + (bx - ax) * (y - ay) / (by - ay)) odd = !odd;
    }
    return odd;
  }

  const std::vector<Point2>& points_;
  std::vector<std::size_t> kept_;
};

/// Convex and as few as brute force finds; none where the polygon's edges meet elsewhere than in corners.
std::optional<Pieces> fewest_as_tried_out(const Polygon2& polygon) {
  Pieces pieces;
  try {
    pieces = fewest_convex_pieces(polygon);
  } catch (const InvalidShape&) {
    return {};
  }
  std::vector<Point2> left = polygon.vertices;
  std::vector<std::uint32_t> all(left.size());
  std::iota(all.begin(), all.end(), 0U);
  if (twice_area_of(left, all).sign() == Sign::negative) std::reverse(left.begin(), left.end());
  EXPECT_EQ(pieces.size(), TriedOut(left).fewest());
  expect_pieces(polygon.vertices, triangulate(polygon), pieces);
  return pieces;
}

TEST(ConvexPieces, TheFewestAreFewest) {
  std::size_t asked = 0, fewer = 0;
  for (std::uint64_t round = 0; round < 300; ++round) {
    SCOPED_TRACE("Entropy(53, " + std::to_string(round) + ")");
    Entropy entropy(53, round);
    Polygon2 polygon = star(5 + entropy.below(7), entropy);
    if (round % 2 == 0)  // many corners on lines with others
      for (auto& [x, y] : polygon.vertices) x = std::round(x * 6), y = std::round(y * 6);
    if (round % 3 == 0) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    const std::optional<Pieces> told = fewest_as_tried_out(polygon);
    if (!told) continue;
    const Pieces& pieces = *told;
    ++asked;
    fewer += pieces.size() < convex_pieces(polygon).size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(asked, 150U);
  EXPECT_GT(fewer, 0U);
  EXPECT_THROW((void)fewest_convex_pieces(Polygon2{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}), InvalidShape);
}

bool cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto parts = [](const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
    return static_cast<int>(orient2d(p, q, r)) * static_cast<int>(orient2d(p, q, s)) < 0;
  };
  return parts(a, b, c, d) && parts(c, d, a, b);
}

// A path of a lattice whose crossings are undone, most of whose corners lie on lines with others.
Polygon2 uncrossed(std::size_t corners, std::uint64_t side, Entropy& entropy) {
  Polygon2 polygon;
  auto& v = polygon.vertices;
  for (std::size_t k = 0; k < corners; ++k)
    v.push_back({static_cast<double>(entropy.below(side)), static_cast<double>(entropy.below(side))});
  bool found = true;
  for (int pass = 0; found && pass < 50; ++pass) {
    found = false;
    for (std::size_t i = 0; i + 2 < corners; ++i)
      for (std::size_t j = i + 2; j < corners; ++j)
        if (cross(v[i], v[i + 1], v[j], v[(j + 1) % corners])) {
          std::reverse(&v[i + 1], &v[j] + 1);
          found = true;
        }
  }
  return polygon;
}

void expect_no_corner_within_an_edge(const std::vector<Point2>& points, const Pieces& pieces) {
  for (const auto& piece : pieces)
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const Point2 &a = points[piece[k]], &b = points[piece[(k + 1) % piece.size()]];
      for (const Point2& p : points)
        EXPECT_FALSE(orient2d(a, b, p) == Sign::zero && compare_xy(a, p) == compare_xy(p, b));
    }
}

TEST(ConvexPieces, TheFewestOfALatticeAreFewest) {
  std::size_t asked = 0;
  for (std::uint64_t round = 0; round < 6000; ++round) {
    SCOPED_TRACE("Entropy(54, " + std::to_string(round) + ")");
    Entropy entropy(54, round);
    const std::size_t corners = 5 + entropy.below(8);
    const Polygon2 polygon = uncrossed(corners, 4 + entropy.below(4), entropy);
    const std::optional<Pieces> told = fewest_as_tried_out(polygon);
    if (!told) continue;
    const Pieces& pieces = *told;
    ++asked;
    expect_no_corner_within_an_edge(polygon.vertices, pieces);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(asked, 500U);
}

TEST(ConvexPieces, TheFewestAreConvexWhereverTheRingBegins) {
  for (std::uint64_t round = 0; round < 100; ++round) {
    SCOPED_TRACE("Entropy(55, " + std::to_string(round) + ")");
    Entropy entropy(55, round);
    Polygon2 polygon = star(20 + entropy.below(60), entropy);
    if (round % 2 == 0)
      for (auto& [x, y] : polygon.vertices) x = std::round(x * 30), y = std::round(y * 30);
    try {
      const Pieces pieces = fewest_convex_pieces(polygon);
      expect_pieces(polygon.vertices, triangulate(polygon), pieces);
      EXPECT_LE(pieces.size(), convex_pieces(polygon).size());
      std::rotate(polygon.vertices.begin(), polygon.vertices.begin() + 1 + entropy.below(18), polygon.vertices.end());
      EXPECT_EQ(pieces.size(), fewest_convex_pieces(polygon).size());
    } catch (const InvalidShape&) {
    }
  }
}

}  // namespace
}  // namespace plumb

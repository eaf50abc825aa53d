// Are hulls in the plane right, for whatever points?  Against brute force over rationals, CGAL, and their own proof.
#include "plumb/figure/hull/hull2.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "degenerate/rational_signs.hpp"
#include "oracle/cgal_minkowski.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb {
namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<double> flat(std::span<const Point2> points) {
  std::vector<double> c;
  for (const Point2& p : points) c.insert(c.end(), {p.x, p.y});
  return c;
}

/// Every way of asking; all give the same.
Hull2 hull_of(std::span<const Point2> points, bool all) {
  const Hull2 hull = convex_hull(points, {.all_boundary_points = all});
  for (const Hull2Method method : {Hull2Method::monotone_chain, Hull2Method::quickhull}) {
    for (const bool prefilter : {false, true}) {
      for (const Execution execution : {Execution::serial, Execution::parallel}) {
        EXPECT_EQ(convex_hull(points, {method, all, prefilter, execution}), hull);
      }
    }
  }
  EXPECT_TRUE(verify_hull(hull, points, {.all_boundary_points = all}));
  return hull;
}

bool less(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// By definition, from the rational signs of all triples: lines through two points that have none on their right.
Hull2 by_definition(const std::vector<Point2>& points, bool all) {
  Indices distinct;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::ranges::none_of(distinct, [&](std::uint32_t j) { return points[j] == points[i]; })) distinct.push_back(i);
  }
  if (distinct.size() <= 1) return {static_cast<int>(distinct.size()) - 1, distinct};
  const std::vector<double> c = flat(points);
  const auto start = *std::ranges::min_element(distinct, [&](auto i, auto j) { return less(points[i], points[j]); });
  Hull2 hull{1, {start}};
  bool bent = false;
  // From each vertex to the farthest point of the line that has none on its right.
  for (std::uint32_t at = start;;) {
    Indices on_line;
    for (const std::uint32_t to : distinct) {
      if (to == at) continue;
      Indices on;
      bool supports = true;
      for (const std::uint32_t other : distinct) {
        const std::size_t which[] = {at, to, other};
        const int s = other == at || other == to ? 0 : plumb_test::sign_of_flat(c, 2, which);
        supports = supports && s >= 0;
        bent = bent || s != 0;
        if (s == 0 && other != at) on.push_back(other);
      }
      // Ahead of the vertex: of a vertex all points of its edge are on one side.
      if (supports) on_line = on;
    }
    std::ranges::sort(on_line, [&](auto i, auto j) { return less(points[i], points[j]); });
    if (!on_line.empty() && less(points[on_line.back()], points[at])) std::ranges::reverse(on_line);
    if (!all) on_line.erase(on_line.begin(), on_line.end() - 1);
    if (!bent && at != start) break;
    for (const std::uint32_t i : on_line) {
      if (i != start) hull.vertices.push_back(i);
    }
    at = on_line.back();
    if (at == start) break;
  }
  if (bent) hull.dimension = 2;
  return hull;
}

TEST(Hull2, IsWhatTheDefinitionSays) {
  std::map<int, int> dimensions;
  int with_points_on_edges = 0;
  for (std::uint64_t index = 0; index < 1500; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(31, " << index << ")");
    Entropy entropy(31, index);
    const Family family = any_family(entropy);
    const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
    std::vector<Point2> points = points2(family, degeneracy, entropy.below(9), entropy);
    if (entropy.below(3) == 0) {  // a small grid has every kind of tie
      for (Point2& p : points)
        p = {static_cast<double>(entropy.within(2)), -0.0 * static_cast<double>(entropy.within(1))};
      for (Point2& p : points) p.y += static_cast<double>(entropy.within(static_cast<std::int64_t>(index % 3)));
    }
    const Hull2 strict = by_definition(points, false), rim = by_definition(points, true);
    ASSERT_EQ(hull_of(points, false), strict);
    ASSERT_EQ(hull_of(points, true), rim);
    ++dimensions[strict.dimension];
    with_points_on_edges += strict.dimension == 2 && rim.vertices.size() > strict.vertices.size();
  }
  for (int d = -1; d <= 2; ++d) EXPECT_GT(dimensions[d], 50) << d;
  EXPECT_GT(with_points_on_edges, 100);
}

TEST(Hull2, IsCgals) {
  for (std::uint64_t index = 0; index < 300; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(32, " << index << ")");
    Entropy entropy(32, index);
    const Family family = families[index % families.size()].family;
    const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
    const std::vector<Point2> points = points2(family, degeneracy, 1 + entropy.below(400), entropy);
    const Hull2 hull = hull_of(points, false);
    std::vector<Point2> vertices;
    for (const std::uint32_t i : hull.vertices) vertices.push_back(points[i]);
    EXPECT_EQ(flat(vertices), oracle::hull_2(flat(points)));
    hull_of(points, true);
  }
}

// One point after the other leaves a chain again: inside, on an edge, past an edge.
TEST(Hull2, OfPointsInsideAndOnEdges) {
  const std::vector<Point2> points{{0, 0}, {4, -1},  {2, 1}, {7, 0},   {6, 3},
                                   {3, 5}, {1, 1.5}, {5, 2}, {3.5, 0}, {6.5, 1.5}};
  EXPECT_EQ(hull_of(points, false), (Hull2{2, {0, 1, 3, 4, 5}}));
  EXPECT_EQ(hull_of(points, true), (Hull2{2, {0, 1, 3, 9, 4, 5}}));
}

TEST(Hull2, TellsTheDimension) {
  EXPECT_EQ(hull_of({}, false), (Hull2{-1, {}}));
  const std::vector<Point2> equal{{0.0, -0.0}, {-0.0, 0.0}, {0, 0}};
  EXPECT_EQ(hull_of(equal, true), (Hull2{0, {0}}));
  const std::vector<Point2> collinear{{3, 3}, {1, 1}, {2, 2}, {1, 1}, {3, 3}, {-0.0, 0.0}, {0, 0}};
  EXPECT_EQ(hull_of(collinear, false), (Hull2{1, {5, 0}}));
  EXPECT_EQ(hull_of(collinear, true), (Hull2{1, {5, 1, 2, 0}}));
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const std::vector<Point2> huge{{-most, -most}, {0, 0}, {most, most}, {least, 0}};
  EXPECT_EQ(hull_of(huge, false), (Hull2{2, {0, 3, 2}}));
  EXPECT_EQ(hull_of(huge, true), (Hull2{2, {0, 3, 2, 1}}));
}

TEST(Hull2, OfAMillionPointsOfAGrid) {
  std::vector<Point2> points;
  for (int i = 0; i < 1000000; ++i)
    points.push_back({static_cast<double>(i % 1000 * 7 % 1000), static_cast<double>(i / 1000)});
  for (const Hull2Method method : {Hull2Method::monotone_chain, Hull2Method::quickhull}) {
    const Hull2 hull = convex_hull(points, {method, false, true, Execution::parallel});
    ASSERT_EQ(hull.vertices.size(), 4u);
    const Hull2 rim = convex_hull(points, {method, true, true, Execution::serial});
    EXPECT_EQ(rim.vertices.size(), 3996u);
    EXPECT_TRUE(verify_hull(rim, points, {.all_boundary_points = true}));
  }
}

// Thousands of points, all of them vertices, or all but a few on edges, repeated.
TEST(Hull2, OfPointsOnACircleAndOnASquare) {
  std::vector<Point2> circle, square;
  for (int a = -2000; a <= 2000; ++a) {
    const double x = a, y = x * x;
    circle.insert(circle.end(), {{x, y}, {x, 8e6 - y}});
    square.insert(square.end(), {{x, -2000}, {x, 2000}, {-2000, x}, {2000, x}, {-2000, -2000}});
  }
  EXPECT_EQ(hull_of(circle, false).vertices.size(), circle.size() - 2);  // the curves meet twice
  EXPECT_EQ(hull_of(square, false).vertices.size(), 4u);
  EXPECT_EQ(hull_of(square, true).vertices.size(), 16000u);
}

TEST(Hull2, ProofRefusesWhatIsNoHull) {
  int refused = 0;
  for (std::uint64_t index = 0; index < 300; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(33, " << index << ")");
    Entropy entropy(33, index);
    const std::vector<Point2> points =
        points2(any_family(entropy), Degeneracy::collinear, 3 + entropy.below(20), entropy);
    const bool all = entropy.coin();
    const Hull2Options options{.all_boundary_points = all};
    const Hull2 hull = convex_hull(points, options);
    const auto refuse = [&](Hull2 wrong) {
      if (wrong == hull) return;
      ++refused;
      EXPECT_NE(verify_hull(wrong, points, options).flaw, "");
    };
    Hull2 wrong = hull;
    wrong.dimension += entropy.coin() ? 1 : -1;
    refuse(wrong);
    wrong = hull;
    wrong.vertices.erase(wrong.vertices.begin() + static_cast<long>(entropy.below(hull.vertices.size())));
    refuse(wrong);
    wrong = hull;
    std::swap(wrong.vertices.front(), wrong.vertices[entropy.below(hull.vertices.size())]);
    refuse(wrong);
    wrong = hull;
    wrong.vertices[entropy.below(hull.vertices.size())] = static_cast<std::uint32_t>(entropy.below(points.size() + 1));
    refuse(wrong);
    wrong = hull;
    wrong.vertices.insert(wrong.vertices.begin() + static_cast<long>(entropy.below(hull.vertices.size() + 1)),
                          static_cast<std::uint32_t>(entropy.below(points.size())));
    refuse(wrong);
    wrong = hull;
    std::ranges::reverse(wrong.vertices);
    refuse(wrong);
  }
  EXPECT_GT(refused, 1000);
}

TEST(Hull2, FarthestPointsTieExactly) {
  const std::vector<Point2> points{{0, 3}, {1, 2}, {3, 0}, {1, 1}, {1, 2}, {2, std::nextafter(1.0, 0.0)}};
  EXPECT_EQ(extreme_points(points, {1, 1}), (Indices{0, 1, 2, 4}));
  EXPECT_EQ(extreme_points(points, {0, -0.5}), (Indices{2}));
  EXPECT_EQ(extreme_points(points, {-0.0, 0}).size(), points.size());
  EXPECT_TRUE(extreme_points({}, Vector2{1, 0}).empty());
  EXPECT_THROW(extreme_points(points, Vector2{std::nan(""), 0}), NonFinite);
}

TEST(Hull2, NamesWhatIsNoNumber) {
  std::vector<Point2> points(100, Point2{1, 2});
  points[17].y = std::numeric_limits<double>::quiet_NaN();
  try {
    convex_hull(points);
    FAIL() << "a NaN was taken for a number";
  } catch (const NonFinite& e) {
    EXPECT_NE(std::string(e.what()).find("convex_hull: points[17].y is nan"), std::string::npos) << e.what();
  }
  points[17] = {-std::numeric_limits<double>::infinity(), 0};
  EXPECT_THROW(convex_hull(points, {.prefilter = false}), NonFinite);
}

}  // namespace
}  // namespace plumb

// Are Minkowski sums in the plane exact?  Against the hull of all sums of pairs in rationals, CGAL, and separating
// lines.
#include "plumb/figure/minkowski/minkowski.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "figure/basic/rationals.hpp"
#include "oracle/cgal_minkowski.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/hull2.hpp"

namespace plumb {
namespace {

using rationals::dot, rationals::exact, rationals::Vector;
using rationals::operator+, rationals::operator-, rationals::operator*;
using Span = std::span<const Point2>;

mpq_class turn(const Vector& a, const Vector& b, const Vector& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Strictly convex, counterclockwise from the smallest.
std::vector<Vector> hull(std::vector<Vector> p) {
  std::ranges::sort(p);
  p.erase(std::unique(p.begin(), p.end()), p.end());
  if (p.size() < 2) return p;
  std::vector<Vector> chain;
  const auto extend = [&](std::size_t base, const Vector& next) {
    while (chain.size() >= base + 2 && turn(chain[chain.size() - 2], chain.back(), next) <= 0) chain.pop_back();
    chain.push_back(next);
  };
  for (const Vector& next : p) extend(0, next);
  const std::size_t lower = chain.size();
  for (std::size_t i = p.size() - 1; i-- > 0;) extend(lower - 1, p[i]);
  chain.pop_back();
  return chain;
}

std::vector<Vector> pairs(Span a, Span b, int sign) {
  std::vector<Vector> all;
  for (const Point2& p : a) {
    for (const Point2& q : b) all.push_back(exact(p) + mpq_class(sign) * exact(q));
  }
  return all;
}

std::vector<Vector> vertices(const MinkowskiSum2& sum) {
  std::vector<Vector> all;
  for (const SumVertex2& v : sum.vertices) all.push_back(exact(v.a) + exact(v.b));
  return all;
}

Location located(const std::vector<Vector>& chain, const Vector& p) {
  if (chain.size() == 1) return chain[0] == p ? Location::boundary : Location::outside;
  bool on = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vector &a = chain[i], &b = chain[(i + 1) % chain.size()];
    const mpq_class t = turn(a, b, p);
    if (t < 0) return Location::outside;
    if (t != 0) continue;
    on = true;
    if (dot(p - a, p - b) > 0) return Location::outside;
  }
  return on ? Location::boundary : Location::inside;
}

/// By a line between them: along the shortest way, or an edge.
bool apart(Span a, Span b) {
  std::vector<Vector> all;
  for (const Point2& p : a) all.push_back(exact(p));
  for (const Point2& p : b) all.push_back(exact(p));
  const auto parts = [&](const Vector& n) {
    std::vector<mpq_class> of_a, of_b;
    for (const Point2& p : a) of_a.push_back(dot(n, exact(p)));
    for (const Point2& p : b) of_b.push_back(dot(n, exact(p)));
    return std::ranges::max(of_a) < std::ranges::min(of_b);
  };
  for (const Vector& p : all) {
    for (const Vector& q : all) {
      const Vector way = q - p;
      if (parts(way) || parts(Vector{way[1], -way[0]})) return true;
    }
  }
  return false;
}

/// A convex polygon, as chains come: from any vertex, either way around, some vertices repeated, some on edges; now and
/// then a segment or a point.
Polygon2 polygon(Entropy& entropy, Family family) {
  std::vector<Point2> points = points2(family, Degeneracy::collinear, 3 + entropy.below(6), entropy);
  if (entropy.below(3) != 0) {
    const std::int64_t most = 1 + static_cast<std::int64_t>(entropy.below(4));
    const std::uint64_t flat = entropy.below(6);
    for (Point2& p : points) {
      p = {static_cast<double>(entropy.within(most)), static_cast<double>(entropy.within(most))};
      if (flat == 0) p = points[0];
      if (flat == 1) p = {p.x, -2 * p.x};
    }
  }
  const Hull2 hull = convex_hull(points, {.all_boundary_points = entropy.coin()});
  Polygon2 made;
  for (const std::uint32_t i : hull.vertices) {
    made.vertices.insert(made.vertices.end(), 1 + (entropy.below(4) == 0 ? 1 : 0), points[i]);
  }
  while (made.vertices.size() < 3) made.vertices.push_back(made.vertices[entropy.below(made.vertices.size())]);
  std::rotate(made.vertices.begin(), made.vertices.begin() + static_cast<long>(entropy.below(made.vertices.size())),
              made.vertices.end());
  if (entropy.coin()) std::ranges::reverse(made.vertices);
  return made;
}

TEST(Minkowski2, IsTheHullOfAllSums) {
  std::map<int, int> dimensions;
  std::map<Location, int> locations;
  for (std::uint64_t index = 0; index < 1000; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(61, " << index << ")");
    Entropy entropy(61, index);
    const Polygon2 a = polygon(entropy, any_family(entropy)), b = polygon(entropy, any_family(entropy));
    const MinkowskiSum2 sum = minkowski_sum(a, b), difference = minkowski_difference(a, b);
    const std::vector<Vector> expected = hull(pairs(a.vertices, b.vertices, 1));
    ASSERT_EQ(vertices(sum), expected);
    ASSERT_EQ(sum.dimension, std::min(static_cast<int>(expected.size()) - 1, 2));
    ASSERT_EQ(vertices(minkowski_sum(b, a)), expected);
    ASSERT_EQ(vertices(minkowski_sum(Span(a.vertices), Span(b.vertices))), expected);
    const std::vector<Vector> less = hull(pairs(a.vertices, b.vertices, -1));
    ASSERT_EQ(vertices(difference), less);
    ASSERT_EQ(vertices(minkowski_difference(Span(a.vertices), Span(b.vertices))), less);
    for (const SumVertex2& v : difference.vertices) {
      ASSERT_EQ(v.a, a.vertices[v.index_a]);
      ASSERT_EQ(v.b, (Point2{-b.vertices[v.index_b].x, -b.vertices[v.index_b].y}));
    }
    ASSERT_EQ(contains_origin(difference), !apart(a.vertices, b.vertices));
    ASSERT_EQ(locate(difference, {0, 0}), located(less, exact(Point2{0, 0})));
    ++dimensions[sum.dimension];
    ++locations[locate(difference, {0, 0})];
    const Point2 &p = a.vertices[0], &q = b.vertices[1];
    for (const Point2& x : {p, q, Point2{p.x + q.x, p.y + q.y}, Point2{p.x / 2 + q.x / 2, q.y}}) {
      if (!std::isfinite(x.x) || !std::isfinite(x.y)) continue;
      ASSERT_EQ(locate(sum, x), located(expected, exact(x)));
    }
  }
  EXPECT_GT(dimensions[0], 5);
  EXPECT_GT(dimensions[1], 20);
  EXPECT_GT(dimensions[2], 500);
  for (const Location l : {Location::outside, Location::boundary, Location::inside}) EXPECT_GT(locations[l], 40);
}

TEST(Minkowski2, IsCgals) {
  int compared = 0;
  for (std::uint64_t index = 0; index < 120; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(62, " << index << ")");
    Entropy entropy(62, index);
    const Polygon2 a = polygon(entropy, Family::grid), b = polygon(entropy, Family::grid);
    if (convex_hull(a.vertices).dimension < 2 || convex_hull(b.vertices).dimension < 2) continue;
    ++compared;
    const auto flat = [](const Polygon2& p) {
      std::vector<double> c;
      for (const std::uint32_t i : convex_hull(p.vertices).vertices)
        c.insert(c.end(), {p.vertices[i].x, p.vertices[i].y});
      return c;
    };
    std::vector<double> ours;
    for (const SumVertex2& v : minkowski_sum(a, b).vertices) ours.insert(ours.end(), {v.a.x, v.a.y, v.b.x, v.b.y});
    ASSERT_TRUE(oracle::is_sum_2(flat(a), flat(b), ours));
  }
  EXPECT_GT(compared, 40);
}

// Figure 3.26: a triangle and a square, whose edges all differ in direction.
TEST(Minkowski2, OfATriangleAndASquare) {
  const Polygon2 triangle{{{0, 0}, {3, 1}, {1, 4}}}, square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
  EXPECT_EQ(rounded_vertices(minkowski_sum(triangle, square)),
            (std::vector<Point2>{{0, 0}, {2, 0}, {5, 1}, {5, 3}, {3, 6}, {1, 6}, {0, 2}}));
  const Polygon2 right{{{0, 0}, {3, 0}, {0, 4}}};  // two pairs of parallel edges become two edges
  EXPECT_EQ(rounded_vertices(minkowski_sum(right, square)),
            (std::vector<Point2>{{0, 0}, {5, 0}, {5, 2}, {2, 6}, {0, 6}}));
}

// Figure 3.27: rectangle and triangle overlap, so that their difference holds the origin; then they touch; then not.
TEST(Minkowski2, ContainsTheOriginWhereShapesMeet) {
  const Polygon2 rectangle{{{1, 1}, {5, 1}, {5, 3}, {1, 3}}};
  const auto where = [&](double x) {
    const Polygon2 triangle{{{x, 2}, {x + 2, 0}, {x + 3, 4}}};
    const MinkowskiSum2 difference = minkowski_difference(rectangle, triangle);
    EXPECT_EQ(contains_origin(difference), locate(difference, {0, 0}) != Location::outside);
    return locate(difference, {0, 0});
  };
  EXPECT_EQ(where(4), Location::inside);
  EXPECT_EQ(where(5), Location::boundary);
  EXPECT_EQ(where(std::nextafter(5.0, 6.0)), Location::outside);
}

// Sums beyond all doubles, and those that lose digits, are as good as any.
TEST(Minkowski2, NeedsNoDoublesForItsVertices) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const Polygon2 a{{{huge, huge}, {0, huge}, {0, 0}}}, b{{{huge, 0}, {tiny, tiny}, {0, 0}}};
  const MinkowskiSum2 sum = minkowski_sum(a, b);
  EXPECT_EQ(vertices(sum), hull(pairs(a.vertices, b.vertices, 1)));
  EXPECT_THROW(rounded_vertices(sum), BeyondDoubles);
  EXPECT_EQ(locate(sum, {huge, huge}), Location::inside);  // below a vertex by the least of doubles
  EXPECT_EQ(locate(sum, {0, huge}), Location::boundary);
}

TEST(Minkowski2, RefusesWhatIsNotConvex) {
  const Polygon2 square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, dart{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}};
  EXPECT_THROW(minkowski_sum(square, dart), InvalidShape);
  EXPECT_THROW(minkowski_difference(dart, square), InvalidShape);
  EXPECT_THROW(minkowski_sum(square, Polygon2{{{0, 0}, {1, 1}}}), InvalidShape);
  EXPECT_THROW(minkowski_sum(square, Polygon2{{{0, 0}, {1, 1}, {std::nan(""), 0}}}), NonFinite);
  EXPECT_EQ(minkowski_sum(Span(square.vertices), Span()).dimension, -1);
  EXPECT_FALSE(contains_origin(minkowski_sum(Span(square.vertices), Span())));
}

}  // namespace
}  // namespace plumb

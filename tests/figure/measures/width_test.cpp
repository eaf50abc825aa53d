// The least width of points, against the definition: all directions that two pairs of points span, in rationals.
#include "plumb/figure/measures/width.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using Exact = std::array<Rational, 3>;

Exact between(const Point3& a, const Point3& b) {
  return {Rational(b.x) - Rational(a.x), Rational(b.y) - Rational(a.y), Rational(b.z) - Rational(a.z)};
}
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The square of the distance of the planes with that normal between which the points lie.
Rational squared_width(const std::vector<Point3>& points, const Exact& normal) {
  Rational least(0), most(0);
  for (const Point3& p : points) {
    const Rational at = dot(normal, between(points[0], p));
    least = std::min(least, at), most = std::max(most, at);
  }
  return (most - least) * (most - least) / dot(normal, normal);
}

Rational by_definition(const std::vector<Point3>& points) {
  std::vector<Exact> ways;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) ways.push_back(between(points[i], points[k]));
  std::optional<Rational> least;
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Exact normal = cross(ways[i], ways[k]);
      if (dot(normal, normal) == Rational(0)) continue;
      const Rational here = squared_width(points, normal);
      if (!least || here < *least) least = here;
    }
  return least.value_or(Rational(0));
}

void expect_least(const std::vector<Point3>& points) {
  const PointsWidth w = least_width(points);
  EXPECT_TRUE(w.squared == by_definition(points)) << w.squared.text();
  const Rational up(w.width), below(std::nextafter(w.width, 0));
  EXPECT_FALSE(up * up < w.squared);
  EXPECT_TRUE(w.width == 0 || below * below < w.squared) << "rounded once";
  ASSERT_EQ(w.one.empty(), w.squared == Rational(0));
  if (w.one.empty()) return;
  const auto& [u, v] = w.normal_edges;
  const Exact normal = cross(between(points[u[0]], points[u[1]]), between(points[v[0]], points[v[1]]));
  EXPECT_TRUE(squared_width(points, normal) == w.squared);
  EXPECT_EQ(w.one.size() + w.other.size(), 4U);
  for (const std::uint32_t p : w.one) EXPECT_TRUE(dot(normal, between(points[w.one[0]], points[p])) == Rational(0));
  for (const std::uint32_t p : w.other) EXPECT_TRUE(dot(normal, between(points[w.other[0]], points[p])) == Rational(0));
}

TEST(LeastWidth, AsTheDefinitionSays) {
  std::size_t by_edges = 0, flat = 0;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<Point3> points(1 + random() % 8);
    const int range = seed % 3 == 0 ? 2 : 9;
    const auto number = [&] { return double(int(random() % std::uint32_t(2 * range + 1)) - range); };
    for (Point3& p : points) p = {number(), number(), number()};
    if (seed % 5 == 0)
      for (Point3& p : points) p = {std::ldexp(p.x, 600), std::ldexp(p.y, -700), p.z + std::ldexp(p.x, -40)};
    expect_least(points);
    const PointsWidth w = least_width(points);
    by_edges += w.one.size() == 2;
    flat += w.one.empty();
    std::vector<Point3> shuffled = points;
    std::ranges::shuffle(shuffled, random);
    EXPECT_TRUE(least_width(shuffled).squared == w.squared);
  }
  EXPECT_GT(by_edges, 20U);
  EXPECT_GT(flat, 10U);
}

TEST(LeastWidth, OfKnownShapes) {
  const std::vector<Point3> box{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}, {0, 0, 1}, {2, 0, 1}, {0, 3, 1}, {2, 3, 1}};
  EXPECT_EQ(least_width(box).width, 1);
  // A regular tetrahedron of edge sqrt(8): two opposite edges are 2 apart, a vertex and its face 4 / sqrt(3).
  const std::vector<Point3> tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_EQ(least_width(tetrahedron).width, 2);
  EXPECT_EQ(least_width(tetrahedron).one.size(), 2U);
  EXPECT_EQ(least_width(std::vector<Point3>{{1, 2, 3}}).width, 0);
  EXPECT_THROW(least_width({}), InvalidShape);
  EXPECT_THROW(least_width(std::vector<Point3>{{0, 0, NAN}}), NonFinite);
}

}  // namespace
}  // namespace plumb

// Are Minkowski sums in space exact?  Proved from their definition, in rationals: faces that close, bend outward at
// every edge, and have all sums of pairs below them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "figure/basic/rationals.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/minkowski/minkowski.hpp"

namespace plumb {
namespace {

using rationals::dot, rationals::exact, rationals::Vector;
using rationals::operator+, rationals::operator-, rationals::operator*;
using Span = std::span<const Point3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Vector& v) {
  return std::ranges::all_of(v, [](const mpq_class& x) { return x == 0; });
}

std::set<Vector> pairs(Span a, Span b, int sign) {
  std::set<Vector> all;
  for (const Point3& p : a) {
    for (const Point3& q : b) all.insert(exact(p) + mpq_class(sign) * exact(q));
  }
  return all;
}

std::vector<Vector> vertices(const MinkowskiSum3& sum) {
  std::vector<Vector> all;
  for (const SumVertex3& v : sum.vertices) all.push_back(exact(v.a) + exact(v.b));
  return all;
}

int dimension_of(const std::set<Vector>& points) {
  std::vector<Vector> rows;
  for (const Vector& p : points) rows.push_back(p - *points.begin());
  return static_cast<int>(rationals::reduce(rows, 3).rank);
}

/// Strictly convex around its normal, which is returned.
Vector normal_of(const std::vector<Vector>& corners) {
  const std::size_t n = corners.size();
  const auto turn = [&](std::size_t i) {
    const Vector &a = corners[i % n], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    return cross(b - a, c - b);
  };
  const Vector normal = turn(0);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_GT(dot(turn(i), normal), 0);
    EXPECT_EQ(dot(corners[i] - corners[0], normal), 0);
    // No corner is on the right of an edge, so that the polygon goes around once.
    const Vector edge = corners[(i + 1) % n] - corners[i];
    for (const Vector& c : corners) EXPECT_GE(dot(cross(edge, c - corners[i]), normal), 0);
  }
  return normal;
}

std::vector<Vector> corners_of(const MinkowskiSum3& sum, const std::vector<Vector>& at, std::size_t f) {
  std::vector<Vector> corners;
  for (const std::uint32_t c : sum.face(f)) corners.push_back(at[c]);
  return corners;
}

void prove(const MinkowskiSum3& sum, const std::set<Vector>& all) {
  const std::vector<Vector> at = vertices(sum);
  const std::set<Vector> distinct(at.begin(), at.end());
  ASSERT_EQ(distinct.size(), at.size());
  for (const Vector& v : at) ASSERT_TRUE(all.contains(v));
  ASSERT_EQ(sum.dimension, dimension_of(all));
  ASSERT_EQ(at[0], *all.begin());
  if (sum.dimension < 2) {
    ASSERT_EQ(at.size(), static_cast<std::size_t>(sum.dimension + 1));
    ASSERT_EQ(at.back(), *all.rbegin());
    ASSERT_EQ(sum.face_count(), 0u);
    return;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sides;
  std::vector<Vector> normals;
  for (std::size_t f = 0; f < sum.face_count(); ++f) {
    ASSERT_GE(sum.face(f).size(), 3u);
    const std::vector<Vector> corners = corners_of(sum, at, f);
    normals.push_back(normal_of(corners));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto face = sum.face(f);
      ASSERT_TRUE(sides.emplace(std::pair(face[i], face[(i + 1) % face.size()]), f).second);
    }
    if (sum.dimension == 3) {
      for (const Vector& p : all) ASSERT_LE(dot(p - corners[0], normals[f]), 0);
    }
  }
  if (sum.dimension == 2) {
    ASSERT_EQ(sum.face_count(), 1u);
    const std::vector<Vector> corners = corners_of(sum, at, 0);
    ASSERT_EQ(corners.size(), at.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector edge = corners[(i + 1) % corners.size()] - corners[i];
      for (const Vector& p : all) ASSERT_GE(dot(cross(edge, p - corners[i]), normals[0]), 0);
    }
    const Vector& n = normals[0];
    ASSERT_GT(n[2] != 0 ? n[2] : n[0] != 0 ? n[0] : n[1], 0);
    return;
  }
  for (const auto& [edge, f] : sides) {
    const auto other = sides.find({edge.second, edge.first});
    ASSERT_NE(other, sides.end());
    ASSERT_FALSE(is_zero(cross(normals[f], normals[other->second])));  // coplanar faces are one
  }
  ASSERT_EQ(at.size() + sum.face_count(), sides.size() / 2 + 2);
}

/// By a plane between them: its normal is the shortest way of two corners, across an edge, or across two.
bool apart(Span a, Span b) {
  std::vector<Vector> ways;
  for (const Span s : {a, b}) {
    for (const Point3& p : s) {
      for (const Point3& q : s) ways.push_back(exact(p) - exact(q));
    }
  }
  const auto parts = [&](const Vector& n) {
    std::vector<mpq_class> of_a, of_b;
    for (const Point3& p : a) of_a.push_back(dot(n, exact(p)));
    for (const Point3& p : b) of_b.push_back(dot(n, exact(p)));
    return std::ranges::max(of_a) < std::ranges::min(of_b);
  };
  for (const Point3& p : a) {
    for (const Point3& q : b) {
      const Vector way = exact(q) - exact(p);
      if (parts(way)) return true;
      for (const Vector& edge : ways) {
        if (parts(cross(cross(edge, way), edge))) return true;
      }
    }
  }
  for (const Vector& edge : ways) {
    for (const Vector& other : ways) {
      if (parts(cross(edge, other))) return true;
    }
  }
  return false;
}

std::vector<Point3> cloud(Entropy& entropy, std::size_t most) {
  std::vector<Point3> points = points3(any_family(entropy), Degeneracy::coplanar, 1 + entropy.below(most), entropy);
  const std::uint64_t kind = entropy.below(6);
  if (kind == 0) return points;
  const auto size = static_cast<std::int64_t>(1 + entropy.below(3));
  for (Point3& p : points) {
    p = {static_cast<double>(entropy.within(size)), static_cast<double>(entropy.within(size)),
         kind == 1 ? 0 : static_cast<double>(entropy.within(size))};
    if (kind == 2) p = {p.x, 2 * p.x, 0};
  }
  return points;
}

TEST(Minkowski3, IsTheHullOfAllSums) {
  std::map<int, int> dimensions;
  for (std::uint64_t index = 0; index < 500; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(71, " << index << ")");
    Entropy entropy(71, index);
    const std::vector<Point3> a = cloud(entropy, 9), b = cloud(entropy, 9);
    const MinkowskiSum3 sum = minkowski_sum(a, b);
    ASSERT_NO_FATAL_FAILURE(prove(sum, pairs(a, b, 1)));
    const MinkowskiSum3 difference = minkowski_difference(a, b);
    ASSERT_NO_FATAL_FAILURE(prove(difference, pairs(a, b, -1)));
    for (const SumVertex3& v : difference.vertices) {
      ASSERT_EQ(v.a, a[v.index_a]);
      ASSERT_EQ(v.b, (Point3{-b[v.index_b].x, -b[v.index_b].y, -b[v.index_b].z}));
    }
    const std::vector<Vector> one = vertices(sum), other = vertices(minkowski_sum(b, a));
    ASSERT_EQ(std::set<Vector>(one.begin(), one.end()), std::set<Vector>(other.begin(), other.end()));
    ++dimensions[sum.dimension];
  }
  for (int d = 0; d <= 3; ++d) EXPECT_GT(dimensions[d], d == 0 ? 2 : 15) << d;
}

TEST(Minkowski3, ContainsTheOriginWhereShapesMeet) {
  std::map<Location, int> seen;
  for (std::uint64_t index = 0; index < 400; ++index) {
    SCOPED_TRACE(::testing::Message() << "Entropy(72, " << index << ")");
    Entropy entropy(72, index);
    const std::vector<Point3> a = cloud(entropy, 5), b = cloud(entropy, 5);
    const MinkowskiSum3 difference = minkowski_difference(a, b);
    ASSERT_EQ(contains_origin(difference), !apart(a, b));
    ++seen[locate(difference, {0, 0, 0})];
    // Every vertex is on the boundary, where it is a double.
    for (const SumVertex3& v : difference.vertices) {
      const Point3 p{v.a.x + v.b.x, v.a.y + v.b.y, v.a.z + v.b.z};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
      const bool held = exact(p) == exact(v.a) + exact(v.b);
      ASSERT_TRUE(!held || locate(difference, p) == Location::boundary);
    }
  }
  EXPECT_GT(seen[Location::outside], 100);
  EXPECT_GT(seen[Location::boundary], 20);
  EXPECT_GT(seen[Location::inside], 20);
}

std::vector<Point3> box(double x, double y, double z) {
  std::vector<Point3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0});
  return corners;
}

TEST(Minkowski3, OfBoxesMergesTheirFaces) {
  const MinkowskiSum3 sum = minkowski_sum(box(1, 2, 3), box(4, 5, 6));
  EXPECT_EQ(sum.vertices.size(), 8u);
  EXPECT_EQ(sum.face_count(), 6u);
  EXPECT_EQ(rounded_vertices(sum)[0], (Point3{0, 0, 0}));
  EXPECT_EQ(locate(sum, {5, 7, 9}), Location::boundary);
  EXPECT_EQ(locate(sum, {5, 7, std::nextafter(9.0, 10.0)}), Location::outside);
  EXPECT_EQ(locate(sum, {std::nextafter(5.0, 0.0), 1, 1}), Location::inside);
  // A cube and an octahedron: their 8 and 6 faces, and a rectangle for each of the cube's edges.
  const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const MinkowskiSum3 both = minkowski_sum(box(1, 1, 1), octahedron);
  EXPECT_EQ(both.face_count(), 26u);
  EXPECT_EQ(both.vertices.size(), 24u);
}

// A point moves a shape, an edge sweeps it, and a shape added to itself is twice as large.
TEST(Minkowski3, OfAPointASegmentAndItself) {
  const std::vector<Point3> cube = box(2, 2, 2), point{{10, 20, 30}}, edge{{0, 0, 0}, {1, 2, 5}};
  const ConvexPolyhedron3 solid = convex_polyhedron(convex_hull(cube), cube);
  std::vector<Point3> moved = rounded_vertices(minkowski_sum(cube, point));
  EXPECT_EQ(moved.size(), 8u);
  for (const Point3& p : cube) EXPECT_EQ(std::ranges::count(moved, Point3{p.x + 10, p.y + 20, p.z + 30}), 1);
  EXPECT_EQ(minkowski_sum(cube, edge).face_count(), 12u);
  const MinkowskiSum3 twice = minkowski_sum(solid, solid);
  EXPECT_EQ(twice.vertices.size(), 8u);
  for (const SumVertex3& v : twice.vertices) EXPECT_EQ(v.index_a, v.index_b);
  EXPECT_EQ(locate(minkowski_difference(solid, solid), {0, 0, 0}), Location::inside);
  EXPECT_EQ(minkowski_sum(cube, Span()).dimension, -1);
  EXPECT_FALSE(contains_origin(minkowski_sum(Span(), cube)));
  EXPECT_THROW(minkowski_sum(cube, std::vector<Point3>{{0, INFINITY, 0}}), NonFinite);
}

// Two polyhedra of some hundred vertices each: hull of all 40,000 sums, found along the edges alone.
TEST(Minkowski3, OfManyVertices) {
  const auto ball = [](std::uint64_t start) {
    Entropy entropy(start, 0);
    std::vector<Point3> points;
    while (points.size() < 200) {
      const Point3 p{signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)};
      const double r = std::hypot(p.x, p.y, p.z);
      if (r > 0.1 && r < 1) points.push_back({p.x / r, p.y / r, p.z / r});
    }
    return points;
  };
  const std::vector<Point3> a = ball(73), b = ball(74);
  const MinkowskiSum3 sum = minkowski_sum(a, b);
  const Hull3 nearly = convex_hull(rounded_vertices(sum), {.triangulate = true});
  EXPECT_EQ(nearly.vertices.size(), sum.vertices.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::size_t f = 0; f < sum.face_count(); ++f) {
    const auto face = sum.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) sides.insert({face[i], face[(i + 1) % face.size()]});
  }
  EXPECT_EQ(sides.size(), sum.corners.size());
  EXPECT_EQ(sum.vertices.size() + sum.face_count(), sides.size() / 2 + 2);
}

}  // namespace
}  // namespace plumb

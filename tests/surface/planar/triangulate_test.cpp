// Triangulation: simple polygons are tiled by triangles of positive area, seen along every axis and at every scale.
#include "plumb/surface/planar/triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <numeric>
#include <random>

#include "certify/sanitized.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

using Grid = std::vector<std::array<long, 2>>;

long turn(const std::array<long, 2>& a, const std::array<long, 2>& b, const std::array<long, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool on_segment(const std::array<long, 2>& a, const std::array<long, 2>& b, const std::array<long, 2>& p) {
  return turn(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

bool touch(const Grid& g, std::size_t i, std::size_t j) {
  const auto &a = g[i], &b = g[(i + 1) % g.size()], &c = g[j], &d = g[(j + 1) % g.size()];
  const auto sign = [](long x) { return (x > 0) - (x < 0); };
  if (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

// Edges meet in common corners only, and do not turn back.
bool is_simple(const Grid& g) {
  const std::size_t n = g.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (on_segment(g[i], g[(i + 1) % n], g[(i + 2) % n]) || on_segment(g[(i + 1) % n], g[(i + 2) % n], g[i]))
      return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && touch(g, i, j)) return false;
  }
  return true;
}

long twice_area(const Grid& g) {
  long area = 0;
  for (std::size_t k = 1; k + 1 < g.size(); ++k) area += turn(g[0], g[k], g[k + 1]);
  return area;
}

struct Cut {
  bool simple;
  std::vector<TriangleMesh::Triangle> triangles;
};

// The polygon seen along an axis, lifted to an oblique plane (the same seen along it), at a scale.
Cut cut(const Grid& g, int axis = 2, double scale = 1) {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners(g.size());
  std::iota(corners.begin(), corners.end(), 0U);
  for (const auto& [x, y] : g) {
    const double u = static_cast<double>(x) * scale, v = static_cast<double>(y) * scale, w = u * 0.25 - v * 0.5;
    vertices.push_back(axis == 0 ? Point3{w, u, v} : axis == 1 ? Point3{v, w, u} : Point3{u, v, w});
  }
  Cut found{};
  found.simple = triangulate_face(vertices, corners, found.triangles);
  return found;
}

// What holds of every polygon: n - 2 triangles, whose edges add up to those of the polygon.
void expect_boundary(const Grid& g, const std::vector<TriangleMesh::Triangle>& triangles) {
  ASSERT_EQ(triangles.size(), g.size() - 2);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  const auto add = [&](std::uint32_t a, std::uint32_t b, int by) { directed[std::minmax(a, b)] += a < b ? by : -by; };
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
  const auto n = static_cast<std::uint32_t>(g.size());
  for (std::uint32_t k = 0; k < n; ++k) add(k, (k + 1) % n, -1);
  for (const auto& [edge, count] : directed) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
}

// Tiled: every triangle turns as the polygon does.  `flat` triangles are allowed where the polygon touches itself.
void expect_tiled(const Grid& g, bool flat = false) {
  SCOPED_TRACE(testing::PrintToString(g));
  for (const int axis : {0, 1, 2})
    for (const double scale : {1.0, 0x1p1018, 0x1p-1072}) {
      const Cut found = cut(g, axis, scale);
      EXPECT_TRUE(found.simple);
      expect_boundary(g, found.triangles);
      long sum = 0;
      for (const auto& t : found.triangles) {
        const long area = turn(g[t[0]], g[t[1]], g[t[2]]) * (twice_area(g) > 0 ? 1 : -1);
        EXPECT_TRUE(area > 0 || (flat && area == 0)) << t[0] << " " << t[1] << " " << t[2];
        sum += area;
      }
      EXPECT_EQ(sum, std::labs(twice_area(g)));
    }
}

TEST(Triangulate, RandomSimplePolygons) {
  std::mt19937 random(3);
  int simple = 0, straight = 0, concave = 0;
  for (int round = 0; round < battery::fitting(200'000); ++round) {
    Grid g(4 + random() % 6);
    for (auto& p : g) p = {static_cast<long>(random() % 5), static_cast<long>(random() % 5)};
    if (!is_simple(g)) continue;
    ++simple;
    const long way = twice_area(g);
    for (std::size_t k = 0; k < g.size(); ++k) {
      const long t = turn(g[k], g[(k + 1) % g.size()], g[(k + 2) % g.size()]);
      straight += t == 0;
      concave += t != 0 && (t > 0) != (way > 0);
    }
    expect_tiled(g);
    if (testing::Test::HasFailure()) {
      for (const auto& p : g) std::cout << p[0] << "," << p[1] << " ";
      return;
    }
  }
  const int least = battery::fitting(1'000);
  EXPECT_GT(simple, 2 * least);
  EXPECT_GT(straight, least);
  EXPECT_GT(concave, least);
}

// A square with one or two holes, joined to it by bridges that are walked both ways.
TEST(Triangulate, RandomHoles) {
  std::mt19937 random(8);
  int holes = 0;
  while (holes < battery::fitting(1500)) {
    Grid hole(3 + random() % 6);
    const long at = 1 + holes % 3;
    for (auto& p : hole) p = {at + static_cast<long>(random() % 5), at + static_cast<long>(random() % 5)};
    if (!is_simple(hole)) continue;
    if (twice_area(hole) > 0) std::reverse(hole.begin(), hole.end());
    // Nothing of the hole lies between the corner at the origin and the hole's corner nearest to it along the diagonal.
    const auto nearest = std::min_element(hole.begin(), hole.end(),
                                          [](const auto& l, const auto& r) { return l[0] + l[1] < r[0] + r[1]; });
    std::rotate(hole.begin(), nearest, hole.end());
    Grid g{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}};
    g.insert(g.end(), hole.begin(), hole.end());
    g.push_back(hole.front());
    if (holes % 2 == 0) {  // its mirror image behind the opposite corner
      for (std::size_t k = 1; k < 4; ++k) g[k] = {g[k][0] * 2, g[k][1] * 2};
      Grid other;
      for (const auto& p : hole) other.push_back({16 - p[0], 16 - p[1]});
      other.push_back(other.front());
      other.push_back({16, 16});
      g.insert(g.begin() + 3, other.begin(), other.end());
    }
    std::rotate(g.begin(), g.begin() + static_cast<long>(random() % g.size()), g.end());
    expect_tiled(g, true);
    ++holes;
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Triangulate, AnyClosedPath) {
  std::mt19937 random(5);
  int fans = 0;
  for (int round = 0; round < battery::fitting(20000); ++round) {
    Grid g(3 + random() % 9);
    for (auto& p : g) p = {static_cast<long>(random() % 4), static_cast<long>(random() % 4)};
    const Cut found = cut(g);
    expect_boundary(g, found.triangles);
    long positive = 0, negative = 0;
    for (const auto& t : found.triangles)
      (turn(g[t[0]], g[t[1]], g[t[2]]) < 0 ? negative : positive) += turn(g[t[0]], g[t[1]], g[t[2]]);
    fans += !found.simple;
    EXPECT_TRUE(!found.simple || positive == 0 || negative == 0);
  }
  EXPECT_GT(fans, battery::fitting(1000));
}

TEST(Triangulate, KnownShapes) {
  expect_tiled({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});                  // L
  expect_tiled({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}});          // corners on straight edges
  expect_tiled({{0, 0}, {6, 0}, {3, 1}, {6, 2}, {3, 3}, {6, 4}, {0, 4}, {2, 2}});  // teeth
  expect_tiled({{0, 0}, {4, 2}, {0, 4}, {1, 2}});                                  // dart: the other diagonal
  expect_tiled({{1, 2}, {0, 0}, {4, 2}, {0, 4}});                                  // and this one
  expect_tiled({{0, 0}, {0, 3}, {3, 3}, {3, 0}, {0, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}}, true);  // keyhole
  expect_tiled({{0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}, {0, 0}}, true);          // repeated corners
  expect_tiled({{0, 0}, {4, 0}, {2, 0}, {4, 4}, {0, 4}}, true);                          // a spike along an edge
  expect_tiled({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, true);  // two squares at a corner
}

TEST(Triangulate, WhatNoAxisShowsAsSimpleIsAFan) {
  for (const Grid& g : {Grid{{0, 0}, {1, 1}, {2, 2}, {3, 3}}, Grid{{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}},
                        Grid{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, Grid{{0, 0}, {3, 3}, {3, 0}, {0, 3}, {1, 5}}}) {
    const Cut found = cut(g);
    EXPECT_FALSE(found.simple);
    expect_boundary(g, found.triangles);
    for (const auto& t : found.triangles) EXPECT_EQ(t[0], 0U);
  }
}

TEST(Triangulate, OtherAxesHelpCrookedFaces) {
  // Seen along z or y, its larger normal components, this face crosses itself; along x it is a square.
  const std::vector<Point3> vertices{{0, 0, 0}, {10, 4, 0}, {5, 4, 4}, {100, 0, 4}};
  std::vector<TriangleMesh::Triangle> out;
  EXPECT_TRUE(triangulate_face(vertices, std::vector<std::uint32_t>{0, 1, 2, 3}, out));
  EXPECT_EQ(out.size(), 2U);
}

TEST(Triangulate, LongCombs) {
  Grid g{{0, -1}};
  for (long k = 0; k < 20000; ++k) g.push_back({20000 - k, k % 2 == 0 ? 100 : 1});
  std::reverse(g.begin() + 1, g.end());
  g.push_back({20001, -1});
  std::reverse(g.begin(), g.end());
  const Cut found = cut(g);
  EXPECT_TRUE(found.simple);
  expect_boundary(g, found.triangles);
}

// A band whose only ears are at its two ends.
TEST(Triangulate, LongSpirals) {
  Grid outside, inside;
  for (long k = 0; k < 2000; ++k) {
    const long r = 4 * (k / 4) + 4;
    const std::array<std::array<long, 2>, 4> way{{{r, -r}, {r, r}, {-r, r}, {-r, -r - 4}}};
    const std::array<std::array<long, 2>, 4> near{{{r - 2, -r + 2}, {r - 2, r - 2}, {-r + 2, r - 2}, {-r + 2, -r - 2}}};
    outside.push_back(way[static_cast<std::size_t>(k % 4)]);
    inside.push_back(near[static_cast<std::size_t>(k % 4)]);
  }
  Grid g = outside;
  g.insert(g.end(), inside.rbegin(), inside.rend());
  ASSERT_TRUE(is_simple(g));
  const Cut found = cut(g);
  EXPECT_TRUE(found.simple);
  expect_boundary(g, found.triangles);
}

TEST(Triangulate, WholeMeshes) {
  const PolygonMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 3, 0, 1, 2, 0, 2, 1, 3, 3, 2, 1, 0}, {0, 4, 7, 11, 15}};
  std::uint64_t fans = 7;
  const TriangleMesh triangles = triangulate(mesh, &fans);
  EXPECT_EQ(triangles.vertices, mesh.vertices);
  EXPECT_EQ(triangles.triangles.size(), 7U);
  EXPECT_EQ(fans, 1U);
  EXPECT_TRUE(triangulate(PolygonMesh{}).triangles.empty());
}

}  // namespace
}  // namespace plumb

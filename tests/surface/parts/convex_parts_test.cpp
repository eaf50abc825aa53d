// Convex parts of solids whose volumes and parts are known, of polycubes from seeds, and of what bounds none.
#include "plumb/surface/parts/convex_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/surface/topology/shells.hpp"
#include "surface/parts/part_laws.hpp"

namespace plumb {
namespace {

using part_laws::expect_parts, solids::append, solids::box, solids::voxels;

std::size_t outer_shells(const TriangleMesh& mesh) {
  const std::vector<Shell> shells = find_shells(mesh).shells;
  return static_cast<std::size_t>(std::ranges::count_if(shells, [](const Shell& s) { return s.depth % 2 == 0; }));
}

ConvexParts checked(const TriangleMesh& mesh) {
  ConvexParts found = convex_parts(mesh);
  expect_parts(mesh, found);
  const std::uint64_t r = found.notches;
  EXPECT_LE(found.parts.size(), outer_shells(mesh) + r * (2 * r + 1));
  return found;
}

TriangleMesh mapped(TriangleMesh mesh, const std::function<Point3(const Point3&)>& to, bool mirrored = false) {
  for (Point3& p : mesh.vertices) p = to(p);
  if (mirrored)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

std::set<solids::Cell> cells(std::initializer_list<solids::Cell> of) { return of; }

TEST(ConvexParts, AConvexSolidIsOnePart) {
  const ConvexParts found = checked(box({0, 0, 0}, {1, 2, 3}));
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.cuts, 0U);
  EXPECT_EQ(found.notches, 0U);
  const ConvexPart& part = found.parts[0];
  EXPECT_EQ(part.solid.vertices.size(), 8U);
  EXPECT_EQ(part.solid.faces(), 6U);
  EXPECT_TRUE(part.is_exact);
  for (std::size_t f = 0; f < 6; ++f) EXPECT_EQ(part.sources_of(f).size(), 2U);
}

TEST(ConvexParts, NoTrianglesNoParts) {
  EXPECT_TRUE(convex_parts({}).parts.empty());
  EXPECT_TRUE(convex_parts({{{0, 0, 0}}, {}}).parts.empty());
}

TEST(ConvexParts, AnLIsTwo) {
  const ConvexParts found = checked(voxels(cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})));
  EXPECT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(found.notches, 1U);
  EXPECT_EQ(found.cuts, 1U);
}

TEST(ConvexParts, ACrossIsThree) {
  const ConvexParts found = checked(voxels(cells({{1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {1, 0, 0}, {1, 2, 0}})));
  EXPECT_EQ(found.parts.size(), 3U);
}

TEST(ConvexParts, CoplanarNotchesAreCutTogether) {
  std::set<solids::Cell> comb;
  for (int x = 0; x < 9; ++x) {
    comb.insert({x, 0, 0});
    if (x % 2 == 0) comb.insert({x, 1, 0});
  }
  const ConvexParts found = checked(voxels(comb));
  EXPECT_EQ(found.notches, 8U);
  EXPECT_EQ(found.cuts, 1U);
  EXPECT_EQ(found.parts.size(), 6U);
}

TEST(ConvexParts, ASectionWithoutANotchIsLeftWhole) {
  // An L and, in the plane of its cut, a bar that the plane does not have to part; all one solid.
  std::set<solids::Cell> cell;
  for (int x = 0; x < 6; ++x) cell.insert({x, 0, 0});
  for (int y = 0; y < 3; ++y) cell.insert({5, y, 0});
  cell.insert({0, 1, 0});
  const ConvexParts found = checked(voxels(cell));
  EXPECT_EQ(found.parts.size(), 3U);
}

TEST(ConvexParts, OfGenusOneAndMore) {
  std::set<solids::Cell> frame;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 3; ++y)
      if (y != 1 || x % 2 == 0) frame.insert({x, y, 0});
  const ConvexParts found = checked(voxels(frame));
  EXPECT_EQ(found.notches, 8U);
  EXPECT_EQ(found.parts.size(), 5U);
  checked(solids::torus(4, 1, 4, 3));
  checked(solids::hollow_torus(4, 1, 3, 3));
}

TEST(ConvexParts, CavitiesAndWhatIsInThem) {
  TriangleMesh mesh = box({0, 0, 0}, {8, 8, 8});
  append(mesh, box({1, 1, 1}, {7, 7, 7}), true);
  ConvexParts found = checked(mesh);
  EXPECT_EQ(found.notches, 12U);
  EXPECT_EQ(found.parts.size(), 6U);
  append(mesh, box({2, 2, 2}, {3, 3, 3}));
  append(mesh, box({4, 4, 4}, {6, 6, 6}));
  append(mesh, box({4.5, 4.5, 4.5}, {5, 5, 5}), true);
  EXPECT_EQ(checked(mesh).parts.size(), 13U);
}

TEST(ConvexParts, TwoCavitiesInOneSolid) {
  TriangleMesh mesh = box({0, 0, 0}, {8, 8, 8});
  append(mesh, box({1, 1, 1}, {3, 3, 3}), true);
  append(mesh, box({4, 5, 4}, {7, 7, 6}), true);
  checked(mesh);
}

TEST(ConvexParts, SolidsThatTouch) {
  // At a vertex, at an edge, at part of an edge, at a wall, at part of a wall.
  for (const Point3& at :
       {Point3{1, 1, 1}, Point3{1, 1, 0}, Point3{1, 1, 0.5}, Point3{1, 0, 0}, Point3{1, 0.25, 0.5}}) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    append(mesh, box(at, {at.x + 1, at.y + 1, at.z + 1}));
    EXPECT_EQ(checked(mesh).parts.size(), 2U);
  }
  EXPECT_EQ(checked(voxels(cells({{0, 0, 0}, {1, 1, 0}}))).parts.size(), 2U) << "one edge of four faces";
  EXPECT_EQ(checked(voxels(cells({{0, 0, 0}, {1, 1, 1}}))).parts.size(), 2U) << "one vertex";
}

TEST(ConvexParts, ASolidThatTouchesItself) {
  // A ring of cubes whose ends meet at an edge, and at a vertex.
  checked(voxels(cells(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 1, 1}, {0, 2, 1}, {0, 2, 0}, {0, 1, 0}})));
  checked(voxels(cells({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 1}, {2, 1, 1}, {0, 1, 0}})));
  checked(voxels(cells({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}})));
}

TEST(ConvexParts, Polycubes) {
  std::size_t most = 0, several = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const int size = 2 + static_cast<int>(seed % 3);
    std::set<solids::Cell> filled;
    for (int i = 0; i < size * size * size; ++i)
      if (random() % 5 < 2 + seed % 2) filled.insert({i % size, i / size % size, i / size / size});
    const ConvexParts found = checked(voxels(filled));
    EXPECT_EQ(part_laws::volume_of(found), Rational(filled.size()));
    EXPECT_LE(found.parts.size(), filled.size());
    most = std::max(most, found.parts.size());
    several += found.parts.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(most, 12U);
  EXPECT_GT(several, 30U);
}

TEST(ConvexParts, StarsAreCutThroughTheirNotches) {
  for (const std::uint32_t rays : {3U, 4U, 5U}) {
    std::vector<Point2> polygon;
    for (std::uint32_t i = 0; i < 2 * rays; ++i) {
      const double turn = M_PI * i / rays, r = i % 2 == 0 ? 1 : 3;
      polygon.push_back({r * std::cos(turn), r * std::sin(turn)});
    }
    TriangleMesh mesh = solids::walls(polygon);
    // Caps over and under the middle, so that notches meet at a vertex.
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, -1.5}, {0, 0, 2}});
    for (std::uint32_t i = 0; i < n; i += 2) {
      mesh.triangles.push_back({i, n, (i + 2) % n});
      mesh.triangles.push_back({i + 1, (i + 3) % n, n + 1});
    }
    const ConvexParts found = checked(mesh);
    EXPECT_GE(found.notches, rays);
    EXPECT_GE(found.parts.size(), (rays + 1) / 2);
  }
}

TEST(ConvexParts, MovedMirroredScaledAndTurned) {
  const TriangleMesh mesh =
      voxels(cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1}}));
  const std::size_t parts = checked(mesh).parts.size();
  for (const double scale : {0x1p300, 0x1p-300, 3.0})
    EXPECT_EQ(checked(mapped(mesh,
                             [scale](const Point3& p) {
                               return Point3{scale * p.x, scale * p.y, scale * p.z};
                             }))
                  .parts.size(),
              parts);
  EXPECT_EQ(checked(mapped(mesh,
                           [](const Point3& p) {
                             return Point3{p.x + 1e9, p.y - 7, p.z + 0.1};
                           }))
                .parts.size(),
            parts);
  checked(mapped(
      mesh,
      [](const Point3& p) {
        return Point3{-p.x, p.y, p.z};
      },
      true));
  checked(solids::turned(mesh));
}

TEST(ConvexParts, OneUlpMakesNotches) {
  // A box whose faces are no planes: each fold is a notch or none.
  std::size_t notches = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh mesh = mapped(box({1, 1, 1}, {1.5, 1.75, 1.5}), [&](const Point3& p) {
      const auto off = [&](double x) { return random() % 3 == 0 ? std::nextafter(x, random() % 2 == 0 ? 0 : 4) : x; };
      return Point3{off(p.x), off(p.y), off(p.z)};
    });
    notches += checked(mesh).notches;
  }
  EXPECT_GT(notches, 20U);
}

TEST(ConvexParts, TheOrderOfTheMeshChangesNothing) {
  const TriangleMesh mesh = solids::turned(voxels(
      cells({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 2, 2}, {2, 2, 0}})));
  const ConvexParts found = checked(mesh);
  EXPECT_GT(found.parts.size(), 4U);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::vector<std::uint32_t> vertex(mesh.vertices.size()), triangle(mesh.triangles.size());
    std::iota(vertex.begin(), vertex.end(), 0U);
    std::iota(triangle.begin(), triangle.end(), 0U);
    std::ranges::shuffle(vertex, random);
    std::ranges::shuffle(triangle, random);
    TriangleMesh other;
    other.vertices.resize(vertex.size());
    for (std::size_t v = 0; v < vertex.size(); ++v) other.vertices[vertex[v]] = mesh.vertices[v];
    for (const std::uint32_t t : triangle) {
      TriangleMesh::Triangle corners = mesh.triangles[t];
      std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random() % 3), corners.end());
      for (std::uint32_t& v : corners) v = vertex[v];
      other.triangles.push_back(corners);
    }
    const ConvexParts again = convex_parts(other);
    ASSERT_EQ(again.parts.size(), found.parts.size());
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
      EXPECT_TRUE(again.parts[i].solid == found.parts[i].solid);
      std::vector<std::uint32_t> sources = again.parts[i].sources;
      for (std::uint32_t& t : sources) t = triangle[t];
      for (std::size_t f = 0; f < again.parts[i].solid.faces(); ++f)
        std::sort(sources.begin() + again.parts[i].first_source[f],
                  sources.begin() + again.parts[i].first_source[f + 1]);
      EXPECT_EQ(sources, found.parts[i].sources);
    }
  }
}

TEST(ConvexParts, PointsAreInThePartsWhereTheyAreInTheSolid) {
  const TriangleMesh mesh = solids::torus(2, 1, 4, 3);
  const ConvexParts found = checked(mesh);
  std::vector<Point3> points = mesh.vertices;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    points.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
  }
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> at(-3, 3);
  for (int i = 0; i < 300; ++i) points.push_back({at(random), at(random), at(random) / 3});
  part_laws::expect_same_points(mesh, found, points);
}

std::string refusal(const TriangleMesh& mesh) {
  try {
    convex_parts(mesh);
  } catch (const Error& e) {
    return e.what();
  }
  return "none";
}

TEST(ConvexParts, WhatBoundsNoSolidIsRefusedByName) {
  const TriangleMesh cube = box({0, 0, 0}, {1, 1, 1});
  TriangleMesh open = cube;
  open.triangles.erase(open.triangles.begin() + 3);
  EXPECT_NE(refusal(open).find("the mesh is open at the edge from ("), std::string::npos) << refusal(open);
  TriangleMesh against = cube;
  std::swap(against.triangles[5][0], against.triangles[5][1]);
  EXPECT_NE(refusal(against).find("run against each other along the edge"), std::string::npos) << refusal(against);
  EXPECT_NE(refusal(against).find("5"), std::string::npos) << refusal(against);
  TriangleMesh inward = cube;
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(refusal(inward).find("inside out"), std::string::npos) << refusal(inward);
  TriangleMesh crossing = cube;
  append(crossing, box({0.5, 0.5, 0.5}, {2, 2, 2}));
  EXPECT_NE(refusal(crossing).find("cross"), std::string::npos) << refusal(crossing);
  TriangleMesh twice = cube;
  append(twice, cube);
  EXPECT_NE(refusal(twice), "none");
  TriangleMesh nested = cube;
  append(nested, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}));
  EXPECT_NE(refusal(nested).find("inside out"), std::string::npos) << refusal(nested);
  TriangleMesh flat = cube;
  flat.triangles.push_back({0, 1, 0});
  EXPECT_NE(refusal(flat).find("triangle 12 has no area"), std::string::npos) << refusal(flat);
  TriangleMesh missing = cube;
  missing.triangles[2][1] = 99;
  EXPECT_NE(refusal(missing).find("names vertex 99, and there are 8"), std::string::npos) << refusal(missing);
  TriangleMesh nan = cube;
  nan.vertices[3].y = NAN;
  EXPECT_THROW(convex_parts(nan), NonFinite);
  nan.vertices[3].y = -INFINITY;
  EXPECT_THROW(convex_parts(nan), NonFinite);
}

}  // namespace
}  // namespace plumb

// The arrangement of heaps of tetrahedra that touch and cross: windings beside each facet by definition, facets apart,
// and the same however the input is shuffled.
#include "plumb/surface/solid/arrangement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "plumb/arith/error.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_windings;
using solids::box, solids::heap;

/// Vertices, triangles and their corners in another order; the shape stays.
TriangleMesh shuffled(const TriangleMesh& mesh, std::mt19937_64& random) {
  std::vector<std::uint32_t> to(mesh.vertices.size());
  std::iota(to.begin(), to.end(), 0U);
  std::shuffle(to.begin(), to.end(), random);
  TriangleMesh other;
  other.vertices.resize(to.size());
  for (std::size_t v = 0; v < to.size(); ++v) other.vertices[to[v]] = mesh.vertices[v];
  for (auto corners : mesh.triangles) {
    for (auto& v : corners) v = to[v];
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random() % 3), corners.end());
    other.triangles.push_back(corners);
  }
  std::shuffle(other.triangles.begin(), other.triangles.end(), random);
  return other;
}

TEST(Arrangement, WindingsOfHeapsByDefinition) {
  std::size_t facets = 0, wound_otherwise = 0, unlucky = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<TriangleMesh> meshes{heap(random, 3, 2), heap(random, 2, 2), heap(random, 1, 3)};
    const Arrangement all = arrange(meshes);
    unlucky += expect_windings(meshes, all, 7);
    facets += all.facets.size();
    for (const std::int32_t w : all.windings) wound_otherwise += w < 0 || w > 1;
    if (HasFailure()) return;
  }
  EXPECT_GT(facets, 1000U);
  EXPECT_GT(wound_otherwise, 20U);
  EXPECT_LT(100 * unlucky, facets);
}

TEST(Arrangement, TheOrderOfTheInputChangesNothing) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = heap(random, 4, 2), b = heap(random, 3, 2);
    const Arrangement one = arrange(std::vector{a, b});
    const Arrangement other = arrange(std::vector{shuffled(b, random), shuffled(a, random)});
    EXPECT_EQ(one.facets, other.facets);
    EXPECT_EQ(one.sides, other.sides);
    EXPECT_EQ(one.first_source, other.first_source);
    ASSERT_EQ(one.windings.size(), other.windings.size());
    for (std::size_t i = 0; i < one.windings.size(); ++i) EXPECT_EQ(one.windings[i], other.windings[i ^ 1U]);
    ASSERT_EQ(one.vertices.size(), other.vertices.size());
    for (std::size_t v = 0; v < one.vertices.size(); ++v) {
      EXPECT_EQ(one.vertices[v].as().index(), other.vertices[v].as().index());
      EXPECT_TRUE(one.vertices[v] == other.vertices[v]);
    }
  }
}

TEST(Arrangement, FacesThatNothingCutsStayAsGiven) {
  const TriangleMesh a = box({0.1, 0.2, 0.3}, {1, 1, 1});
  const std::vector<TriangleMesh> meshes{a, box({5, 5, 5}, {6, 6, 6})};
  const Arrangement all = arrange(meshes);
  ASSERT_EQ(all.facets.size(), 24U);
  EXPECT_EQ(all.vertices.size(), 16U);
  for (const ExactPoint3& p : all.vertices) EXPECT_TRUE(std::holds_alternative<Point3>(p.as()));
  for (std::size_t f = 0; f < 24; ++f) {
    ASSERT_EQ(all.sources_of(f).size(), 1U);
    const SourceFace from = all.sources_of(f)[0].face;
    std::vector<Point3> told, given;
    for (const std::uint32_t v : all.facets[f]) told.push_back(std::get<Point3>(all.vertices[v].as()));
    for (const std::uint32_t v : meshes[from.mesh].triangles[from.triangle])
      given.push_back(meshes[from.mesh].vertices[v]);
    EXPECT_TRUE(std::ranges::is_permutation(told, given));
  }
}

TEST(Arrangement, WhatCancelsIsGone) {
  TriangleMesh twice = box({0, 0, 0}, {1, 1, 1});
  solids::append(twice, box({0, 0, 0}, {1, 1, 1}), true);
  EXPECT_TRUE(arrange(std::vector{twice}).facets.empty());
  EXPECT_TRUE(arrange(std::vector<TriangleMesh>{}).facets.empty());
  EXPECT_TRUE(arrange(std::vector{TriangleMesh{}}).facets.empty());
}

template <class Failure>
std::string refusal(const TriangleMesh& mesh) {
  try {
    (void)arrange(std::vector{box({0, 0, 0}, {1, 1, 1}), mesh});
  } catch (const Failure& failure) {
    return failure.what();
  }
  return {};
}

TEST(Arrangement, AnUnbalancedEdgeIsToldWithItsEndsAndATriangle) {
  for (const bool is_open : {true, false}) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    if (is_open) mesh.triangles.pop_back();
    if (!is_open) std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    try {
      (void)arrange(std::vector{box({0, 0, 0}, {1, 1, 1}), mesh});
      FAIL();
    } catch (const UnbalancedEdge& e) {
      EXPECT_EQ(e.is_open, is_open);
      EXPECT_EQ(e.face.mesh, 1U);
      ASSERT_LT(e.face.triangle, mesh.triangles.size());
      for (const Point3& end : e.edge) {
        EXPECT_TRUE(std::ranges::any_of(mesh.triangles[e.face.triangle], [&](std::uint32_t v) {
          const Point3& p = mesh.vertices[v];
          return p.x == end.x && p.y == end.y && p.z == end.z;
        }));
      }
      EXPECT_EQ(compare_xyz(e.edge[0], e.edge[1]), Sign::negative);
    }
  }
}

TEST(Arrangement, BadInputIsRefusedByName) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_NE(refusal<InvalidShape>(open).find("the mesh is open at the edge from ("), std::string::npos);
  TriangleMesh against = box({0, 0, 0}, {1, 1, 1});
  std::swap(against.triangles[4][0], against.triangles[4][1]);
  EXPECT_NE(refusal<InvalidShape>(against).find("triangles run against each other along the edge"), std::string::npos);
  EXPECT_NE(refusal<InvalidShape>(against).find("of mesh 1"), std::string::npos);
  TriangleMesh beyond = box({0, 0, 0}, {1, 1, 1});
  beyond.triangles[7][1] = 8;
  EXPECT_EQ(refusal<InvalidShape>(beyond), "arrange: triangle 7 of mesh 1 names vertex 8, and there are 8");
  TriangleMesh infinite = box({0, 0, 0}, {1, 1, 1});
  infinite.vertices[2].y = HUGE_VAL;
  EXPECT_NE(refusal<NonFinite>(infinite).find("arrange: vertex 2 of mesh 1 is ("), std::string::npos);
}

}  // namespace
}  // namespace plumb

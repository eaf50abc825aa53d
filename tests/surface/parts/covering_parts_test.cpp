// Covering parts hold their shares, and reach no farther beyond them than they say.
#include "plumb/surface/parts/covering_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "figure/basic/solids.hpp"
#include "plumb/query/closest/closest.hpp"
#include "surface/parts/part_laws.hpp"

namespace plumb {
namespace {

using part_laws::exact, part_laws::Exact3, query::operator-;

bool holds(const HullProxy& proxy, const Exact3& p) {
  for (std::size_t f = 0; f < proxy.hull.face_count(); ++f) {
    const auto ids = proxy.hull.face(f);
    const Exact3 a = exact(proxy.vertices[ids[0]]);
    const Exact3 normal = query::cross(exact(proxy.vertices[ids[1]]) - a, exact(proxy.vertices[ids[2]]) - a);
    if (sgn(query::dot(normal, p - a)) > 0) return false;
  }
  return true;
}

/// From its faces, as doubles have it; nothing where the point is inside.
double distance_from(const ConvexPart& part, const std::vector<Exact3>& at, const Point3& p) {
  if (part_laws::holds(part, at, exact(p))) return 0;
  const PolygonMesh mesh = rounded(part);
  double nearest = INFINITY;
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    for (std::uint32_t i = mesh.first[f] + 2; i < mesh.first[f + 1]; ++i) {
      const Triangle3 t{mesh.vertices[mesh.corners[mesh.first[f]]], mesh.vertices[mesh.corners[i - 1]],
                        mesh.vertices[mesh.corners[i]]};
      nearest = std::min(nearest, distance(p, t));
    }
  }
  return nearest;
}

/// Of points of the hull's surface, the greatest distance from the share, as doubles have it.
double sampled_reach(const ConvexParts& parts, const CoveringPart& part, std::mt19937_64& random) {
  std::vector<std::vector<Exact3>> corners;
  for (const std::uint32_t i : part.share) corners.push_back(part_laws::corners_of(parts.parts[i]));
  std::uniform_real_distribution<double> unit(0, 1);
  double most = 0;
  for (std::size_t f = 0; f < part.proxy.hull.face_count(); ++f) {
    const auto ids = part.proxy.hull.face(f);
    for (std::size_t i = 2; i < ids.size(); ++i) {
      for (int k = 0; k < 4; ++k) {
        const double s = unit(random), t = (1 - s) * unit(random);
        const Point3 &a = part.proxy.vertices[ids[0]], &b = part.proxy.vertices[ids[i - 1]],
                     &c = part.proxy.vertices[ids[i]];
        const Point3 p{a.x + s * (b.x - a.x) + t * (c.x - a.x), a.y + s * (b.y - a.y) + t * (c.y - a.y),
                       a.z + s * (b.z - a.z) + t * (c.z - a.z)};
        double nearest = INFINITY;
        for (std::size_t q = 0; q < corners.size() && nearest > 0; ++q)
          nearest = std::min(nearest, distance_from(parts.parts[part.share[q]], corners[q], p));
        most = std::max(most, nearest);
      }
    }
  }
  return most;
}

CoveringParts checked(const TriangleMesh& mesh, const CoveringOptions& options) {
  const CoveringParts found = covering_parts(mesh, options);
  std::vector<std::uint32_t> shared(found.exact.parts.size(), 0);
  std::mt19937_64 random(1);
  for (const CoveringPart& part : found.parts) {
    EXPECT_TRUE(std::ranges::is_sorted(part.share));
    for (const std::uint32_t i : part.share) {
      ++shared[i];
      for (const ExactPoint3& p : found.exact.parts[i].solid.vertices) EXPECT_TRUE(holds(part.proxy, exact(p)));
    }
    EXPECT_LE(sampled_reach(found.exact, part, random), part.concavity + 1e-12);
    EXPECT_TRUE(options.most_parts || part.concavity <= std::max(options.concavity, 1e-12)) << part.concavity;
  }
  for (const std::uint32_t n : shared) EXPECT_EQ(n, 1U);
  for (const Point3& p : mesh.vertices)
    EXPECT_TRUE(std::ranges::any_of(found.parts, [&](const CoveringPart& c) { return holds(c.proxy, exact(p)); }));
  EXPECT_LE(found.parts.size(), options.most_parts.value_or(1'000'000));
  return found;
}

TriangleMesh staircase(int steps) {
  std::set<solids::Cell> cells;
  for (int x = 0; x < steps; ++x)
    for (int y = 0; y <= x; ++y) cells.insert({x, y, 0});
  return solids::voxels(cells);
}

TEST(CoveringParts, WithoutConcavityTheyAreTheExactParts) {
  const CoveringParts found = checked(staircase(4), {});
  EXPECT_EQ(found.parts.size(), found.exact.parts.size());
  for (const CoveringPart& part : found.parts) EXPECT_EQ(part.concavity, 0);
}

TEST(CoveringParts, AStaircaseIsOnePartWhereItsStepsMayBeFilled) {
  // The slope passes a step's inner corner at half the diagonal of its square; a step's faces are nearest to it there.
  const CoveringParts found = checked(staircase(4), {.concavity = 0.75});
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_GE(found.parts[0].concavity, 0.5);
  EXPECT_LE(found.parts[0].concavity, 0.5 * 1.06);
  EXPECT_GT(checked(staircase(4), {.concavity = 0.4}).parts.size(), 1U);
}

TEST(CoveringParts, MoreConcavityFewerParts) {
  const TriangleMesh mesh = solids::torus(4, 1, 5, 3);
  std::size_t before = 1'000'000;
  for (const double concavity : {0.0, 0.5, 8.0}) {
    const CoveringParts found = checked(mesh, {.concavity = concavity});
    EXPECT_LE(found.parts.size(), before);
    before = found.parts.size();
  }
  EXPECT_EQ(before, 1U) << "a ring whose hole is less than 8 across";
}

TEST(CoveringParts, AsFewAsAreAskedFor) {
  TriangleMesh mesh = staircase(3);
  solids::append(mesh, solids::box({100, 0, 0}, {101, 1, 1}));
  for (const std::uint32_t most : {1U, 2U, 3U}) {
    const CoveringParts found = checked(mesh, {.most_parts = most});
    EXPECT_EQ(found.parts.size(), most);
    EXPECT_EQ(found.parts[0].concavity > 1, most == 1);
  }
  EXPECT_EQ(checked(mesh, {.concavity = 0.75, .most_parts = 50}).parts.size(), 2U);
}

TEST(CoveringParts, CornersThatAreNoDoublesAreHeld) {
  const CoveringParts found = checked(solids::torus(2, 1, 4, 3), {});
  EXPECT_TRUE(std::ranges::any_of(found.exact.parts, [](const ConvexPart& p) { return !p.is_exact; }));
  checked(solids::turned(staircase(3)), {.concavity = 0.25});
}

TEST(CoveringParts, TheCompoundIsAProxyOfTheMesh) {
  const TriangleMesh mesh = solids::torus(2, 1, 5, 3);
  const std::vector<HullProxy> compound = compound_proxy(mesh, {.concavity = 0.5});
  EXPECT_GT(compound.size(), 1U);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1), far(-3, 3);
  const auto held = [&](const Point3& p) {
    return std::ranges::any_of(compound, [&](const HullProxy& h) { return holds(h, exact(p)); });
  };
  for (const Point3& p : mesh.vertices) EXPECT_TRUE(held(p));
  std::size_t inside = 0;
  for (int i = 0; i < 500; ++i) {
    const Point3 p{far(random), far(random), far(random) / 3};
    if (!contains(mesh, p)) continue;
    ++inside;
    EXPECT_TRUE(held(p));
  }
  EXPECT_GT(inside, 50U);
}

TEST(CoveringParts, WhatIsNoLengthIsRefused) {
  EXPECT_THROW(covering_parts(staircase(2), {.concavity = -1}), InvalidShape);
  EXPECT_THROW(covering_parts(staircase(2), {.concavity = NAN}), NonFinite);
  EXPECT_THROW(covering_parts(staircase(2), {.most_parts = 0}), InvalidShape);
  EXPECT_TRUE(covering_parts({}, {.concavity = 1}).parts.empty());
}

}  // namespace
}  // namespace plumb

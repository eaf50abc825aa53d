// Have triangles around a vertex that is called simple nothing in common but what they share, and are vertices of smooth
// surfaces called so?
#include "space/pairs/simple_stars.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figure/basic/shape_cases.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

space::SimpleStars stars_of(const Bvh& bvh, Execution execution = Execution::serial) {
  return {space::SlotMesh<Bvh>(bvh), bvh.slots(), execution};
}
space::SimpleStars stars_of(const TriangleMesh& mesh) { return stars_of(build_bvh(mesh)); }

/// A fan around vertex 0, closed or not; seen from above the corners go round once, or are in any order.
TriangleMesh fan(shape_cases::Material& m) {
  TriangleMesh mesh;
  const std::size_t n = 2 + m.below(6);
  for (std::size_t i = 0; i <= n; ++i) mesh.vertices.push_back(m.point3());
  const auto angle = [&](const Point3& p) { return std::atan2(p.y - mesh.vertices[0].y, p.x - mesh.vertices[0].x); };
  if (m.below(4) != 0) {
    std::sort(mesh.vertices.begin() + 1, mesh.vertices.end(),
              [&](const Point3& p, const Point3& q) { return angle(p) < angle(q); });
  }
  const bool is_closed = m.below(3) != 0;
  for (std::uint32_t i = 1; i + (is_closed ? 0 : 1) <= n; ++i) {
    const std::uint32_t next = i == n ? 1 : i + 1;
    const std::array<std::uint32_t, 3> t{0, i, next};
    const std::size_t k = m.below(3);
    mesh.triangles.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  if (m.below(8) == 0) mesh.triangles.push_back({0, 1, static_cast<std::uint32_t>(m.below(n + 1))});
  return mesh;
}

TEST(SimpleStars, HaveNothingInCommonBeyondWhatIsShared) {
  std::size_t simple = 0, closed = 0, crossing = 0;
  shape_cases::on_shapes(941, 12000, [&](shape_cases::Material& m) {
    const TriangleMesh mesh = fan(m);
    const space::SimpleStars stars = stars_of(mesh);
    const auto& t = mesh.triangles;
    if (stars.has(0)) ++simple, closed += t.size() + 1 == mesh.vertices.size() ? 1U : 0U;
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (std::size_t k = i + 1; k < t.size(); ++k) {
        const Relation relation = relate_in_mesh(mesh.vertices, t[i], t[k]);
        crossing += relation != Relation::disjoint ? 1U : 0U;
        if (!stars.tell_apart(t[i], t[k])) continue;
        EXPECT_EQ(relation, Relation::disjoint) << m.about(mesh.vertices[0]);
      }
    }
  });
  EXPECT_GT(simple, 1000U);
  EXPECT_GT(closed, 400U);
  EXPECT_GT(crossing, 10000U);
}

/// Around a vertex so many turns are gone, in steps of an eighth; from height 0 the corners rise by `rise` each.
TriangleMesh turning_fan(int steps, double rise, bool is_closed) {
  static constexpr std::array<std::array<double, 2>, 8> way{
      {{2, 0}, {2, 2}, {0, 2}, {-2, 2}, {-2, 0}, {-2, -2}, {0, -2}, {2, -2}}};
  TriangleMesh mesh{{{0, 0, 0}}, {}};
  for (int i = 0; i <= steps; ++i) {
    const auto& [x, y] = way[static_cast<std::size_t>(i % 8)];
    mesh.vertices.push_back({x, y, rise * i});
    const auto at = static_cast<std::uint32_t>(i);
    if (i > 0) mesh.triangles.push_back({0, at, at + 1});
  }
  if (is_closed) mesh.triangles.back()[2] = 1, mesh.vertices.pop_back();
  return mesh;
}

TEST(SimpleStars, GoRoundOnce) {
  EXPECT_TRUE(stars_of(turning_fan(8, 0, true)).has(0));
  EXPECT_FALSE(stars_of(turning_fan(16, 0, true)).has(0));
  EXPECT_TRUE(stars_of(turning_fan(7, 0, false)).has(0));
  EXPECT_FALSE(stars_of(turning_fan(8, 0, false)).has(0)) << "its ends are on one ray";
  EXPECT_FALSE(stars_of(turning_fan(9, 0, false)).has(0));
  EXPECT_FALSE(stars_of(turning_fan(16, 0.125, false)).has(0)) << "stairs of two turns";
  EXPECT_TRUE(stars_of(turning_fan(8, 0.125, false)).has(0))
      << "one end is over the other, but seen from aside it is not";
}

TEST(SimpleStars, AreOfOneFanOfTrianglesThatFollowOneAnother) {
  TriangleMesh mesh = turning_fan(8, 0, true);
  TriangleMesh turned = mesh;
  std::swap(turned.triangles[3][1], turned.triangles[3][2]);
  EXPECT_TRUE(stars_of(turned).has(0)) << "whichever way one is wound";
  TriangleMesh parted = mesh;
  parted.triangles.erase(parted.triangles.begin() + 3), parted.triangles.erase(parted.triangles.begin() + 6);
  EXPECT_FALSE(stars_of(parted).has(0)) << "there are two fans";
  TriangleMesh doubled = mesh;
  doubled.triangles.push_back(doubled.triangles[2]);
  EXPECT_FALSE(stars_of(doubled).has(0)) << "one is there twice";
  mesh.triangles[2][2] = mesh.triangles[2][1];
  EXPECT_FALSE(stars_of(mesh).has(0)) << "one has no area";
}

/// A torus of n by n parts.
TriangleMesh torus(std::uint32_t n) {
  TriangleMesh mesh;
  const double part = 6.283185307179586 / n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double u = part * i, v = part * k, r = 3 + std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const auto at = [n](std::uint32_t p, std::uint32_t q) { return p % n * n + q % n; };
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

TEST(SimpleStars, AreAllOfASmoothSurface) {
  const TriangleMesh mesh = torus(96);
  const Bvh bvh = build_bvh(mesh);
  for (const Execution execution : {Execution::serial, Execution::parallel}) {
    const space::SimpleStars stars = stars_of(bvh, execution);
    std::size_t simple = 0;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) simple += stars.has(v) ? 1U : 0U;
    EXPECT_EQ(simple, mesh.vertices.size());
  }
}

// No axis of space shows one side of what meets at its corners.
TEST(SimpleStars, AreThoseOfABox) {
  const TriangleMesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, 4}, {4, 0, 4}, {0, 4, 4}, {4, 4, 4}},
                          {{0, 2, 1},
                           {1, 2, 3},
                           {4, 5, 6},
                           {5, 7, 6},
                           {0, 1, 4},
                           {1, 5, 4},
                           {2, 6, 3},
                           {3, 6, 7},
                           {0, 4, 2},
                           {2, 4, 6},
                           {1, 3, 5},
                           {3, 7, 5}}};
  const space::SimpleStars stars = stars_of(mesh);
  for (std::uint32_t v = 0; v < 8; ++v) EXPECT_TRUE(stars.has(v)) << v;
}

TEST(SimpleStars, AreAskedOfTreesOfAnyKind) {
  const TriangleMesh mesh = torus(24);
  for (const float split : {0.0F, 0.5F}) {
    const Bvh bvh = build_bvh(mesh, {.split_share = split});
    EXPECT_EQ(count_intersecting_pairs(bvh), PairCount());
    EXPECT_EQ(count_intersecting_pairs(compact(bvh)), PairCount());
    EXPECT_FALSE(any_intersecting_pair(bvh));
  }
}

}  // namespace
}  // namespace plumb

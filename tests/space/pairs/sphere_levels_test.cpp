// Do levels meet where a sphere of one meets one of the other?  Is a surface that is said to be apart so, and its distance
// between the bounds?
#include "plumb/space/pairs/sphere_levels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using Spheres = std::vector<SpherePair>;

Spheres by_brute_force(const SphereTree& a, std::uint32_t level_a, const SphereTree& b, std::uint32_t level_b) {
  Spheres pairs;
  const auto as = a.level(level_a), bs = b.level(level_b);
  for (std::uint32_t i = 0; i < as.size(); ++i) {
    for (std::uint32_t k = 0; k < bs.size(); ++k) {
      if (intersects(as[i].sphere, bs[k].sphere)) pairs.push_back({i, k});
    }
  }
  return pairs;
}

SphereTree any_tree(shape_cases::Material& m, const TriangleMesh& mesh) {
  constexpr std::array kinds{SphereCover::octree, SphereCover::pieces, SphereCover::pruned};
  return build_sphere_tree(mesh, {kinds[m.below(3)], static_cast<std::uint32_t>(1 + m.below(4))});
}

TEST(SphereLevels, MeetWhereTheirSpheresDo) {
  std::size_t met = 0, apart = 0, beyond = 0;
  shape_cases::on_shapes(988, battery::fitting(60), [&](shape_cases::Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(12), m.below(4));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(12), m.below(4));
    try {
      const SphereTree a = any_tree(m, mesh_a), b = any_tree(m, mesh_b);
      const bool surfaces_meet = any_intersecting_pair(build_bvh(mesh_a), build_bvh(mesh_b)).has_value();
      for (std::uint32_t k = 0; k < 5; ++k) {
        const std::uint32_t l = k == 4 ? 0 : static_cast<std::uint32_t>(m.below(5));
        const Spheres expected = by_brute_force(a, k, b, l);
        EXPECT_EQ(meeting_spheres(a, k, b, l), expected) << m.about();
        EXPECT_EQ(spheres_meet(a, k, b, l), !expected.empty()) << m.about();
        if (surfaces_meet) {
          EXPECT_FALSE(expected.empty()) << m.about();
        }
        ++(expected.empty() ? apart : met);
      }
      const CollisionCheck all = check_collision(a, b);
      EXPECT_TRUE(all.is_last);
      EXPECT_EQ(all.pairs, by_brute_force(a, all.level, b, all.level)) << m.about();
      EXPECT_EQ(all.apart, all.pairs.empty());
      if (!mesh_a.triangles.empty() && !mesh_b.triangles.empty()) {
        const CollisionCheck some = check_collision(a, b, {.most_tests = 1 + m.below(60)});
        EXPECT_LE(some.tests, 60u);
        EXPECT_LE(some.level, all.level);
        EXPECT_EQ(some.pairs, by_brute_force(a, some.level, b, some.level)) << m.about();
        if (some.apart) {
          EXPECT_TRUE(all.apart) << m.about();
        }
      }
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(met, battery::fitting(30u));
  EXPECT_GT(apart, battery::fitting(40u));
  EXPECT_LE(beyond, battery::fitting(12u));
}

TEST(SphereDistance, IsBetweenItsBounds) {
  std::size_t tight = 0, beyond = 0;
  shape_cases::on_shapes(989, battery::fitting(60), [&](shape_cases::Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(12), 1 + m.below(4));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(12), 1 + m.below(4));
    try {
      const SphereTree a = any_tree(m, mesh_a), b = any_tree(m, mesh_b);
      const double distance =
          closest_triangles(build_bvh(mesh_a), build_bvh(mesh_b))->closest.distance;  // rounded once
      DistanceBounds before{0, HUGE_VAL, 0};
      for (const std::size_t most : {1u, 10u, 100u, 100'000u}) {
        const DistanceBounds bounds = distance_bounds(a, b, {.most_tests = most});
        EXPECT_LE(bounds.tests, most);
        EXPECT_LE(bounds.least, std::nextafter(distance, HUGE_VAL)) << m.about();
        EXPECT_GE(bounds.most, std::nextafter(distance, -HUGE_VAL)) << m.about();
        EXPECT_GE(bounds.least, before.least);
        EXPECT_LE(bounds.most, before.most);
        before = bounds;
      }
      tight += before.least > 0 && before.most < 4 * before.least ? 1 : 0;
      const DistanceBounds rough = distance_bounds(a, b, {.absolute = before.most});
      EXPECT_LE(rough.tests, before.tests);
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GE(tight, battery::fitting(6u));
  EXPECT_LE(beyond, battery::fitting(12u));
}

// Two rings side by side: finer trees know the distance better.
TEST(SphereDistance, IsKnownBetterWithFinerTrees) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 6 : 12);
  TriangleMesh other = mesh;
  for (Point3& p : other.vertices) p.x += 3.5;
  const double distance = closest_triangles(build_bvh(mesh), build_bvh(other))->closest.distance;
  double before = HUGE_VAL;
  for (const std::uint32_t levels : {2u, 4u, 6u}) {
    const SphereTree a = build_sphere_tree(mesh, {.levels = levels}), b = build_sphere_tree(other, {.levels = levels});
    const DistanceBounds bounds = distance_bounds(a, b);
    EXPECT_LE(bounds.least, distance);
    EXPECT_GE(bounds.most, distance);
    const double width = bounds.most - bounds.least;
    EXPECT_LT(width, before / 2);
    before = width;
    const DistanceBounds tenth = distance_bounds(a, b, {.relative = 0.5});
    EXPECT_LE(tenth.tests, bounds.tests);
  }
}

TEST(SphereLevels, OfNothingAreApart) {
  const SphereTree none, some = build_sphere_tree(meshes::ring(3));
  EXPECT_TRUE(meeting_spheres(none, 0, some, 3).empty());
  EXPECT_FALSE(spheres_meet(some, 2, none, 0));
  EXPECT_TRUE(check_collision(none, some).apart);
  EXPECT_EQ(distance_bounds(some, none).least, HUGE_VAL);
  EXPECT_THROW((void)check_collision(some, some, {.most_tests = 0}), InvalidShape);
  EXPECT_THROW((void)distance_bounds(some, some, {.absolute = -1}), InvalidShape);
  EXPECT_THROW((void)distance_bounds(some, some, {.relative = std::nan("")}), InvalidShape);
}

}  // namespace
}  // namespace plumb

// Is the nearest pair of triangles of two meshes that of all pairs, ties by number where that is asked for?
#include "plumb/space/closest/closest_triangles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"
#include "space/closest/closest_pair_search.hpp"

namespace plumb {
namespace {

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

std::optional<ClosestTriangles> by_brute_force(const TriangleMesh& a, const TriangleMesh& b) {
  std::optional<ClosestTriangles> best;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
      if (!best || compare_distance(at(a, i), at(b, k), at(a, best->a), at(b, best->b)) == Sign::negative) {
        best = ClosestTriangles{i, k, closest_points(at(a, i), at(b, k))};
      }
    }
  }
  return best;
}

/// All that is asked of two meshes is what the brute force's pair says; any pair that is told is as near.
void expect_nearest(const TriangleMesh& mesh_a, const TriangleMesh& mesh_b, const BvhOptions& options_a,
                    const BvhOptions& options_b, const std::string& about) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const Bvh a = build_bvh(mesh_a, options_a), b = build_bvh(mesh_b, options_b);
  const auto expected = by_brute_force(mesh_a, mesh_b);
  EXPECT_EQ(closest_triangles(a, b, {.first = true}), expected) << about;
  const auto any = closest_triangles(a, b);
  ASSERT_EQ(any.has_value(), expected.has_value()) << about;
  if (!expected) return;
  const Triangle3 s = at(mesh_a, any->a), t = at(mesh_b, any->b);
  EXPECT_EQ(compare_distance(s, t, at(mesh_a, expected->a), at(mesh_b, expected->b)), Sign::zero) << about;
  EXPECT_EQ(any->closest, closest_points(s, t)) << about;
  const double d = expected->closest.distance;
  EXPECT_EQ(distance(a, b), d) << about;
  for (const double reach : {0.0, d / 2, std::nextafter(d, 0.0), d, std::nextafter(d, far), 2 * d, far}) {
    if (!(reach <= far)) continue;
    const bool is_within = reach == far || compare_distance(s, t, reach) != Sign::positive;
    EXPECT_EQ(within(a, b, reach), is_within) << about << " within " << reach;
    const auto near = closest_triangles(a, b, {.first = true, .within = reach});
    EXPECT_EQ(near, is_within ? expected : std::nullopt) << about << " within " << reach;
  }
}

TEST(ClosestTriangles, AreTheNearestOfAllPairs) {
  std::size_t apart = 0, met = 0;
  shape_cases::on_shapes(961, battery::fitting(250), [&](shape_cases::Material& m) {
    const TriangleMesh a = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    TriangleMesh b = meshes::soup(m, 1 + m.below(8), 1 + m.below(8));
    const Vector3 by = m.below(3) == 0 ? m.vector3() : Vector3{0, 0, 0};
    for (Point3& p : b.vertices) {
      const Point3 moved{p.x + 3 * by.x, p.y + 3 * by.y, p.z + 3 * by.z};
      if (moved.x - moved.x == 0 && moved.y - moved.y == 0 && moved.z - moved.z == 0) p = moved;
    }
    for (const std::uint32_t most : {1u, 3u}) expect_nearest(a, b, {.most_in_leaf = most}, {}, m.about());
    ++(by_brute_force(a, b)->closest.distance > 0 ? apart : met);
  });
  EXPECT_GT(apart, battery::fitting(30u));
  EXPECT_GT(met, battery::fitting(30u));
}

TEST(ClosestTriangles, OfSurfacesApartTouchingAndThrough) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 3 : 4);
  for (const double by : {0.0, 0.25, 2.8, 3.0, 40.0}) {
    TriangleMesh moved = mesh;
    for (Point3& p : moved.vertices) p.x += by;
    expect_nearest(mesh, moved, {}, {.method = BvhMethod::linear}, std::to_string(by));
  }
  TriangleMesh mirrored = mesh;
  for (Point3& p : mirrored.vertices) p.x = 8 - p.x;  // the mirror's plane has all pairs tie
  expect_nearest(mesh, mirrored, {}, {}, "mirrored");
}

TriangleMesh lattice(std::uint32_t n, double step, double slope, const Vector3& by) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const double x = step * i, y = step * k;
      mesh.vertices.push_back({x + by.x, y + by.y, slope * x + by.z});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// Each with a face in a plane of its own, on a lattice of floats or of doubles that floats do not hold, straight or
/// slanted: all pairs that face each other are equally near, or all but for their rounding.
TEST(ClosestTriangles, OfFacesThatLieFaceToFace) {
  for (const double step : {0.25, 0.1}) {
    for (const double slope : {0.0, 0.5, 0.7}) {
      const TriangleMesh a = lattice(4, step, slope, {0, 0, 0}), b = lattice(3, 1.3 * step, slope, {0.1, 0.05, 0.3});
      expect_nearest(a, b, {.most_in_leaf = 2}, {}, std::to_string(step) + " " + std::to_string(slope));
    }
  }
}

/// The whole boxes of the meshes are as near as the nearest pair: nothing else of them has to be looked at.
TEST(ClosestTriangles, CostOnePairWhereFacesLieFaceToFace) {
  std::array<std::size_t, 2> looked_at{};
  for (const std::size_t big : {0u, 1u}) {
    const std::uint32_t n = big == 1 ? 40 : 10;
    const Bvh a = build_bvh(lattice(n, 0.25, 0, {0, 0, 0})), b = build_bvh(lattice(n, 0.5, 0, {0.125, 0.25, 3}));
    space::StandingSource from(a), to(b);
    std::size_t triangles = 0;
    space::ClosestSearch search(from, to, {}, space::Counted{&looked_at[big], &triangles});
    EXPECT_EQ(search.run()->distance, 3);
    EXPECT_LE(triangles, 128U);
  }
  EXPECT_LE(looked_at[1], 4 * looked_at[0]);  // sixteen times the triangles, and 256 times the pairs
}

TEST(ClosestTriangles, OfTreesInOtherFrames) {
  const TriangleMesh near = meshes::ring(3);
  TriangleMesh far = near;
  for (Point3& p : far.vertices) p = {p.x * 0x1p60, p.y * 0x1p60, p.z * 0x1p60 + 0x1p61};
  ASSERT_FALSE(build_bvh(near).tree.frame == build_bvh(far).tree.frame);
  expect_nearest(near, far, {}, {}, "near and far");
  expect_nearest(far, near, {}, {}, "far and near");
}

TEST(ClosestTriangles, AreRefusedADistanceThatIsNone) {
  const Bvh some = build_bvh(meshes::ring(3));
  EXPECT_THROW((void)within(some, some, NAN), NonFinite);
  EXPECT_THROW((void)closest_triangles(some, some, {.within = NAN}), NonFinite);
  EXPECT_FALSE(within(some, some, -1.0));
  EXPECT_EQ(closest_triangles(some, some, {.within = -0x1p-1074}), std::nullopt);
}

TEST(ClosestTriangles, OfNothingAreNone) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  EXPECT_EQ(closest_triangles(none, some), std::nullopt);
  EXPECT_EQ(closest_triangles(some, none), std::nullopt);
  EXPECT_EQ(distance(none, some), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(within(some, none, 5.0));
}

}  // namespace
}  // namespace plumb

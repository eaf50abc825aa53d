// Is the nearest pair of triangles of two meshes that of all pairs, ties by number?
#include "plumb/space/closest/closest_triangles.hpp"

#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

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
    const auto expected = by_brute_force(a, b);
    for (const std::uint32_t most : {1u, 3u}) {
      EXPECT_EQ(closest_triangles(build_bvh(a, {.most_in_leaf = most}), build_bvh(b)), expected) << m.about();
    }
    ++(expected->closest.distance > 0 ? apart : met);
  });
  EXPECT_GT(apart, battery::fitting(30u));
  EXPECT_GT(met, battery::fitting(30u));
}

TEST(ClosestTriangles, OfSurfacesApartTouchingAndThrough) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 3 : 4);
  const Bvh bvh = build_bvh(mesh);
  for (const double by : {0.0, 0.25, 2.8, 3.0, 40.0}) {
    TriangleMesh moved = mesh;
    for (Point3& p : moved.vertices) p.x += by;
    const Bvh other = build_bvh(moved, {.method = BvhMethod::linear});
    const auto expected = by_brute_force(mesh, moved);
    EXPECT_EQ(closest_triangles(bvh, other), expected) << by;
  }
  TriangleMesh mirrored = mesh;
  for (Point3& p : mirrored.vertices) p.x = 8 - p.x;  // the mirror's plane has all pairs tie
  EXPECT_EQ(closest_triangles(bvh, build_bvh(mirrored)), by_brute_force(mesh, mirrored));
}

TEST(ClosestTriangles, OfTreesInOtherFrames) {
  const TriangleMesh near = meshes::ring(3);
  TriangleMesh far = near;
  for (Point3& p : far.vertices) p = {p.x * 0x1p60, p.y * 0x1p60, p.z * 0x1p60 + 0x1p61};
  const Bvh a = build_bvh(near), b = build_bvh(far);
  ASSERT_FALSE(a.tree.frame == b.tree.frame);
  EXPECT_EQ(closest_triangles(a, b), by_brute_force(near, far));
  EXPECT_EQ(closest_triangles(b, a), by_brute_force(far, near));
}

TEST(ClosestTriangles, OfNothingAreNone) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  EXPECT_EQ(closest_triangles(none, some), std::nullopt);
  EXPECT_EQ(closest_triangles(some, none), std::nullopt);
}

}  // namespace
}  // namespace plumb

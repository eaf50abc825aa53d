// Do trees of all volumes find the pairs of real meshes, turned and moved by a step?  Do sphere trees bound their distance?
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/sanitized.hpp"
#include "plumb/space.hpp"
#include "plumb/space/pairs/sphere_levels.hpp"
#include "plumb/space/pairs/volume_pairs.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

template <class Volume>
void expect_same_pairs(const Bvh& bvh, const PosedMesh& turned, const Bvh& shifted, const VolumeOptions& options,
                       const char* name) {
  const auto tree = build_volume_tree<Volume>(bvh, options), of_shifted = build_volume_tree<Volume>(shifted, options);
  const auto of_turned = posed_volume_tree(turned, tree);
  EXPECT_EQ(intersecting_pairs(VolumeMesh(bvh, tree), VolumeMesh(turned, of_turned)), intersecting_pairs(bvh, turned))
      << name;
  EXPECT_EQ(intersecting_pairs(VolumeMesh(bvh, tree), VolumeMesh(shifted, of_shifted)),
            intersecting_pairs(bvh, shifted))
      << name;
}

TEST(VolumesOfModels, FindTheirPairsAndBoundTheirDistance) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  std::size_t found = 0;
  for (const char* name : {"suzanne.obj", "beetle.obj", "spot.obj", "fandisk.obj"}) {
    const TriangleMesh mesh = read_mesh((folder / name).string());
    if (battery::sanitized && mesh.triangles.size() > 3000) continue;
    const Bvh bvh = build_bvh(mesh);
    const Aabb3 box = fit_aabb(mesh.vertices);
    const double size = box.max.x - box.min.x, c = std::cos(0.25), s = std::sin(0.25);
    const PosedMesh turned{bvh, {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, {size / 8, 0, 0}}};
    TriangleMesh by_a_step = mesh;
    for (Point3& p : by_a_step.vertices) p.x += std::exp2(std::ilogb(size) - 6);
    const Bvh shifted = build_bvh(by_a_step);
    found += intersecting_pairs(bvh, turned).size() + intersecting_pairs(bvh, shifted).size();
    expect_same_pairs<Sphere3>(bvh, turned, shifted, {}, name);
    expect_same_pairs<Aabb3>(bvh, turned, shifted, {}, name);
    expect_same_pairs<Obb3>(bvh, turned, shifted, {}, name);
    expect_same_pairs<KDop3>(bvh, turned, shifted, {.k = 18}, name);
    const PosedMesh apart{bvh, {identity_pose.columns, {0, 0, 2 * (box.max.z - box.min.z)}}};
    const double distance = closest_triangles(bvh, apart)->closest.distance;
    for (const SphereCover cover : {SphereCover::octree, SphereCover::pieces, SphereCover::pruned}) {
      const SphereTree tree = build_sphere_tree(bvh, {cover, 5});
      const SphereTree other = transform(tree, apart.pose);
      EXPECT_TRUE(check_collision(tree, other).apart) << name;
      const DistanceBounds bounds = distance_bounds(tree, other, {.relative = 0.01, .most_tests = 100'000});
      EXPECT_LE(bounds.least, distance) << name;
      EXPECT_GE(bounds.most, distance) << name;
    }
  }
  EXPECT_GT(found, battery::sanitized ? 100u : 5'000u);
}

}  // namespace
}  // namespace plumb

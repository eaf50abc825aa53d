// Is what is nearest on real meshes that which a batch of all triangles names?
#include <gtest/gtest.h>

#include <filesystem>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

TEST(ClosestOnModels, IsThatOfTheBatch) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  for (const char* name : {"suzanne.obj", "beetle.obj", "cow.obj", "teapot.obj", "fandisk.obj", "rocker-arm.obj"}) {
    const TriangleMesh mesh = read_mesh((folder / name).string());
    const Bvh bvh = build_bvh(mesh);
    const TriangleBatch batch = triangle_batch(mesh);
    std::vector<Point3> points{{0, 0, 0}};
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(100); ++i) {
      Entropy entropy(981, i);
      const Point3& p = mesh.vertices[entropy.below(mesh.vertices.size())];
      const Point3& q = mesh.vertices[entropy.below(mesh.vertices.size())];
      points.push_back(p);  // has all triangles about it tie
      points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      points.push_back({2 * p.x - q.x, 2 * p.y - q.y, 2 * p.z - q.z});
    }
    std::vector<ClosestOnMesh> closest(points.size());
    closest_on_mesh(bvh, points, closest);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ((NearestOfMany{closest[i].triangle, closest[i].distance}), nearest(batch, points[i]))
          << name << " " << i;
    }
  }
}

}  // namespace
}  // namespace plumb

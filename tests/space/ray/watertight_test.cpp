// Does a ray slip through a closed mesh, aimed at its vertices and at the middles of its edges?  Generated meshes, and
// every closed one of the models.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

Vector3 toward(const Point3& from, const Point3& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

/// On a grid of 2^-30 of its size, so that the middle of an edge is a double: on the edge exactly.
TriangleMesh on_grid(TriangleMesh mesh) {
  double largest = 0;
  for (const Point3& p : mesh.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double unit = std::ldexp(1.0, std::ilogb(largest) - 30);
  const auto rounded = [&](double x) { return std::round(x / unit) * unit; };
  for (Point3& p : mesh.vertices) p = {rounded(p.x), rounded(p.y), rounded(p.z)};
  return mesh;
}

/// Segments end exactly on the surface and must hit; rays, whose direction is rounded, may pass beside a silhouette,
/// but what they pass, they pass as often in as out.
void expect_no_leaks(const TriangleMesh& given, const std::string& name) {
  const TriangleMesh mesh = on_grid(given);
  ASSERT_TRUE(is_closed(mesh)) << name;
  const Bvh bvh = build_bvh(mesh);
  Point3 low = mesh.vertices[0], high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double reach = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const std::array eyes{Point3{high.x + reach, high.y + 0.37 * reach, high.z + 0.61 * reach},
                        Point3{low.x - 1e5 * reach, low.y + 0.4 * reach, low.z}};
  std::vector<AnyRay> segments, rays;
  const auto aim = [&](const Point3& at) {
    const Point3& eye = eyes[segments.size() % 2];
    segments.emplace_back(Segment3{eye, at});
    if (segments.size() % 8 < 2) rays.emplace_back(Ray3{eye, toward(eye, at)});
  };
  std::vector<char> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if (used[t[k]]++ == 0) aim(a);
      if (t[k] < t[(k + 1) % 3]) aim({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
    }
  }
  std::vector<std::uint8_t> hit(segments.size());
  any_hit(bvh, segments, hit);
  const auto leaks = std::count(hit.begin(), hit.end(), 0);
  EXPECT_EQ(leaks, 0) << name;
  std::vector<std::size_t> crossed(rays.size());
  std::vector<std::uint32_t> first(rays.size());
  count_hits(bvh, rays, crossed, {.rule = HitRule::half_open});
  first_triangle(bvh, rays, first);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(crossed[i] % 2, 0u) << name << " ray " << i;
    EXPECT_TRUE(crossed[i] == 0 || first[i] != no_triangle) << name << " ray " << i;
  }
  std::printf("%s: %zu segments to vertices and edges, %zu leaks; %zu rays\n", name.c_str(), segments.size(),
              static_cast<std::size_t>(leaks), rays.size());
}

TEST(Watertight, GeneratedMeshes) {
  expect_no_leaks(meshes::ring(24), "ring");
  expect_no_leaks(solids::torus(3, 1, 32, 16), "torus");
  expect_no_leaks(solids::turned(solids::hollow_torus(3, 1, 24, 12)), "hollow torus");
}

TEST(Watertight, TheClosedModels) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::printf("skipped: there is no %s\n", folder.c_str());
    return;
  }
  int closed = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".md") continue;
    const TriangleMesh mesh = read_mesh(file.path());
    if (battery::sanitized && mesh.triangles.size() > 6000) continue;  // there is no time for them
    if (mesh.triangles.empty() || !is_closed(mesh)) {
      std::printf("%s is open\n", file.path().filename().c_str());
      continue;
    }
    ++closed;
    expect_no_leaks(mesh, file.path().filename());
  }
  EXPECT_GT(closed, battery::sanitized ? 1 : 2);
}

}  // namespace
}  // namespace plumb

// Is what is nearest in a compact tree what is nearest of all triangles, and what the tree says that it is made of?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using Near = std::vector<NearTriangle>;

Triangle3 at(const TriangleMesh& mesh, std::uint32_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// By exact distance, then by number.
Near by_brute_force(const TriangleMesh& mesh, const Point3& p) {
  Near near;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) near.push_back({i, distance(p, at(mesh, i))});
  std::stable_sort(near.begin(), near.end(), [&](const NearTriangle& x, const NearTriangle& y) {
    if (x.distance != y.distance) return x.distance < y.distance;
    return compare(exact_distance(p, at(mesh, x.triangle)), exact_distance(p, at(mesh, y.triangle))) == Sign::negative;
  });
  return near;
}

void expect_nearest(const TriangleMesh& mesh, const CompactBvh& small, const Point3& p, const std::string& about) {
  const Near all = by_brute_force(mesh, p);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{4}, all.size() + 1}) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(k, all.size()));
    EXPECT_EQ(nearest_triangles(small, p, k), Near(all.begin(), end)) << about << " k " << k;
  }
  const auto closest = closest_on_mesh(small, p);
  ASSERT_EQ(closest.has_value(), !all.empty()) << about;
  if (!closest) return;
  const Closest expected = closest_points(p, at(mesh, all[0].triangle));
  EXPECT_EQ(*closest, (ClosestOnMesh{all[0].triangle, expected.on_b, expected.distance, expected.feature_b})) << about;
  const double reach = all[all.size() / 2].distance;
  if (!std::isfinite(reach)) return;
  Near within;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (compare_distance(p, at(mesh, i), reach) != Sign::positive) within.push_back({i, distance(p, at(mesh, i))});
  }
  EXPECT_EQ(triangles_within(small, p, reach), within) << about;
}

TEST(CompactClosest, IsTheNearestOfAllTriangles) {
  shape_cases::on_shapes(987, battery::fitting(300), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(30), m.below(50));
    const CompactBvh small = build_compact_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    const Point3 p = m.probe3();
    expect_nearest(mesh, small, p, m.about(p));
  });
  const TriangleMesh same = meshes::repeated(100);
  expect_nearest(same, build_compact_bvh(same), {0.25, 0.25, 3}, "repeated");
  for (const int first : {-1074, -500, 0}) {
    const TriangleMesh spread = meshes::doubling(60, first, 17);
    const CompactBvh tree = build_compact_bvh(spread);
    for (const double x : {0x1p-1070, 0x1p-480, 0x1p-100, 1.0, 0x1p300}) {
      expect_nearest(spread, tree, {x, -x, x * 1.25}, "doubling " + std::to_string(first));
    }
  }
}

TEST(CompactClosest, OfNothingIsNothing) {
  const CompactBvh none = build_compact_bvh(TriangleMesh{});
  EXPECT_EQ(closest_on_mesh(none, {0, 0, 0}), std::nullopt);
  EXPECT_EQ(nearest_triangles(none, {0, 0, 0}, 3), Near{});
  EXPECT_EQ(triangles_within(none, {0, 0, 0}, 3), Near{});
  const std::vector<Point3> one{{0, 0, 0}};
  std::vector<ClosestOnMesh> out(1);
  EXPECT_THAT(text_of<InvalidShape>([&] { closest_on_mesh(none, one, out); }),
              ::testing::HasSubstr("the mesh is empty"));
  EXPECT_THROW((void)closest_on_mesh(none, {0, std::nan(""), 0}), NonFinite);
}

void expect_as_in(const TriangleMesh& mesh, std::size_t points_asked) {
  const Bvh bvh = build_bvh(mesh);
  const CompactBvh small = compact(bvh);
  std::vector<Point3> points;
  for (std::uint64_t i = 0; points.size() < points_asked; ++i) {
    Entropy e(988, i);
    const Point3& p = mesh.vertices[e.below(mesh.vertices.size())];
    const Point3& q = mesh.vertices[e.below(mesh.vertices.size())];
    points.push_back(p);  // has all triangles about it tie
    points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
    points.push_back({2 * p.x - q.x, 2 * p.y - q.y, 2 * p.z - q.z});
  }
  std::vector<ClosestOnMesh> expected(points.size()), found(points.size());
  closest_on_mesh(bvh, points, expected, {.execution = Execution::serial});
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    closest_on_mesh(small, points, found);
    EXPECT_EQ(found, expected);
  }
  for (std::size_t i = 0; i < points.size(); i += 10) {
    EXPECT_EQ(nearest_triangles(small, points[i], 7), nearest_triangles(bvh, points[i], 7));
    const double reach = 1.25 * expected[i].distance;
    EXPECT_EQ(triangles_within(small, points[i], reach), triangles_within(bvh, points[i], reach));
  }
}

TEST(CompactClosest, IsThatOfTheTreeItIsMadeOf) {
  expect_as_in(meshes::ring(30), 300);
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  for (const char* name : {"beetle.obj", "cow.obj", "teapot.obj", "rocker-arm.obj"}) {
    SCOPED_TRACE(name);
    expect_as_in(read_mesh((folder / name).string()), battery::fitting(600u));
  }
}

}  // namespace
}  // namespace plumb

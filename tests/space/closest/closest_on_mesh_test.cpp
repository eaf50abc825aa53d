// Are the nearest triangles those that exact distances to every triangle give, ties by number, on one thread and on two?
#include "plumb/space/closest/closest_on_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using Near = std::vector<NearTriangle>;

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// All triangles by exact distance, then by number.
Near by_brute_force(const TriangleMesh& mesh, const Point3& p) {
  std::vector<ExactDistance> exact;
  Near near;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    exact.push_back(exact_distance(p, at(mesh, i)));
    near.push_back({i, distance(p, at(mesh, i))});
  }
  std::ranges::stable_sort(near, [&](const NearTriangle& x, const NearTriangle& y) {
    return compare(exact[x.triangle], exact[y.triangle]) == Sign::negative;
  });
  return near;
}

Near first_of(const Near& all, std::size_t k) {
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(k, all.size()))};
}

void expect_nearest(const TriangleMesh& mesh, const Bvh& bvh, const Point3& p, const std::string& about) {
  const Near all = by_brute_force(mesh, p);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{5}, all.size() + 1}) {
    EXPECT_EQ(nearest_triangles(bvh, p, k), first_of(all, k)) << about << " k " << k;
  }
  const auto closest = closest_on_mesh(bvh, p);
  ASSERT_EQ(closest.has_value(), !all.empty());
  if (!closest) return;
  const Closest expected = closest_points(p, at(mesh, all[0].triangle));
  EXPECT_EQ(*closest, (ClosestOnMesh{all[0].triangle, expected.on_b, expected.distance, expected.feature_b})) << about;
  constexpr double far = std::numeric_limits<double>::infinity();
  const double d = closest->distance;
  for (const double within : {-1.0, 0.0, std::nextafter(d, 0.0), d, std::nextafter(d, far), far}) {
    const bool is_within = within == far || compare_distance(p, at(mesh, all[0].triangle), within) != Sign::positive;
    EXPECT_EQ(closest_on_mesh(bvh, p, within), is_within ? closest : std::nullopt) << about << " within " << within;
  }
  const double reach = all[all.size() / 3].distance;
  for (const double most : {0.0, reach, std::nextafter(reach, 0.0), -1.0}) {
    if (!(most - most == 0)) continue;
    Near within;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      if (compare_distance(p, at(mesh, i), most) != Sign::positive) within.push_back({i, distance(p, at(mesh, i))});
    }
    EXPECT_EQ(triangles_within(bvh, p, most), within) << about << " within " << most;
  }
}

TEST(ClosestOnMesh, IsTheNearestOfAllTriangles) {
  std::size_t ties = 0;
  shape_cases::on_shapes(951, 400, [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(20), m.below(30));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    const Point3 p = m.probe3();
    expect_nearest(mesh, bvh, p, m.about(p));
    const Near all = by_brute_force(mesh, p);
    ties += all.size() > 1 && all[0].distance == all[1].distance ? 1 : 0;
  });
  EXPECT_GT(ties, 100u);
}

// Points that have many nearest triangles, or whose nearest triangles differ by less than doubles tell.
TEST(ClosestOnMesh, TellsTiesAndNearTies) {
  TriangleMesh mesh;  // a fan of 24 triangles in a sphere's tangent planes, nearly
  for (std::uint32_t i = 0; i < 24; ++i) {
    const double u = 0.3 * i, v = 0.7 * i;
    const Point3 p{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
    const double x = i % 3 == 0 ? p.x : std::nextafter(p.x, 2.0);
    mesh.vertices.insert(mesh.vertices.end(),
                         {{x, p.y, p.z}, {2 * p.x, 2 * p.y, 2.5 * p.z}, {3 * p.x, 2 * p.y, 2 * p.z}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    mesh.triangles.push_back({3 * i, 3 * i + 2, 3 * i});
  }
  expect_nearest(mesh, build_bvh(mesh, {.most_in_leaf = 1}), {0, 0, 0}, "fan");
  const TriangleMesh same = meshes::repeated(50);
  expect_nearest(same, build_bvh(same), {0.25, 0.25, 3}, "repeated");
  const TriangleMesh spread = meshes::doubling(60, -500, 17);
  const Bvh tree = build_bvh(spread);
  for (const double x : {0x1p-480, 0x1p-100, 0x1p300}) expect_nearest(spread, tree, {x, -x, x * 1.25}, "doubling");
}

std::vector<Point3> grid(int n) {
  std::vector<Point3> points;
  for (int i = -n; i <= n; ++i) {
    for (int k = -n; k <= n; ++k) points.push_back({0.25 * i, 0.25 * k, 0.125 * (i + k)});
  }
  return points;
}

TEST(ClosestOnMesh, OfManyPointsIsThatOfEach) {
  const Bvh bvh = build_bvh(meshes::ring(30));
  const std::vector<Point3> points = grid(8);
  std::vector<ClosestOnMesh> expected;
  for (const Point3& p : points) expected.push_back(*closest_on_mesh(bvh, p));
  std::vector<ClosestOnMesh> out(points.size());
  closest_on_mesh(bvh, points, out, {.execution = Execution::serial});
  EXPECT_EQ(out, expected);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    std::vector<ClosestOnMesh> again(points.size());
    double last = 0;
    closest_on_mesh(bvh, points, again, {.progress = [&](double share) {
                      EXPECT_GT(share, last);
                      last = share;
                      return true;
                    }});
    EXPECT_EQ(again, expected);
    EXPECT_EQ(last, 1);
  }
  const auto stopped = [&] { closest_on_mesh(bvh, points, out, {.progress = [](double) { return false; }}); };
  EXPECT_THAT(text_of<Cancelled>(stopped), HasSubstr("closest_on_mesh: cancelled"));
}

TEST(ClosestOnMesh, DependsOnNoTree) {
  const TriangleMesh mesh = meshes::ring(10);
  const Bvh first = build_bvh(mesh);
  for (const BvhMethod method : bvh_methods) {
    const Bvh other = build_bvh(mesh, {.method = method});
    for (const Point3& p : grid(3)) {
      EXPECT_EQ(closest_on_mesh(first, p), closest_on_mesh(other, p)) << name_of(method);
      EXPECT_EQ(nearest_triangles(first, p, 20), nearest_triangles(other, p, 20)) << name_of(method);
    }
  }
}

TEST(ClosestOnMesh, OfNothingIsNothing) {
  const Bvh none = build_bvh(TriangleMesh{});
  EXPECT_EQ(closest_on_mesh(none, {0, 0, 0}), std::nullopt);
  EXPECT_EQ(nearest_triangles(none, {0, 0, 0}, 3), Near{});
  EXPECT_EQ(triangles_within(none, {0, 0, 0}, 3), Near{});
  closest_on_mesh(none, std::span<const Point3>(), std::span<ClosestOnMesh>());
  std::vector<Point3> one{{0, 0, 0}};
  std::vector<ClosestOnMesh> out(1);
  EXPECT_THAT(text_of<InvalidShape>([&] { closest_on_mesh(none, one, out); }), HasSubstr("the mesh is empty"));
}

TEST(ClosestOnMesh, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Bvh bvh = build_bvh(meshes::ring(3));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)closest_on_mesh(bvh, {0, nan, 0});
              }),
              HasSubstr("closest_on_mesh: p.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)triangles_within(bvh, {0, 0, 0}, infinity);
              }),
              HasSubstr("triangles_within: distance is inf"));
  const std::vector<Point3> points{{0, 0, 0}, {0, 0, -infinity}};
  std::vector<ClosestOnMesh> out(2);
  EXPECT_THAT(text_of<NonFinite>([&] { closest_on_mesh(bvh, points, out); }),
              HasSubstr("closest_on_mesh: points[1].z is -inf"));
  out.resize(1);
  EXPECT_THAT(text_of<UnequalLengths>([&] { closest_on_mesh(bvh, points, out); }),
              HasSubstr("points has 2 items, out has 1"));
}

}  // namespace
}  // namespace plumb

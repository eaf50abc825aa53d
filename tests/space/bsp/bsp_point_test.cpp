// Do solid leaves say of points what the mesh says, on its vertices, edges and faces too?
#include "plumb/space/bsp/bsp_point.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space/bsp/build_bsp.hpp"
#include "space/bsp/closed_meshes.hpp"

namespace plumb {
namespace {

using namespace bsp_cases;

/// With points a little off in all directions: is the point on a sheet with the same on all sides?
bool is_told_by_sides(const std::string& name) { return name == "heap" || name == "crossing"; }

TEST(BspPoint, IsWhatTheMeshSays) {
  std::array<long, 3> told{};
  for (const NamedMesh& m : closed_meshes()) {
    for (const BspPlanes planes : {BspPlanes::faces, BspPlanes::faces_and_axes}) {
      const BspTree tree = build_bsp(m.mesh, {.planes = planes});
      const std::vector<Point3> points = points_about(m.mesh, 91, battery::fitting(2000u));
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Location expected = locate(m.mesh, points[i]), found = locate(tree, points[i]);
        ++told[static_cast<std::size_t>(static_cast<int>(found) + 1)];
        if (expected == Location::boundary && is_told_by_sides(m.name)) continue;  // SheetsAreNoBoundary
        ASSERT_EQ(found, expected) << m.name << ", points_about(mesh, 91, ...)[" << i << "]";
      }
    }
  }
  for (const long n : told) EXPECT_GT(n, battery::fitting(2000));
}

TEST(BspPoint, LeavesHaveTheirBordersInCommon) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 2, 3});
  const BspTree tree = build_bsp(mesh);
  std::size_t inside = 0;
  for (const Point3& p : points_about(mesh, 92, 500)) {
    const auto leaves = leaves_at(tree, p);
    const bool is_between = locate(tree, p) == Location::boundary;
    EXPECT_GE(leaves.size(), is_between ? 2u : 1u);
    inside += locate(tree, p) == Location::inside ? 1 : 0;
  }
  EXPECT_GT(inside, 0u);
}

TEST(BspPoint, SheetsAreNoBoundary) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {4, 4, 4});
  const TriangleMesh sheet{{{1, 1, 2}, {3, 1, 2}, {1, 3, 2}}, {{0, 1, 2}, {0, 2, 1}}};
  solids::append(mesh, sheet);
  const BspTree tree = build_bsp(mesh);
  EXPECT_EQ(locate(mesh, Point3{1.5, 1.5, 2}), Location::boundary);
  EXPECT_EQ(locate(tree, Point3{1.5, 1.5, 2}), Location::inside);
  EXPECT_EQ(locate(tree, Point3{0, 1.5, 2}), Location::boundary);
}

TEST(BspPoint, SaysWhatItRefuses) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 2, 3});
  const BspTree tree = build_bsp(mesh);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)locate(tree, Point3{std::nan(""), 0, 0}), NonFinite);
  EXPECT_THROW((void)locate(tree, Point3{0, inf, 0}), NonFinite);
  EXPECT_THROW((void)leaves_at(tree, Point3{0, 0, -inf}), NonFinite);
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)locate(build_bsp(mesh, {.kind = BspKind::node_storing}), Point3{0, 0, 0});
              }),
              testing::HasSubstr("solid leaves"));
}

}  // namespace
}  // namespace plumb

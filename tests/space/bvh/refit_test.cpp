// Does a tree keep its laws while its vertices move, whole and in parts, and is it better after parts are built anew?
#include "plumb/space/bvh/refit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure/basic/thrown.hpp"
#include "plumb/space/bvh/tree_cost.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using tree_laws::boxes_of;
using tree_laws::broken;

void expect_mesh(const Bvh& bvh, const TriangleMesh& mesh) {
  EXPECT_EQ(broken(bvh.tree, boxes_of(mesh), BvhOptions{}.most_in_leaf), "");
  for (std::size_t slot = 0; slot < bvh.triangles.size(); ++slot) {
    const auto& [a, b, c] = mesh.triangles[bvh.tree.items[slot]];
    EXPECT_EQ(bvh.triangle(slot), (Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}));
  }
}

TEST(Refit, KeepsTheLawsWhereverVerticesGo) {
  std::size_t rebuilt = 0, scaled = 0;
  shape_cases::on_shapes(941, 200, [&](shape_cases::Material& m) {
    TriangleMesh mesh = meshes::soup(m, 1 + m.below(50), m.below(100));
    Bvh bvh = build_bvh(mesh);
    const int power = static_cast<int>(m.below(3)) * 300;
    for (Point3& p : mesh.vertices) {
      p = m.point3();
      if (std::abs(p.x) < 1 && std::abs(p.y) < 1 && std::abs(p.z) < 1) p.x = std::ldexp(p.x, power);
    }
    refit(bvh, mesh.vertices);
    expect_mesh(bvh, mesh);
    scaled += bvh.tree.frame.exponent() != 0 ? 1 : 0;
    rebuilt += rebuild_parts(bvh, 1 + 0.1 * static_cast<double>(m.below(10))) != 0 ? 1 : 0;
    expect_mesh(bvh, mesh);
    BoxTree boxes = build_box_tree(boxes_of(mesh));
    for (Point3& p : mesh.vertices) p = m.point3();
    refit(boxes, boxes_of(mesh));
    EXPECT_EQ(broken(boxes, boxes_of(mesh), BvhOptions{}.most_in_leaf), "");
  });
  EXPECT_GT(rebuilt, 30u);
  EXPECT_GT(scaled, 20u);
}

TEST(Refit, ByOneThreadOrMore) {
  TriangleMesh mesh = meshes::ring(40);
  const Bvh built = build_bvh(mesh);
  for (Point3& p : mesh.vertices) p.z += 0.3 * std::sin(9 * p.x);
  Bvh serial = built, parallel = built;
  refit(serial, mesh.vertices, Execution::serial);
  refit(parallel, mesh.vertices, Execution::parallel);
  EXPECT_TRUE(std::ranges::equal(serial.tree.nodes, parallel.tree.nodes));
}

// One quarter of a ring is thrown over all of it: refitted boxes are large there alone.
TEST(RebuildParts, MendsWhatWasThrownAbout) {
  TriangleMesh mesh = meshes::ring(40);
  Bvh bvh = build_bvh(mesh);
  Entropy entropy(942, 0);
  std::vector<Point3> places = mesh.vertices;
  std::vector<std::size_t> quarter;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].x > 0 && places[i].y > 0) quarter.push_back(i);
  }
  for (const std::size_t i : quarter) mesh.vertices[i] = places[quarter[entropy.below(quarter.size())]];
  refit(bvh, mesh.vertices);
  const double before = cost_of(bvh.tree).total(1, 0.5);
  const std::size_t triangles = rebuild_parts(bvh, 1.6);
  const double after = cost_of(bvh.tree).total(1, 0.5), best = cost_of(build_bvh(mesh).tree).total(1, 0.5);
  EXPECT_GT(triangles, 0u);
  EXPECT_LT(triangles, mesh.triangles.size());
  EXPECT_LT(after, 0.9 * before);
  EXPECT_LT(after, 1.5 * best);
  expect_mesh(bvh, mesh);
  EXPECT_EQ(rebuild_parts(bvh, 2), 0u);
}

TEST(Refit, ChangesNothingWhereItThrows) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  Bvh bvh = build_bvh(mesh);
  std::vector<Point3> moved = mesh.vertices;
  moved.push_back({});
  EXPECT_THAT(text_of<UnequalLengths>([&] { refit(bvh, moved); }), HasSubstr("vertices has 4 items"));
  moved = {{5, 5, 5}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}};
  EXPECT_THAT(text_of<NonFinite>([&] { refit(bvh, moved); }), HasSubstr("refit: vertices[2].y is inf"));
  EXPECT_THAT(text_of<UnequalLengths>([&] { refit(bvh.tree, {}); }), HasSubstr("boxes has 0 items"));
  EXPECT_THAT(text_of<InvalidShape>([&] { rebuild_parts(bvh, 0.5); }), HasSubstr("most is 0.5"));
  expect_mesh(bvh, mesh);
}

}  // namespace
}  // namespace plumb

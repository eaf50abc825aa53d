// Is a mesh in its tree what it was: the same corners, each triangle once; and is what is wrong with it named?
#include "plumb/space/bvh/bvh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "figure/basic/thrown.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

TEST(Bvh, LaysOutTheTrianglesUnchanged) {
  shape_cases::on_shapes(911, 200, [](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(50), m.below(100));
    const Bvh bvh = build_bvh(mesh);
    EXPECT_EQ(tree_laws::broken(bvh.tree, tree_laws::boxes_of(mesh), BvhOptions{}.most_in_leaf), "");
    ASSERT_EQ(bvh.triangles.size(), mesh.triangles.size());
    for (std::size_t slot = 0; slot < bvh.triangles.size(); ++slot) {
      const auto& [a, b, c] = mesh.triangles[bvh.tree.items[slot]];
      EXPECT_EQ(bvh.triangle(slot), (Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}));
    }
  });
}

TEST(Bvh, TakesAtMost64BytesATriangle) {
  for (const std::uint32_t n : {20u, 100u}) {
    const TriangleMesh mesh = meshes::ring(n);
    EXPECT_LE(memory_of(build_bvh(mesh)), 64 * mesh.triangles.size());
  }
}

TEST(Bvh, OfNothingIsNothing) {
  const Bvh none = build_bvh(TriangleMesh{});
  EXPECT_EQ(memory_of(none), 0u);
  const Bvh points_alone = build_bvh(TriangleMesh{{{1, 2, 3}}, {}});
  EXPECT_TRUE(points_alone.tree.nodes.empty());
}

TEST(Bvh, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto build = [](TriangleMesh mesh) { return [mesh] { (void)build_bvh(mesh); }; };
  const TriangleMesh fine{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  TriangleMesh mesh = fine;
  mesh.triangles[1][2] = 3;
  EXPECT_THAT(text_of<InvalidShape>(build(mesh)), HasSubstr("triangles[1][2] is 3, but there are 3 vertices"));
  mesh = fine;
  mesh.vertices.clear();
  EXPECT_THAT(text_of<InvalidShape>(build(mesh)), HasSubstr("triangles[0][0] is 0, but there are 0 vertices"));
  mesh = fine;
  mesh.vertices[2].y = nan;
  EXPECT_THAT(text_of<NonFinite>(build(mesh)), HasSubstr("build_bvh: vertices[2].y is nan"));
  mesh.vertices = fine.vertices;
  mesh.vertices.push_back({0, 0, -infinity});  // though no triangle names it
  EXPECT_THAT(text_of<NonFinite>(build(mesh)), HasSubstr("build_bvh: vertices[3].z is -inf"));
}

}  // namespace
}  // namespace plumb

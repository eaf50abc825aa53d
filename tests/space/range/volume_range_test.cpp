// Are the triangles those that intersects names, for every volume and for figures of many kinds?
#include "plumb/space/range/volume_range.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

template <class Volume>
class VolumeRange : public ::testing::Test {};
using RangeVolumes = ::testing::Types<Sphere3, Aabb3, Obb3, KDop3>;
TYPED_TEST_SUITE(VolumeRange, RangeVolumes);

std::size_t met = 0, apart = 0;

template <class Figure, class Volume>
void expect_met(const TriangleMesh& mesh, const Bvh& bvh, const VolumeTree<Volume>& tree, shape_cases::Material& m) {
  const auto figure = m.template shape<Figure>();
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (intersects(Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, figure)) expected.push_back(i);
  }
  EXPECT_EQ(meeting(bvh, tree, figure), expected) << m.about(figure);
  met += expected.size(), apart += mesh.triangles.size() - expected.size();
}

TYPED_TEST(VolumeRange, FindsTheTrianglesThatIntersectsNames) {
  met = apart = 0;
  std::size_t beyond = 0;
  shape_cases::on_shapes(985, battery::fitting(40), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(16), m.below(24));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    constexpr std::array fits{VolumeFit::quick, VolumeFit::tight, VolumeFit::merged};
    try {
      const auto tree = build_volume_tree<TypeParam>(bvh, {.fit = fits[m.below(3)]});
      expect_met<Ray3>(mesh, bvh, tree, m);
      expect_met<Line3>(mesh, bvh, tree, m);
      expect_met<Segment3>(mesh, bvh, tree, m);
      expect_met<Aabb3>(mesh, bvh, tree, m);
      expect_met<Obb3>(mesh, bvh, tree, m);
      expect_met<Sphere3>(mesh, bvh, tree, m);
      expect_met<Capsule3>(mesh, bvh, tree, m);
      expect_met<Triangle3>(mesh, bvh, tree, m);
      expect_met<Tetrahedron3>(mesh, bvh, tree, m);
      expect_met<Halfspace3>(mesh, bvh, tree, m);
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(met, battery::fitting(500u));
  EXPECT_GT(apart, battery::fitting(500u));
  EXPECT_LE(beyond, battery::fitting(8u));
}

TYPED_TEST(VolumeRange, OfNothingIsNothing) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  const auto empty = build_volume_tree<TypeParam>(none);
  const Ray3 ray{{0, 0, 9}, {0, 0, -1}};
  EXPECT_TRUE(meeting(none, empty, ray).empty());
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)meeting(some, empty, ray); }),
              ::testing::HasSubstr("meeting: volumes has 0 nodes"));
}

}  // namespace
}  // namespace plumb

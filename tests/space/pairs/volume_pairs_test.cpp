// Are the pairs found by spheres, boxes and k-DOPs those that are found without, of meshes that stand or were moved?
#include "plumb/space/pairs/volume_pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using Pairs = std::vector<TrianglePair>;

template <class Volume>
class VolumePairs : public ::testing::Test {};
using PairVolumes = ::testing::Types<Sphere3, Aabb3, Obb3, KDop3>;
TYPED_TEST_SUITE(VolumePairs, PairVolumes);

VolumeOptions some_options(shape_cases::Material& m, int k) {
  constexpr std::array fits{VolumeFit::quick, VolumeFit::tight, VolumeFit::merged};
  return {.fit = fits[m.below(3)], .k = k};
}

template <class Volume>
void expect_pairs(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b, const Pairs& expected,
                  const std::string& about) {
  ASSERT_EQ(intersecting_pairs(a, b, {.execution = Execution::serial}), expected) << about;
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(intersecting_pairs(a, b), expected) << about;
  }
  Pairs overlapping = expected;
  std::erase_if(overlapping, [](const TrianglePair& p) { return p.relation != Relation::overlapping; });
  EXPECT_EQ(intersecting_pairs(a, b, {.touching = false}), overlapping) << about;
  const auto any = any_intersecting_pair(a, b);
  ASSERT_EQ(any.has_value(), !expected.empty()) << about;
  if (any) {
    EXPECT_THAT(expected, ::testing::Contains(*any)) << about;
  }
  const PairWork work = pair_work(a, b);
  EXPECT_EQ(work.pairs, expected.size()) << about;
  EXPECT_GE(work.triangle_pairs, work.pairs) << about;
  EXPECT_GE(work.triangle_pairs, work.leaf_pairs) << about;
}

TYPED_TEST(VolumePairs, AreThoseWithoutVolumes) {
  std::size_t found = 0, beyond = 0;
  shape_cases::on_shapes(983, battery::fitting(100), [&](shape_cases::Material& m) {
    const Bvh a = build_bvh(meshes::soup(m, 1 + m.below(30), m.below(40)), {.most_in_leaf = 2});
    const Bvh b = build_bvh(meshes::soup(m, 1 + m.below(30), m.below(40)));
    const int k = m.below(2) == 0 ? 14 : 18;
    try {
      const auto in_a = build_volume_tree<TypeParam>(a, some_options(m, k));
      const auto in_b = build_volume_tree<TypeParam>(b, some_options(m, k));
      const Pairs expected = intersecting_pairs(a, b);
      expect_pairs<TypeParam>({a, in_a}, {b, in_b}, expected, m.about());
      found += expected.size();
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(found, battery::fitting(1000u));
  EXPECT_LT(beyond, battery::fitting(15u));
}

TYPED_TEST(VolumePairs, OfMovedMeshesAreThoseWithoutVolumes) {
  std::size_t found = 0, beyond = 0;
  shape_cases::on_shapes(984, battery::fitting(60), [&](shape_cases::Material& m) {
    const Bvh a = build_bvh(meshes::soup(m, 1 + m.below(20), m.below(30)));
    const Bvh b = build_bvh(meshes::soup(m, 1 + m.below(20), m.below(30)));
    const Pose pose = poses::any_pose(m), other = m.below(3) == 0 ? identity_pose : poses::pose_like(m, pose);
    try {
      const PosedMesh there{a, pose}, here{b, other};
      const auto in_a = posed_volume_tree(there, build_volume_tree<TypeParam>(a, some_options(m, 14)));
      const auto in_b = posed_volume_tree(here, build_volume_tree<TypeParam>(b, some_options(m, 14)));
      const Pairs expected = intersecting_pairs(there, here);
      expect_pairs<TypeParam>({there, in_a}, {here, in_b}, expected, m.about(pose, other));
      found += expected.size();
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(found, battery::fitting(700u));
  EXPECT_LT(beyond, battery::fitting(25u));
}

// A grid of exact ties: a mesh against itself moved by a lattice step, which touches itself all over.
TYPED_TEST(VolumePairs, OfALatticeMovedByItsStep) {
  TriangleMesh mesh = meshes::ring(6);
  for (Point3& p : mesh.vertices) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::round(*x * 16) / 16;
  }
  TriangleMesh moved = mesh;
  for (Point3& p : moved.vertices) p.x += 0x1p-4;
  const Bvh a = build_bvh(mesh), b = build_bvh(moved, {.method = BvhMethod::linear});
  const auto in_a = build_volume_tree<TypeParam>(a), in_b = build_volume_tree<TypeParam>(b);
  const Pairs expected = intersecting_pairs(a, b), own = intersecting_pairs(a, a);
  EXPECT_GT(expected.size(), 300u);
  expect_pairs<TypeParam>({a, in_a}, {b, in_b}, expected, "by a step");
  expect_pairs<TypeParam>({a, in_a}, {a, in_a}, own, "by nothing");
}

TYPED_TEST(VolumePairs, OfNothingAreNoneAndOfOtherTreesRefused) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  const auto in_none = build_volume_tree<TypeParam>(none), in_some = build_volume_tree<TypeParam>(some);
  const VolumeMesh nothing(none, in_none), ring(some, in_some), wrong(some, in_none);
  expect_pairs<TypeParam>(nothing, nothing, {}, "none");
  expect_pairs<TypeParam>(nothing, ring, {}, "none and some");
  expect_pairs<TypeParam>(ring, nothing, {}, "some and none");
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)intersecting_pairs(ring, wrong); }),
              HasSubstr("intersecting_pairs: b.volumes has 0 nodes"));
}

TEST(VolumePairsOfKDops, OfOtherDirectionsAreRefused) {
  const Bvh bvh = build_bvh(meshes::ring(3));
  const auto a = build_volume_tree<KDop3>(bvh, {.k = 14}), b = build_volume_tree<KDop3>(bvh, {.k = 18});
  EXPECT_THROW((void)intersecting_pairs(VolumeMesh(bvh, a), VolumeMesh(bvh, b)), InvalidShape);
}

// Tighter volumes are compared less often, and let fewer triangles through.
TEST(VolumePairsWork, IsLessWithTighterVolumes) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 8 : 12);
  const Bvh bvh = build_bvh(mesh);
  const double c = std::cos(0.5), s = std::sin(0.5);
  const PosedMesh moved{bvh, {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, {1.5, 0.25, 0.125}}};
  const auto work_of = [&]<class Volume>(const VolumeTree<Volume>& tree) {
    const auto other = posed_volume_tree(moved, tree);
    return pair_work(VolumeMesh(bvh, tree), VolumeMesh(moved, other));
  };
  const PairWork quick = work_of(build_volume_tree<Sphere3>(bvh));
  const PairWork tight = work_of(build_volume_tree<Sphere3>(bvh, {.fit = VolumeFit::tight}));
  const PairWork oriented = work_of(build_volume_tree<Obb3>(bvh, {.fit = VolumeFit::tight}));
  EXPECT_GT(tight.pairs, 10u);
  EXPECT_EQ(quick.pairs, tight.pairs);
  EXPECT_EQ(oriented.pairs, tight.pairs);
  EXPECT_LT(tight.volume_tests, quick.volume_tests);
  EXPECT_LT(oriented.volume_tests, tight.volume_tests);
  EXPECT_LT(oriented.triangle_pairs, tight.triangle_pairs);
}

}  // namespace
}  // namespace plumb

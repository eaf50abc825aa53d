// Do rays find by spheres, oriented boxes and k-DOPs what asking every triangle exactly finds?
#include "plumb/space/ray/volume_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/ray_through.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;

constexpr std::array rules{HitRule::closed, HitRule::half_open};

template <class Volume>
class VolumeRay : public ::testing::Test {};
using Volumes = ::testing::Types<Sphere3, Aabb3, Obb3, KDop3>;
TYPED_TEST_SUITE(VolumeRay, Volumes);

VolumeOptions any_volumes(Material& m) {
  constexpr std::array ks{6, 14, 18, 26};
  constexpr std::array fits{VolumeFit::quick, VolumeFit::tight, VolumeFit::merged};
  return {.fit = fits[m.below(3)], .k = ks[m.below(4)], .execution = Execution::serial};
}

TYPED_TEST(VolumeRay, FindsWhatEveryTriangleSays) {
  long hit = 0, missed = 0;
  on_shapes(973, battery::fitting(150), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 40);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    VolumeTree<TypeParam> volumes;
    try {
      volumes = build_volume_tree<TypeParam>(bvh, any_volumes(m));
    } catch (const BeyondDoubles&) {
      return;
    }
    const VolumeMesh asked(bvh, volumes);
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      for (const HitRule rule : rules) {
        const std::vector<TrueHit> expected = true_hits(ray, mesh, rule);
        const auto first = first_hit(asked, ray, rule);
        ASSERT_EQ(first.has_value(), !expected.empty()) << m.about() << text_of(ray);
        ASSERT_EQ(any_hit(asked, ray, rule), !expected.empty()) << m.about() << text_of(ray);
        if (first) {
          ASSERT_EQ(first->index, expected[0].index) << m.about() << text_of(ray);
          ASSERT_EQ(first->hit, *first_hit(ray, triangle_of(mesh, first->index), rule)) << m.about();
        }
        ++(first ? hit : missed);
      }
    }
  });
  EXPECT_GT(hit, battery::fitting(80));
  EXPECT_GT(missed, battery::fitting(80));
}

TYPED_TEST(VolumeRay, FindsWhatEveryPosedTriangleSays) {
  long compared = 0, hit = 0;
  on_shapes(974, battery::fitting(80), [&](Material& m) {
    const Bvh bvh = build_bvh(meshes::soup(m, 2 + m.below(12), 20), any_options(m));
    const PosedMesh moved{bvh, any_pose(m)};
    VolumeTree<TypeParam> volumes;
    try {
      volumes = posed_volume_tree(moved, build_volume_tree<TypeParam>(bvh, any_volumes(m)), Execution::serial);
    } catch (const BeyondDoubles&) {
      return;
    }
    ++compared;
    const VolumeMesh asked(moved, volumes);
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      for (const HitRule rule : rules) {
        const auto expected = first_hit(moved, ray, rule);
        ASSERT_EQ(first_hit(asked, ray, rule), expected) << m.about() << text_of(ray);
        ASSERT_EQ(any_hit(asked, ray, rule), expected.has_value()) << m.about() << text_of(ray);
        hit += expected.has_value();
      }
    }
  });
  EXPECT_GT(compared, battery::fitting(40));
  EXPECT_GT(hit, battery::fitting(20));
}

// From each vertex along edges, in planes of faces and through the mesh: all ties there are.
TYPED_TEST(VolumeRay, FindsWhatTheTreeFinds) {
  for (const TriangleMesh& mesh : {meshes::ring(7), meshes::repeated(40), meshes::doubling(21, -149, 17)}) {
    const Bvh bvh = build_bvh(mesh);
    const auto volumes = build_volume_tree<TypeParam>(bvh);
    const VolumeMesh asked(bvh, volumes);
    for (std::uint64_t i = 0; i < 50; ++i) {
      Entropy e(975, i);
      const Point3& a = mesh.vertices[e.below(mesh.vertices.size())];
      const Point3& b = mesh.vertices[e.below(mesh.vertices.size())];
      const Vector3 way{b.x - a.x, b.y - a.y, b.z - a.z};
      for (const AnyRay& ray : {AnyRay(Ray3{a, way}), AnyRay(Line3{b, way}), AnyRay(Segment3{b, a}),
                                AnyRay(Ray3{a, {1, 0, 0}}), AnyRay(Line3{a, {0, 0, -1}})}) {
        ASSERT_EQ(first_hit(asked, ray), first_hit(bvh, ray)) << i << text_of(ray);
        ASSERT_EQ(any_hit(asked, ray), any_hit(bvh, ray)) << i << text_of(ray);
      }
    }
  }
}

template <class Volume>
Volume drawn_volume(Material& m) {
  if constexpr (std::same_as<Volume, KDop3>) {
    const auto t = m.shape<Tetrahedron3>();
    constexpr std::array ks{6, 14, 18, 26};
    return fit_k_dop(std::array{t.a, t.b, t.c, t.d}, ks[m.below(4)]);
  } else {
    return m.shape<Volume>();
  }
}

// The interval holds the exact parameter, and where there is none it is mostly empty: something is left out.
TYPED_TEST(VolumeRay, IsInAVolumeWhereTheIntervalSays) {
  long met = 0, missed = 0, left_out = 0;
  on_shapes(976, battery::fitting(1500), [&](Material& m) {
    std::optional<TypeParam> drawn;
    try {
      drawn = drawn_volume<TypeParam>(m);
    } catch (const BeyondDoubles&) {
      return;
    }
    const TypeParam& volume = *drawn;
    const AnyRay ray = ray_of(m);
    const auto t = first_hit_parameter(ray, volume);
    const Interval at = space::RayThrough(ray)(volume);
    if (!t) {
      ++missed;
      left_out += at.lower > at.upper;
      return;
    }
    ++met;
    ASSERT_LE(at.lower, t->rounded()) << m.about() << text_of(ray);
    ASSERT_GE(at.upper, t->rounded()) << m.about() << text_of(ray);
  });
  EXPECT_GT(met, battery::fitting(100));
  EXPECT_GT(missed, battery::fitting(80));
  EXPECT_GT(3 * left_out, missed);  // not where axes are zero: such boxes have no slabs
}

TEST(VolumeRayOfNothing, IsNothingAndBadInputIsNamed) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::repeated(40));
  const auto nothing = build_volume_tree<Obb3>(none);
  const Ray3 ray{{0, 0, 1}, {0, 0, -1}};
  EXPECT_FALSE(first_hit(VolumeMesh(none, nothing), ray).has_value());
  EXPECT_FALSE(any_hit(VolumeMesh(none, nothing), ray));
  EXPECT_TRUE(text_of<InvalidShape>([&] {
                (void)any_hit(VolumeMesh(some, nothing), ray);
              }).starts_with("any_hit: mesh.volumes has 0 nodes"));
  EXPECT_THROW((void)first_hit(VolumeMesh(none, nothing), Ray3{{0, 0, NAN}, {0, 0, 1}}), NonFinite);
}

}  // namespace
}  // namespace plumb

// Does every volume hold all triangles below it, exactly, of meshes that stand and of those that have been moved?
#include "plumb/space/bvh/volume_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

template <class Volume>
class VolumeTrees : public ::testing::Test {};
using Volumes = ::testing::Types<Sphere3, Aabb3, Obb3, KDop3>;
TYPED_TEST_SUITE(VolumeTrees, Volumes);

VolumeOptions any_options(shape_cases::Material& m) {
  constexpr std::array fits{VolumeFit::quick, VolumeFit::tight, VolumeFit::merged};
  constexpr std::array ks{6, 8, 14, 18, 26};
  return {.fit = fits[m.below(3)], .k = ks[m.below(5)]};
}

/// inside(volume, corner) of each corner below each node.
template <class Volume, class Inside>
void expect_all_below(const Bvh& bvh, const VolumeTree<Volume>& tree, const Inside& inside, const std::string& about) {
  const std::span<const VolumeNode<Volume>> nodes = tree.nodes.view();
  ASSERT_EQ(nodes.size(), bvh.tree.nodes.size()) << about;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> slots(nodes.size());  // begin, end
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const VolumeNode<Volume>& n = nodes[i];
    ASSERT_EQ(n.link, bvh.tree.nodes[i].link) << about;
    ASSERT_EQ(n.count, bvh.tree.nodes[i].count) << about;
    slots[i] =
        n.is_leaf() ? std::pair{n.link, n.link + n.count} : std::pair{slots[i + 1].first, slots[i + n.link].second};
    for (std::uint32_t s = slots[i].first; s < slots[i].second; ++s) {
      const auto [a, b, c] = bvh.triangle(s);
      for (const Point3& p : {a, b, c}) ASSERT_TRUE(inside(n.volume, p)) << about << " node " << i << " slot " << s;
    }
  }
}

TYPED_TEST(VolumeTrees, HoldAllBelowThem) {
  std::size_t held = 0, beyond = 0;
  shape_cases::on_shapes(981, battery::fitting(150), [&](shape_cases::Material& m) {
    const Bvh bvh = build_bvh(meshes::soup(m, 1 + m.below(20), m.below(40)),
                              {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
    const VolumeOptions options = any_options(m);
    try {
      const auto tree = build_volume_tree<TypeParam>(bvh, options);
      expect_all_below(
          bvh, tree, [](const TypeParam& v, const Point3& p) { return contains(v, p); }, m.about());
      held += tree.nodes.size();
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(held, battery::fitting(1000u));
  EXPECT_LE(beyond, battery::fitting(15u));
}

// The planes of k-DOPs and of boxes, and balls, against images in rationals.
using poses::image;
using poses::RationalPoint;

bool holds(const Sphere3& v, const RationalPoint& p) {
  const mpq_class x = p[0] - mpq_class(v.center.x), y = p[1] - mpq_class(v.center.y), z = p[2] - mpq_class(v.center.z);
  return x * x + y * y + z * z <= mpq_class(v.radius) * mpq_class(v.radius);
}
bool holds(const Aabb3& v, const RationalPoint& p) {
  return v.min.x <= p[0] && p[0] <= v.max.x && v.min.y <= p[1] && p[1] <= v.max.y && v.min.z <= p[2] && p[2] <= v.max.z;
}
bool holds(const KDop3& v, const RationalPoint& p) {
  for (std::size_t i = 0; i < v.min.size(); ++i) {
    const Vector3& d = v.directions.all()[i];
    const mpq_class at = mpq_class(d.x) * p[0] + mpq_class(d.y) * p[1] + mpq_class(d.z) * p[2];
    if (at < v.min[i] || v.max[i] < at) return false;
  }
  return true;
}
/// By Cramer's rule, of boxes whose axes are independent: else a point is in one where it is on all planes of theirs.
bool holds(const Obb3& v, const RationalPoint& p) {
  using Row = std::array<mpq_class, 3>;
  const auto row = [](const Vector3& a) { return Row{mpq_class(a.x), mpq_class(a.y), mpq_class(a.z)}; };
  const std::array axes{row(v.axes[0]), row(v.axes[1]), row(v.axes[2])};
  const Row q{p[0] - mpq_class(v.center.x), p[1] - mpq_class(v.center.y), p[2] - mpq_class(v.center.z)};
  const auto det = [](const Row& a, const Row& b, const Row& c) -> mpq_class {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const mpq_class all = abs(det(axes[0], axes[1], axes[2]));
  EXPECT_NE(all, 0);
  return abs(det(q, axes[1], axes[2])) <= all * abs(mpq_class(v.half.x)) &&
         abs(det(axes[0], q, axes[2])) <= all * abs(mpq_class(v.half.y)) &&
         abs(det(axes[0], axes[1], q)) <= all * abs(mpq_class(v.half.z));
}

TYPED_TEST(VolumeTrees, HoldTheExactImageOfAMovedMesh) {
  std::size_t held = 0, beyond = 0;
  shape_cases::on_shapes(982, battery::fitting(120), [&](shape_cases::Material& m) {
    const Bvh bvh = build_bvh(meshes::soup(m, 1 + m.below(20), m.below(30)));
    Pose pose = poses::any_pose(m);
    if (std::is_same_v<TypeParam, Obb3>) pose = m.below(2) == 0 ? poses::turn(m) : identity_pose;
    try {
      const auto tree = build_volume_tree<TypeParam>(bvh, any_options(m));
      const auto moved = posed_volume_tree({bvh, pose}, tree);
      const auto inside = [&](const TypeParam& v, const Point3& p) { return holds(v, image(p, pose)); };
      expect_all_below(bvh, moved, inside, m.about(pose));
      held += moved.nodes.size();
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(held, battery::fitting(400u));
  EXPECT_LE(beyond, battery::fitting(40u));
}

TYPED_TEST(VolumeTrees, DependOnNoThread) {
  const Bvh bvh = build_bvh(meshes::ring(12));
  for (const VolumeFit fit : {VolumeFit::quick, VolumeFit::merged}) {
    const auto serial = build_volume_tree<TypeParam>(bvh, {.fit = fit, .execution = Execution::serial});
    for (const std::size_t threads : {1u, 2u}) {
      const ThreadLimit control(threads);
      EXPECT_TRUE(std::ranges::equal(build_volume_tree<TypeParam>(bvh, {.fit = fit}).nodes, serial.nodes));
    }
  }
}

TYPED_TEST(VolumeTrees, OfNothingAreEmptyAndOfOtherMeshesRefused) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  const auto empty = build_volume_tree<TypeParam>(none);
  EXPECT_TRUE(empty.nodes.empty());
  EXPECT_TRUE(posed_volume_tree({none, identity_pose}, empty).nodes.empty());
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)posed_volume_tree({some, identity_pose}, empty);
              }),
              HasSubstr("posed_volume_tree: tree has 0 nodes, but the mesh's tree "));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pose bad{identity_pose.columns, {0, nan, 0}};
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)posed_volume_tree({none, bad}, empty);
              }),
              HasSubstr("posed_volume_tree: mesh.pose.translation.y is nan"));
}

TEST(VolumeTreesOfSpheres, AreTighterWhereTheyAreAskedToBe) {
  const Bvh bvh = build_bvh(meshes::ring(10));
  const auto radii = [&](VolumeFit fit) {
    double sum = 0;
    for (const auto& node : build_volume_tree<Sphere3>(bvh, {.fit = fit}).nodes) sum += node.volume.radius;
    return sum;
  };
  const double tight = radii(VolumeFit::tight), quick = radii(VolumeFit::quick), merged = radii(VolumeFit::merged);
  EXPECT_LT(tight, quick);
  EXPECT_LT(quick, merged);
}

}  // namespace

/// A slab across the x axis, which is nobody's idea of a good volume.
struct SlabVolume {
  double min, max;
};
template <>
struct VolumeRules<SlabVolume> {
  static SlabVolume both(const SlabVolume& a, const SlabVolume& b) {
    return {std::min(a.min, b.min), std::max(a.max, b.max)};
  }
  static bool meet(const SlabVolume& a, const SlabVolume& b) { return a.min <= b.max && b.min <= a.max; }
  static double size(const SlabVolume& v) { return v.max - v.min; }
};

namespace {

// Of balls, with a volume that the library does not know: pairs of balls whose slabs meet.
TEST(VolumeTreesOfOnesOwn, AreBuiltOverAnyItems) {
  std::vector<Aabb3> boxes;
  for (int i = 0; i < 60; ++i) boxes.push_back({{(i * 17) % 60 * 1.0, 0, 0}, {(i * 17) % 60 + 1.5, 1, 1}});
  const BoxTree tree = build_box_tree(boxes, {.most_in_leaf = 1});
  const auto slabs = merged_volume_tree<SlabVolume>(tree, [&](std::uint32_t first, std::uint32_t) {
    const Aabb3& box = boxes[tree.items[first]];
    return SlabVolume{box.min.x, box.max.x};
  });
  EXPECT_EQ(slabs.nodes[0].volume.max, 60.5);
  std::size_t pairs = 0;
  descend_pairs(slabs, slabs, descend_larger{}, volumes_meet{},
                [&](const VolumeNode<SlabVolume>&, const VolumeNode<SlabVolume>&) { ++pairs; });
  EXPECT_EQ(pairs, 60u + 2 * 59u);
  std::size_t own = 0;
  descend_own_pairs(slabs, volumes_meet{},
                    [&](const VolumeNode<SlabVolume>&, const VolumeNode<SlabVolume>&) { ++own; });
  EXPECT_EQ(own, 60u + 59u);
}

}  // namespace
}  // namespace plumb

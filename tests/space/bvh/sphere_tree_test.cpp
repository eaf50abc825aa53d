// Is the whole surface in the spheres of every level, each around its children and none without a point of the surface?
#include "plumb/space/bvh/sphere_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using poses::RationalPoint;
using ::testing::HasSubstr;

constexpr std::array covers{SphereCover::octree, SphereCover::pieces, SphereCover::pruned};

bool holds(const Sphere3& v, const RationalPoint& p) {
  const mpq_class x = p[0] - mpq_class(v.center.x), y = p[1] - mpq_class(v.center.y), z = p[2] - mpq_class(v.center.z);
  return x * x + y * y + z * z <= mpq_class(v.radius) * mpq_class(v.radius);
}

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// A point of the moved triangle with these weights, in sevenths and the like, which are no doubles.
RationalPoint weighted(const Triangle3& t, const Pose& pose, long u, long v, long w) {
  const RationalPoint a = poses::image(t.a, pose), b = poses::image(t.b, pose), c = poses::image(t.c, pose);
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = (u * a[k] + v * b[k] + w * c[k]) / mpq_class(u + v + w);
  return p;
}

void expect_nested(const SphereTree& tree, const std::string& about) {
  ASSERT_GT(tree.levels(), 0u) << about;
  ASSERT_EQ(tree.level(0).size(), 1u) << about;
  ASSERT_EQ(tree.begin_of_level.back(), tree.nodes.size()) << about;
  std::size_t next = 1;
  for (std::uint32_t k = 0; k < tree.levels(); ++k) {
    for (const SphereNode& node : tree.level(k)) {
      if (k + 1 == tree.levels()) {
        ASSERT_EQ(node.children, 0u) << about;
        continue;
      }
      ASSERT_GT(node.children, 0u) << about;
      ASSERT_EQ(node.first_child, next) << about;
      next += node.children;
      for (std::uint32_t c = 0; c < node.children; ++c)
        ASSERT_TRUE(contains(node.sphere, tree.nodes[node.first_child + c].sphere)) << about << " level " << k;
    }
  }
  EXPECT_EQ(next, tree.nodes.size()) << about;
}

/// Corners and points inside of each triangle, in a sphere of each level.
void expect_covered(const SphereTree& tree, const TriangleMesh& mesh, const Pose& pose, const std::string& about) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle3 t = at(mesh, i);
    for (const auto& [u, v, w] : {std::tuple{1L, 0L, 0L},
                                  {0L, 1L, 0L},
                                  {0L, 0L, 1L},
                                  {3L, 4L, 0L},
                                  {0L, 1L, 1L},
                                  {1L, 1L, 1L},
                                  {5L, 1L, 1L},
                                  {2L, 3L, 8L}}) {
      const RationalPoint p = weighted(t, pose, u, v, w);
      for (std::uint32_t k = 0; k < tree.levels(); ++k) {
        const auto level = tree.level(k);
        ASSERT_TRUE(std::ranges::any_of(level, [&](const SphereNode& n) { return holds(n.sphere, p); }))
            << about << " triangle " << i << " level " << k;
      }
    }
  }
}

class SphereTrees : public ::testing::TestWithParam<SphereCover> {};
INSTANTIATE_TEST_SUITE_P(Covers, SphereTrees, ::testing::ValuesIn(covers));

TEST_P(SphereTrees, CoverTheSurfaceOnEachLevel) {
  std::size_t spheres = 0, beyond = 0;
  shape_cases::on_shapes(986, battery::fitting(40), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(12), 1 + m.below(8));
    try {
      const SphereTree tree = build_sphere_tree(mesh, {GetParam(), static_cast<std::uint32_t>(1 + m.below(4))});
      expect_nested(tree, m.about());
      expect_covered(tree, mesh, identity_pose, m.about());
      for (const SphereNode& n : tree.level(tree.levels() - 1)) {
        bool met = false;
        for (std::size_t i = 0; i < mesh.triangles.size() && !met; ++i) met = intersects(at(mesh, i), n.sphere);
        EXPECT_TRUE(met) << m.about();
      }
      spheres += tree.nodes.size();
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  EXPECT_GT(spheres, battery::fitting(500u));
  EXPECT_LE(beyond, battery::fitting(8u));
}

TEST_P(SphereTrees, CoverTheExactImage) {
  std::size_t spheres = 0;
  shape_cases::on_shapes(987, battery::fitting(30), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(12), 1 + m.below(6));
    const Pose pose = poses::any_pose(m);
    try {
      const SphereTree moved = transform(build_sphere_tree(mesh, {GetParam(), 3}), pose);
      expect_nested(moved, m.about(pose));
      expect_covered(moved, mesh, pose, m.about(pose));
      spheres += moved.nodes.size();
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(spheres, battery::fitting(300u));
}

TEST_P(SphereTrees, OfNothingAreEmptyAndOfAPointOneSphere) {
  const SphereTree none = build_sphere_tree(TriangleMesh{}, {GetParam()});
  EXPECT_EQ(none.levels(), 0u);
  EXPECT_TRUE(none.level(0).empty());
  EXPECT_EQ(transform(none, identity_pose), none);
  const SphereTree point = build_sphere_tree({{{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}}, {GetParam(), 3});
  for (std::uint32_t k = 0; k < point.levels(); ++k) {
    for (const SphereNode& n : point.level(k)) EXPECT_EQ(n.sphere, (Sphere3{{1, 2, 3}, 0}));
  }
}

TEST_P(SphereTrees, DependOnNoThreadAndNoTree) {
  const TriangleMesh mesh = meshes::ring(7);
  const SphereTreeOptions options{GetParam(), 4};
  const SphereTree tree = build_sphere_tree(mesh, options);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(build_sphere_tree(mesh, options), tree);
    EXPECT_EQ(build_sphere_tree(build_bvh(mesh), options), tree);
  }
}

TEST_P(SphereTrees, BecomeFinerWithEachLevel) {
  const TriangleMesh mesh = meshes::ring(9);
  double before = HUGE_VAL;
  for (const std::uint32_t levels : {1u, 2u, 3u, 4u, 5u}) {
    const SphereTree tree = build_sphere_tree(mesh, {GetParam(), levels});
    double largest = 0;
    for (const SphereNode& n : tree.level(tree.levels() - 1)) largest = std::max(largest, n.sphere.radius);
    EXPECT_LE(largest, before) << levels;  // triangles that are small enough stay whole
    EXPECT_LE(largest, 2.8 * std::sqrt(0.75) * std::ldexp(1.0, 1 - static_cast<int>(levels)) * 1.01) << levels;
    before = largest;
  }
}

TEST(PrunedSphereTrees, HaveTheFewestSpheres) {
  const TriangleMesh mesh = meshes::ring(9);
  const auto spheres = [&](SphereCover cover) {
    const SphereTree tree = build_sphere_tree(mesh, {cover, 4});
    return tree.level(tree.levels() - 1).size();
  };
  EXPECT_LT(spheres(SphereCover::pruned), spheres(SphereCover::octree));
  EXPECT_LT(spheres(SphereCover::pruned), spheres(SphereCover::pieces));
}

TEST(SphereTreesOf, WhatIsWrongIsRefused) {
  const TriangleMesh mesh = meshes::ring(3);
  for (const std::uint32_t levels : {0u, 13u}) {
    EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_sphere_tree(mesh, {.levels = levels}); }),
                HasSubstr("build_sphere_tree: levels is "));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)build_sphere_tree({{{0, nan, 0}}, {{0, 0, 0}}}), NonFinite);
  EXPECT_THROW((void)build_sphere_tree({{{0, 0, 0}}, {{0, 0, 1}}}), InvalidShape);
  EXPECT_THROW((void)transform(build_sphere_tree(mesh), Pose{identity_pose.columns, {nan, 0, 0}}), NonFinite);
}

}  // namespace
}  // namespace plumb

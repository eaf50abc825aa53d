// Does the slab test meet every box that the exact ray meets, and few others?
#include "plumb/space/ray/ray_slabs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "space/bvh/tree_laws.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

TEST(RaySlabs, MeetTheBoxesThatTheRayMeets) {
  long met = 0, missed = 0, met_in_vain = 0;
  on_shapes(951, battery::fitting(600), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 12);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    if (bvh.tree.nodes.empty() || bvh.tree.frame.exponent() != 0) return;
    for (int k = 0; k < 4; ++k) {
      const AnyRay ray = ray_of(m);
      const RaySlabs slabs(ray, bvh.tree);
      for (const BoxNode& node : bvh.tree.nodes) {
        const Aabb3 box{{node.min[0], node.min[1], node.min[2]}, {node.max[0], node.max[1], node.max[2]}};
        const double key = slabs(node);
        if (const auto t = first_hit_parameter(ray, box)) {
          ++met;
          ASSERT_LE(key, slabs.limit_at(t->rounded(Rounding::up))) << m.about() << " " << text_of(ray);
          ASSERT_LE(key, slabs.limit()) << m.about() << " " << text_of(ray);
          continue;
        }
        ++missed;
        met_in_vain += !(key > slabs.limit());
      }
    }
  });
  EXPECT_GT(met, battery::fitting(2000));
  EXPECT_GT(missed, battery::fitting(1000));
  EXPECT_LT(met_in_vain * 10, missed) << met_in_vain << " of " << missed;
}

// A ray that enters in x just where it leaves in y, exactly, though no double is that difference: it touches an edge.
TEST(RaySlabs, MeetABoxAtItsEdge) {
  for (std::uint64_t i = 0; i < battery::fitting(20000u); ++i) {
    Entropy e(953, i);
    const auto p = static_cast<double>(1 + e.below(63)), q = static_cast<double>(1 + e.below(63));
    const auto m = static_cast<double>(static_cast<float>(1 + e.below(1 << 17)));
    const double s = std::ldexp(static_cast<double>(e.below(1ULL << 45)), -50 - static_cast<int>(e.below(40)));
    const double x = e.coin() ? 1 : -1, y = e.coin() ? 1 : -1;
    const auto [left, right] = std::minmax({x * p * m, x * (p * m + 1)});
    const auto [low, high] = std::minmax({y * (q * m - 1), y * q * m});
    const BoxTree tree = build_box_tree(std::vector<Aabb3>{{{left, low, -1}, {right, high, 1}}});
    const Aabb3 box{{left, low, -1}, {right, high, 1}};
    for (const AnyRay& ray : {AnyRay(Ray3{{x * p * s, y * q * s, 0}, {x * p, y * q, 0}}),
                              AnyRay(Line3{{x * p * s, y * q * s, 0}, {x * p, y * q, 0}}),
                              AnyRay(Segment3{{x * p * s, y * q * s, 0.5}, {x * p * m, y * q * m, 0.5}})}) {
      const auto t = first_hit_parameter(ray, box);
      ASSERT_TRUE(t) << "index " << i << " " << text_of(ray);
      const RaySlabs slabs(ray, tree);
      ASSERT_LE(slabs(tree.nodes[0]), slabs.limit()) << "index " << i << " " << text_of(ray);
      ASSERT_LE(slabs(tree.nodes[0]), slabs.limit_at(t->rounded(Rounding::up))) << "index " << i << " " << text_of(ray);
    }
  }
}

TEST(RaySlabs, LeaveOutNothingInAnyFrame) {
  long hit = 0;
  on_shapes(952, battery::fitting(1500), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 12);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const AnyRay ray = ray_of(m);
    const RaySlabs slabs(ray, bvh.tree);
    for (const BoxNode& node : bvh.tree.nodes) {
      for (std::uint32_t i = 0; i < node.count; ++i) {
        const auto t = first_hit_parameter(ray, bvh.triangle(node.link + i));
        if (!t) continue;
        ++hit;
        ASSERT_LE(slabs(node), slabs.limit_at(t->rounded(Rounding::up))) << m.about() << " " << text_of(ray);
        ASSERT_LE(slabs(node), slabs.limit()) << m.about() << " " << text_of(ray);
        ASSERT_LE(slabs(bvh.tree.nodes[0]), slabs.limit());
      }
    }
  });
  EXPECT_GT(hit, battery::fitting(500));
}

/// How many leaves may a ray meet?
long leaves_met(const Bvh& bvh, const AnyRay& ray) {
  const RaySlabs slabs(ray, bvh.tree);
  long leaves = 0;
  descend(
      bvh.tree, [&](const BoxNode& node) { return !(slabs(node) > slabs.limit()); },
      [&](std::uint32_t, std::uint32_t) { ++leaves; });
  return leaves;
}

// From wherever it comes, whatever the length of its direction: a ray meets some boxes of thousands.
TEST(RaySlabs, AreSharpFromFarAway) {
  for (const double size : {1.0, 0x1p300, 0x1p-300}) {
    TriangleMesh mesh = meshes::ring(24);
    for (Point3& p : mesh.vertices) p = {p.x * size, p.y * size, p.z * size};
    const Bvh bvh = build_bvh(mesh);
    for (const double away : {2.0, 1e6, 1e12, 1e18, 1e24}) {
      for (const double speed : {1.0, 0x1p-400, 0x1p400}) {
        const double far = away * size;
        const Ray3 across{{0.1 * size, far, 0.2 * size}, {0, -speed, 0}};
        const Ray3 slanting{{far, far, 0.25 * far}, {-speed, -speed, -0.25 * speed}};
        const Line3 line{{far, far, 0.25 * far}, {speed, speed, 0.25 * speed}};
        for (const AnyRay& ray : {AnyRay(across), AnyRay(slanting), AnyRay(line)}) {
          EXPECT_LT(leaves_met(bvh, ray), 60) << size << " " << away << " " << text_of(ray);
          EXPECT_GT(leaves_met(bvh, ray), 0) << size << " " << away << " " << text_of(ray);
        }
      }
      const Segment3 segment{{0, -away * size, 0}, {0.01 * size, away * size, 0.3 * size}};
      EXPECT_LT(leaves_met(bvh, segment), 60) << size << " " << away;
    }
  }
}

TEST(RaySlabs, RefuseWhatIsNoRay) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RaySlabs(Ray3{{0, nan, 0}, {1, 0, 0}}, bvh.tree), NonFinite);
}

}  // namespace
}  // namespace plumb

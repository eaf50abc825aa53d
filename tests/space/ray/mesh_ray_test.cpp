// Do rays at a mesh's tree find what asking every triangle exactly finds?
#include "plumb/space/ray/mesh_ray.hpp"

#include <gtest/gtest.h>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

void check(const AnyRay& ray, const TriangleMesh& mesh, const Bvh& bvh, HitRule rule, const std::string& about) {
  const std::vector<TrueHit> expected = true_hits(ray, mesh, rule);
  const auto first = first_hit(bvh, ray, rule);
  ASSERT_EQ(first.has_value(), !expected.empty()) << about;
  ASSERT_EQ(any_hit(bvh, ray, rule), !expected.empty()) << about;
  ASSERT_EQ(count_hits(bvh, ray, rule), expected.size()) << about;
  ASSERT_EQ(first_triangle(bvh, ray, rule).has_value(), !expected.empty()) << about;
  const std::vector<NumberedHit> all = hits(bvh, ray, rule);
  ASSERT_EQ(all.size(), expected.size()) << about;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].index, expected[i].index) << about << " hit " << i;
    ASSERT_EQ(all[i].hit, *first_hit(ray, triangle_of(mesh, all[i].index), rule)) << about << " hit " << i;
  }
  if (expected.empty()) return;
  ASSERT_EQ(first->index, expected[0].index) << about;
  ASSERT_EQ(*first, all[0]) << about;
  ASSERT_EQ(*first_triangle(bvh, ray, rule), expected[0].index) << about;
}

TEST(MeshRay, FindsWhatEveryTriangleSays) {
  long hit = 0, several = 0, ties = 0, missed = 0;
  const auto sets = batch_instruction_sets();
  std::size_t shapes = 0;
  on_shapes(961, battery::fitting(700), [&](Material& m) {
    certify::batch::take_instruction_set(sets[shapes++ % sets.size()]);
    const TriangleMesh mesh = drawn_mesh(m, 40);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      for (const HitRule rule : {HitRule::closed, HitRule::half_open})
        check(ray, mesh, bvh, rule, m.about() + " " + text_of(ray));
      const auto all = true_hits(ray, mesh, HitRule::closed);
      missed += all.empty();
      hit += !all.empty();
      several += all.size() > 1;
      ties += all.size() > 1 && all[0].t == all[1].t;
    }
  });
  certify::batch::take_instruction_set({});
  EXPECT_GT(hit, battery::fitting(300));
  EXPECT_GT(several, battery::fitting(100));
  EXPECT_GT(ties, battery::fitting(50));
  EXPECT_GT(missed, battery::fitting(300));
}

TEST(MeshRay, FindsThemInClosedMeshes) {
  const TriangleMesh mesh = meshes::ring(8);
  const Bvh bvh = build_bvh(mesh);
  for (std::uint64_t i = 0; i < 40; ++i) {
    Entropy e(962, i);
    const Point3& a = mesh.vertices[e.below(mesh.vertices.size())];
    const Point3& b = mesh.vertices[e.below(mesh.vertices.size())];
    const Vector3 d{b.x - a.x, b.y - a.y, b.z - a.z};
    const std::string about = "index " + std::to_string(i);
    check(Ray3{a, d}, mesh, bvh, HitRule::closed, about);
    check(Ray3{{a.x - d.x, a.y - d.y, a.z - d.z}, d}, mesh, bvh, HitRule::half_open, about);
    check(Line3{a, d}, mesh, bvh, HitRule::closed, about);
    check(Segment3{a, b}, mesh, bvh, HitRule::closed, about);
    check(Ray3{{a.x, a.y, 2}, {0, 0, -1}}, mesh, bvh, HitRule::closed, about);
  }
}

// Planes across the ray by ulps apart, and equal ones, in any order: only exact parameters tell them apart.
TEST(MeshRay, OrdersWhatDoublesCannot) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Entropy e(963, i);
    TriangleMesh mesh;
    for (std::uint32_t k = 0; k < 40; ++k) {
      const double z = moved_by_ulps(1.0, e.within(2)), tilt = static_cast<double>(e.within(1)) * 0x1p-52;
      mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {2, -1, z + tilt}, {-1, 2, z - tilt}});
      mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const double x = static_cast<double>(e.within(1)) * 0.1;
    check(Ray3{{x, 0.1, 0}, {0, 0, 1}}, mesh, build_bvh(mesh), HitRule::closed, "index " + std::to_string(i));
    check(Ray3{{x, 0.1, 3}, {0.1, 0, -1.3}}, mesh, build_bvh(mesh), HitRule::closed, "index " + std::to_string(i));
  }
}

/// Planes that the ray runs in, whose normals take more digits than a stack has room for.
TEST(MeshRay, OrdersWhatLiesFarApart) {
  const double far = 0x1p512, less_far = 0x1p480;
  const TriangleMesh box{{{0, 0, 0}, {0, 1, 0}, {far, 0, 0}, {1, far, 0}}, {{2, 0, 3}, {3, 0, 1}}};
  check(Ray3{{0, 1, 0}, {0, -1, 0}}, box, build_bvh(box), HitRule::closed, "box");
  const TriangleMesh torus{{{less_far, less_far, 0}, {0, 0, 0}, {-1, 0, 0}, {0, less_far, 0}}, {{0, 2, 3}, {0, 3, 1}}};
  check(Ray3{{0, 0, 0}, {0, 1, 0}}, torus, build_bvh(torus), HitRule::closed, "torus");
}

TEST(MeshRay, OfNothingIsNothing) {
  const Bvh nothing = build_bvh(TriangleMesh{});
  for (const AnyRay& ray : {AnyRay(Ray3{{0, 0, 0}, {1, 0, 0}}), AnyRay(Line3{{0, 0, 0}, {1, 0, 0}}),
                            AnyRay(Segment3{{0, 0, 0}, {1, 0, 0}}), AnyRay(Ray3{{0, 0, 0}, {0, 0, 0}})}) {
    EXPECT_FALSE(first_hit(nothing, ray) || first_triangle(nothing, ray) || any_hit(nothing, ray));
    EXPECT_TRUE(hits(nothing, ray).empty());
    EXPECT_EQ(count_hits(nothing, ray), 0u);
  }
}

TEST(MeshRay, SameTriangleThousandsOfTimes) {
  const Bvh bvh = build_bvh(meshes::repeated(3000));
  const Ray3 ray{{0.2, 0.2, 3}, {0, 0, -1}};
  EXPECT_EQ(first_triangle(bvh, ray), 0u);
  EXPECT_EQ(count_hits(bvh, ray), 3000u);
  EXPECT_EQ(hits(bvh, ray)[2999].index, 2999u);
}

TEST(ManyRays, AreAnsweredAsEachAloneByAnyInstructionSetAndNumberOfThreads) {
  const TriangleMesh mesh = meshes::ring(16);
  const Bvh bvh = build_bvh(mesh);
  std::vector<AnyRay> rays;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    Entropy e(964, i);
    const auto any = [&] { return static_cast<double>(e.within(1000)) / 500; };
    rays.emplace_back(Ray3{{any(), any(), any()}, {any(), any(), any()}});
  }
  for (const std::string_view set : batch_instruction_sets()) {
    SCOPED_TRACE(set);
    certify::batch::take_instruction_set(set);
    const ManyRays options{.execution = set == batch_instruction_sets()[0] ? Execution::serial : Execution::parallel};
    std::vector<std::optional<NumberedHit>> first(rays.size());
    std::vector<std::uint32_t> triangle(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::size_t> count(rays.size());
    std::vector<std::vector<NumberedHit>> ordered(rays.size());
    first_hit(bvh, rays, first, options);
    first_triangle(bvh, rays, triangle, options);
    any_hit(bvh, rays, any, options);
    count_hits(bvh, rays, count, options);
    hits(bvh, rays, ordered, options);
    long hit = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(first[i], first_hit(bvh, rays[i])) << "ray " << i;
      ASSERT_EQ(triangle[i], first[i] ? first[i]->index : no_triangle) << "ray " << i;
      ASSERT_EQ(any[i], first[i] ? 1 : 0) << "ray " << i;
      ASSERT_EQ(count[i], count_hits(bvh, rays[i])) << "ray " << i;
      ASSERT_EQ(ordered[i], hits(bvh, rays[i])) << "ray " << i;
      hit += first[i].has_value();
    }
    EXPECT_GT(hit, 150);
    EXPECT_LT(hit, 1400);
  }
  certify::batch::take_instruction_set({});
}

TEST(ManyRays, ReportProgressAndStop) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  const std::vector<AnyRay> rays(2000, Ray3{{2, 0, 0}, {-1, 0, 0}});
  std::vector<std::uint32_t> out(rays.size());
  for (const Execution execution : {Execution::serial, Execution::parallel}) {
    std::vector<double> seen;
    const auto keep = [&](double share) {
      seen.push_back(share);
      return true;
    };
    first_triangle(bvh, rays, out, {.execution = execution, .progress = keep});
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), 1.0);
    EXPECT_THROW(first_triangle(bvh, rays, out, {.execution = execution, .progress = [](double) { return false; }}),
                 Cancelled);
  }
}

TEST(ManyRays, RefuseWhatDoesNotFit) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  std::vector<AnyRay> rays(3, Ray3{{0, 0, 0}, {1, 0, 0}});
  std::vector<std::uint32_t> out(2);
  EXPECT_EQ(text_of<UnequalLengths>([&] { first_triangle(bvh, rays, out); }),
            "first_triangle: out has 2 items, rays has 3");
  out.resize(3);
  rays[1].direction.y = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(text_of<NonFinite>([&] { first_triangle(bvh, rays, out); }).starts_with("first_triangle: "));
  EXPECT_THROW((void)first_hit(build_bvh(TriangleMesh{}), rays[1]), NonFinite);
}

}  // namespace
}  // namespace plumb

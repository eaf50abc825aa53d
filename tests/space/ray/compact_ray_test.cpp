// Do rays at a compact tree find what asking every triangle exactly finds, and what the tree finds that it is made of?
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

void check(const AnyRay& ray, const TriangleMesh& mesh, const CompactBvh& bvh, HitRule rule, const std::string& about) {
  const std::vector<TrueHit> expected = true_hits(ray, mesh, rule);
  ASSERT_EQ(any_hit(bvh, ray, rule), !expected.empty()) << about;
  ASSERT_EQ(count_hits(bvh, ray, rule), expected.size()) << about;
  const std::vector<NumberedHit> all = hits(bvh, ray, rule);
  ASSERT_EQ(all.size(), expected.size()) << about;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].index, expected[i].index) << about << " hit " << i;
    ASSERT_EQ(all[i].hit, *first_hit(ray, triangle_of(mesh, all[i].index), rule)) << about << " hit " << i;
  }
  const auto first = first_hit(bvh, ray, rule);
  const auto triangle = first_triangle(bvh, ray, rule);
  ASSERT_EQ(first.has_value(), !expected.empty()) << about;
  ASSERT_EQ(triangle.has_value(), !expected.empty()) << about;
  if (expected.empty()) return;
  ASSERT_EQ(*first, all[0]) << about;
  ASSERT_EQ(*triangle, all[0].index) << about;
}

TEST(CompactRay, FindsWhatEveryTriangleSays) {
  long hit = 0, several = 0, missed = 0;
  const auto sets = batch_instruction_sets();
  std::size_t shapes = 0;
  on_shapes(984, battery::fitting(500), [&](Material& m) {
    certify::batch::take_instruction_set(sets[shapes++ % sets.size()]);
    const TriangleMesh mesh = drawn_mesh(m, 60);
    const CompactBvh bvh = build_compact_bvh(mesh, any_options(m));
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
        check(ray, mesh, bvh, rule, m.about() + " " + text_of(ray));
      }
      const std::size_t found = count_hits(bvh, ray);
      missed += found == 0;
      hit += found > 0;
      several += found > 1;
    }
  });
  certify::batch::take_instruction_set({});
  EXPECT_GT(hit, battery::fitting(200));
  EXPECT_GT(several, battery::fitting(80));
  EXPECT_GT(missed, battery::fitting(200));
}

// Triangles anywhere in the doubles, and rays from each to each.
TEST(CompactRay, FindsThemAtExtremeExponents) {
  long several = 0;
  on_shapes(985, battery::fitting(150), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 2 + m.below(12), 40);
    const CompactBvh bvh = build_compact_bvh(mesh);
    const Point3 &a = mesh.vertices[m.below(mesh.vertices.size())], &b = mesh.vertices[m.below(mesh.vertices.size())];
    check(Segment3{a, b}, mesh, bvh, HitRule::closed, m.about(a, b));
    several += count_hits(bvh, Segment3{a, b}) > 1;
  });
  EXPECT_GT(several, battery::fitting(70));
  for (const int first : {-1074, -500, 0, 400}) {
    const TriangleMesh mesh = meshes::doubling(36, first, 17);
    const CompactBvh bvh = build_compact_bvh(mesh, {.most_in_leaf = 1});
    EXPECT_EQ(count_hits(bvh, Line3{{0, 0, 0}, {1, -1, 1}}), 36u) << first;
    check(Ray3{mesh.vertices[20], {1, -1, 1}}, mesh, bvh, HitRule::closed, "doubling " + std::to_string(first));
    check(Segment3{mesh.vertices[30], mesh.vertices[3]}, mesh, bvh, HitRule::closed, "doubling, back");
  }
}

TEST(CompactRay, OfNothingIsNothing) {
  const CompactBvh nothing = build_compact_bvh(TriangleMesh{});
  for (const AnyRay& ray : {AnyRay(Ray3{{0, 0, 0}, {1, 0, 0}}), AnyRay(Line3{{0, 0, 0}, {1, 0, 0}}),
                            AnyRay(Segment3{{0, 0, 0}, {1, 0, 0}}), AnyRay(Ray3{{0, 0, 0}, {0, 0, 0}})}) {
    EXPECT_FALSE(first_hit(nothing, ray) || first_triangle(nothing, ray) || any_hit(nothing, ray));
    EXPECT_TRUE(hits(nothing, ray).empty());
    EXPECT_EQ(count_hits(nothing, ray), 0u);
  }
  EXPECT_THROW((void)first_hit(nothing, Ray3{{0, 0, 0}, {0, 0, std::nan("")}}), NonFinite);
}

TEST(CompactRay, SameTriangleThousandsOfTimes) {
  const CompactBvh bvh = build_compact_bvh(meshes::repeated(3000), {.most_in_leaf = 255});
  const Ray3 ray{{0.2, 0.2, 3}, {0, 0, -1}};
  EXPECT_EQ(first_triangle(bvh, ray), 0u);
  EXPECT_EQ(count_hits(bvh, ray), 3000u);
  EXPECT_EQ(hits(bvh, ray)[2999].index, 2999u);
}

/// Rays from about a mesh to its vertices and beyond, some the other way.
std::vector<AnyRay> rays_about(const TriangleMesh& mesh, std::size_t n) {
  std::vector<AnyRay> rays;
  for (std::uint64_t i = 0; i < n; ++i) {
    Entropy e(986, i);
    const Point3& a = mesh.vertices[e.below(mesh.vertices.size())];
    const Point3& b = mesh.vertices[e.below(mesh.vertices.size())];
    const double t = 1 + static_cast<double>(e.within(64)) / 32;
    const Point3 eye{a.x + t * (a.x - b.x), a.y + t * (a.y - b.y), a.z + t * (b.z - a.z)};
    if (i % 3 == 0) {
      rays.emplace_back(Segment3{eye, b});
    } else {
      const double way = i % 8 == 1 ? -1 : 1;
      rays.emplace_back(Ray3{eye, {way * (b.x - eye.x), way * (b.y - eye.y), way * (b.z - eye.z)}});
    }
  }
  return rays;
}

/// Of many rays, what each finds alone and what they find in the tree that the compact one is made of.
void expect_as_in(const Bvh& bvh, const std::vector<AnyRay>& rays) {
  const CompactBvh small = compact(bvh);
  std::vector<std::optional<NumberedHit>> first(rays.size()), as_first(rays.size());
  std::vector<std::uint32_t> triangle(rays.size()), as_triangle(rays.size());
  std::vector<std::uint8_t> any(rays.size()), as_any(rays.size());
  std::vector<std::size_t> count(rays.size()), as_count(rays.size());
  std::vector<std::vector<NumberedHit>> ordered(rays.size()), as_ordered(rays.size());
  first_hit(small, rays, first);
  first_hit(bvh, rays, as_first);
  EXPECT_EQ(first, as_first);
  first_triangle(small, rays, triangle);
  first_triangle(bvh, rays, as_triangle);
  EXPECT_EQ(triangle, as_triangle);
  any_hit(small, rays, any);
  any_hit(bvh, rays, as_any);
  EXPECT_EQ(any, as_any);
  count_hits(small, rays, count);
  count_hits(bvh, rays, as_count);
  EXPECT_EQ(count, as_count);
  hits(small, rays, ordered);
  hits(bvh, rays, as_ordered);
  EXPECT_EQ(ordered, as_ordered);
  EXPECT_GT(std::count(any.begin(), any.end(), 1), 0);
  EXPECT_GT(std::count(any.begin(), any.end(), 0), 0);
  for (std::size_t i = 0; i < rays.size(); i += 16) EXPECT_EQ(first_hit(small, rays[i]), first[i]) << "ray " << i;
}

TEST(CompactRay, OfManyIsThatOfEachByAnyInstructionSetAndNumberOfThreads) {
  const TriangleMesh mesh = meshes::ring(24);
  const Bvh bvh = build_bvh(mesh);
  const std::vector<AnyRay> rays = rays_about(mesh, battery::fitting(1200u));
  for (const std::string_view set : batch_instruction_sets()) {
    SCOPED_TRACE(set);
    certify::batch::take_instruction_set(set);
    expect_as_in(bvh, rays);
  }
  certify::batch::take_instruction_set({});
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    expect_as_in(bvh, rays);
  }
  std::vector<std::uint32_t> out(rays.size());
  const auto stopped = [](double) { return false; };
  EXPECT_THROW(first_triangle(compact(bvh), rays, out, {.progress = stopped}), Cancelled);
  out.resize(1);
  EXPECT_EQ(text_of<UnequalLengths>([&] { first_triangle(compact(bvh), rays, out); }),
            "first_triangle: out has 1 items, rays has " + std::to_string(rays.size()));
}

TEST(CompactRay, FindsInModelsWhatTheTreeFinds) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  for (const char* name : {"beetle.obj", "cow.obj", "horse.ply", "rocker-arm.obj", "teapot.obj"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_mesh((folder / name).string());
    expect_as_in(build_bvh(mesh), rays_about(mesh, battery::fitting(1000u)));
  }
}

}  // namespace
}  // namespace plumb

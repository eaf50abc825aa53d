// Do rays with a least and a greatest parameter, and triangles to skip, find what of all hits is left by exact
// comparison?  Limits are drawn at hits, an ulp beside them and anywhere; meshes stand, are compact, are under poses.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_within(const RayParameter& t, const HitLimits& limits) {
  const auto exact = [](double x) { return RayParameter{Rational(x)}; };
  if (limits.least == infinity || limits.most == -infinity) return false;
  if (std::isfinite(limits.least) && t < exact(limits.least)) return false;
  return !(std::isfinite(limits.most) && t > exact(limits.most));
}

std::vector<std::uint32_t> left_of(const std::vector<TrueHit>& all, const HitLimits& limits) {
  std::vector<std::uint32_t> left;
  for (const TrueHit& hit : all) {
    const bool skipped = std::find(limits.skip.begin(), limits.skip.end(), hit.index) != limits.skip.end();
    if (!skipped && is_within(hit.t, limits)) left.push_back(hit.index);
  }
  return left;
}

/// A limit beside the hits, or anywhere.
double drawn_limit(Material& m, const std::vector<TrueHit>& all, double none) {
  const std::uint64_t kind = m.below(8);
  if (kind == 0) return none;
  if (kind == 1) return -none;
  if (kind == 2 || all.empty()) return static_cast<double>(m.below(9)) * 0.25 - 1;
  const double t = all[m.below(all.size())].t.rounded();
  const std::uint64_t beside = m.below(4);
  return beside == 0 ? std::nextafter(t, -infinity) : beside == 1 ? std::nextafter(t, infinity) : t;
}

template <class Mesh>
void check(const Mesh& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule,
           const std::vector<std::uint32_t>& left, const std::string& about) {
  const auto all = hits(mesh, ray, limits, rule);
  ASSERT_EQ(all.size(), left.size()) << about;
  for (std::size_t i = 0; i < left.size(); ++i) ASSERT_EQ(all[i].index, left[i]) << about;
  const auto first = first_hit(mesh, ray, limits, rule);
  ASSERT_EQ(first.has_value(), !left.empty()) << about;
  if (first) {
    ASSERT_EQ(*first, all[0]) << about;
  }
  ASSERT_EQ(first_triangle(mesh, ray, limits, rule).value_or(no_triangle), left.empty() ? no_triangle : left[0])
      << about;
  ASSERT_EQ(any_hit(mesh, ray, limits, rule), !left.empty()) << about;
  ASSERT_EQ(count_hits(mesh, ray, limits, rule), left.size()) << about;
}

TEST(HitLimits, LeaveWhatExactParametersSay) {
  long some_left = 0, some_gone = 0;
  on_shapes(1741, battery::fitting(700), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 25);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const CompactBvh small = compact(bvh);
    const Pose pose = any_pose(m);
    const AnyRay ray = ray_of(m);
    for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
      const std::vector<TrueHit> all = true_hits(ray, mesh, rule);
      std::vector<TrueHit> moved;
      for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (auto t = query::first_hit_parameter(ray, posed_triangle(mesh, i, pose), rule))
          moved.push_back({i, std::move(*t)});
      }
      std::stable_sort(moved.begin(), moved.end(), [](const TrueHit& a, const TrueHit& b) { return a.t < b.t; });
      for (int k = 0; k < 3; ++k) {
        std::vector<std::uint32_t> skipped;
        for (std::size_t n = m.below(3); n-- > 0;)
          skipped.push_back(all.empty() ? static_cast<std::uint32_t>(m.below(99)) : all[m.below(all.size())].index);
        const HitLimits limits{drawn_limit(m, all, -infinity), drawn_limit(m, all, infinity), skipped};
        const std::string about = m.about() + " " + text_of(ray) + " from " + std::to_string(limits.least) + " to " +
                                  std::to_string(limits.most);
        const std::vector<std::uint32_t> left = left_of(all, limits);
        check(bvh, ray, limits, rule, left, about);
        check(small, ray, limits, rule, left, about);
        const HitLimits there{drawn_limit(m, moved, -infinity), drawn_limit(m, moved, infinity), skipped};
        check(PosedMesh{bvh, pose}, ray, there, rule, left_of(moved, there), about);
        some_left += !left.empty();
        some_gone += left.size() < all.size();
      }
    }
  });
  EXPECT_GT(some_left, battery::fitting(300));
  EXPECT_GT(some_gone, battery::fitting(300));
}

// Rays of a camera go down in packets, others by turns: each has limits of its own.
TEST(HitLimits, OfManyRaysAreEachItsOwn) {
  const TriangleMesh mesh = meshes::ring(8);
  const Bvh bvh = build_bvh(mesh);
  for (const bool is_camera : {true, false}) {
    std::vector<AnyRay> rays;
    std::vector<HitLimits> limits;
    std::vector<std::uint32_t> skipped;
    for (std::uint64_t i = 0; i < 900; ++i) {
      Entropy e(1742, i);
      const Point3 at = mesh.vertices[e.below(mesh.vertices.size())];
      const Point3 eye = is_camera ? Point3{0.25, -7, 3} : mesh.vertices[e.below(mesh.vertices.size())];
      if (e.below(3) == 0) {
        rays.emplace_back(Segment3{eye, at});
      } else {
        rays.emplace_back(Ray3{eye, ray_cases::toward(eye, at)});
      }
      skipped.push_back(first_triangle(bvh, rays.back()).value_or(0));
    }
    long changed = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto first = first_hit(bvh, rays[i]);
      const double t = first ? first->hit.t : 1;
      const std::span skip = std::span(skipped).subspan(i, 1);
      limits.push_back(i % 3 == 0   ? HitLimits{t, infinity, {}}
                       : i % 3 == 1 ? HitLimits{std::nextafter(t, infinity), infinity, skip}
                                    : HitLimits{-infinity, std::nextafter(t, -infinity), skip});
    }
    std::vector<std::uint32_t> first(rays.size());
    std::vector<std::optional<NumberedHit>> firsts(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::size_t> counts(rays.size());
    first_triangle(bvh, rays, first, {.limits = limits});
    first_hit(bvh, rays, firsts, {.limits = limits});
    any_hit(bvh, rays, any, {.limits = limits});
    count_hits(bvh, rays, counts, {.limits = limits});
    std::vector<std::vector<NumberedHit>> lists(rays.size());
    hits(bvh, rays, lists, {.limits = limits});
    Pose aside = identity_pose;
    aside.translation = {0.25, 0, -0.5};
    const PosedMesh moved{bvh, aside};
    std::vector<std::vector<NumberedHit>> lists_of_moved(rays.size());
    hits(moved, rays, lists_of_moved, {.limits = limits});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto alone = first_hit(bvh, rays[i], limits[i]);
      ASSERT_EQ(firsts[i], alone) << "ray " << i;
      ASSERT_EQ(first[i], alone ? alone->index : no_triangle) << "ray " << i;
      ASSERT_EQ(any[i] != 0, alone.has_value()) << "ray " << i;
      ASSERT_EQ(lists[i], hits(bvh, rays[i], limits[i])) << "ray " << i;
      ASSERT_EQ(counts[i], lists[i].size()) << "ray " << i;
      ASSERT_EQ(lists_of_moved[i], hits(moved, rays[i], limits[i])) << "ray " << i;
      changed += alone != first_hit(bvh, rays[i]);
    }
    EXPECT_GT(changed, 300);
  }
}

TEST(HitLimits, RefuseWhatIsNoNumber) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Ray3 ray{{0, 0, 5}, {0, 0, -1}};
  EXPECT_EQ(text_of<NonFinite>([&] { (void)any_hit(bvh, ray, {.least = nan}); }), "any_hit: limits.least is NaN");
  EXPECT_EQ(text_of<NonFinite>([&] { (void)hits(bvh, ray, {.most = nan}); }), "hits: limits.most is NaN");
  const std::vector<AnyRay> rays{ray, ray};
  const std::vector<HitLimits> one(1);
  std::vector<std::uint32_t> out(2);
  EXPECT_EQ(text_of<UnequalLengths>([&] { first_triangle(bvh, rays, out, {.limits = one}); }),
            "first_triangle: limits has 1 items, rays has 2");
  const std::vector<HitLimits> second{{}, {.most = nan}};
  EXPECT_EQ(text_of<NonFinite>([&] { first_triangle(bvh, rays, out, {.limits = second}); }),
            "first_triangle: limits[1].most is NaN");
}

}  // namespace
}  // namespace plumb

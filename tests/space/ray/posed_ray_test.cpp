// Do rays at moved meshes find what they find at the exactly moved triangles?
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/space/ray/inside.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;

constexpr std::array rules{HitRule::closed, HitRule::half_open};

RationalPoint less(const RationalPoint& a, const RationalPoint& b) {
  return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
}
RationalPoint across(const RationalPoint& a, const RationalPoint& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}
mpq_class dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// For a ray that is not parallel to the triangle: the parameter in its plane, and whether the point is in it.
struct ByPlane {
  bool parallel, hit;
  mpq_class t;
};
ByPlane by_plane(const AnyRay& ray, const Posed<Triangle3>& triangle) {
  const auto of = [](double x, double y, double z) { return RationalPoint{mpq_class(x), mpq_class(y), mpq_class(z)}; };
  const RationalPoint origin = of(ray.origin.x, ray.origin.y, ray.origin.z);
  const RationalPoint way = ray.kind == AnyRay::Kind::segment ? less(of(ray.end.x, ray.end.y, ray.end.z), origin)
                                                              : of(ray.direction.x, ray.direction.y, ray.direction.z);
  const auto& [s, pose] = triangle;
  const std::array corner{image(s.a, pose), image(s.b, pose), image(s.c, pose)};
  const RationalPoint normal = across(less(corner[1], corner[0]), less(corner[2], corner[0]));
  const mpq_class slope = dot(way, normal);
  if (slope == 0) return {true, false, 0};
  const mpq_class t = dot(less(corner[0], origin), normal) / slope;
  bool hit = (ray.kind == AnyRay::Kind::line || t >= 0) && (ray.kind != AnyRay::Kind::segment || t <= 1);
  RationalPoint at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = origin[k] + t * way[k];
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint out = across(less(corner[(i + 1) % 3], corner[i]), less(at, corner[i]));
    hit = hit && dot(out, normal) >= 0;
  }
  return {false, hit, t};
}

void expect_hits(const AnyRay& ray, const TriangleMesh& mesh, const Bvh& bvh, const Pose& pose, HitRule rule,
                 const std::string& about) {
  std::vector<TrueHit> expected;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    auto t = query::first_hit_parameter(ray, posed_triangle(mesh, i, pose), rule);
    if (t) expected.push_back({i, std::move(*t)});
  }
  std::stable_sort(expected.begin(), expected.end(), [](const TrueHit& a, const TrueHit& b) { return a.t < b.t; });
  const PosedMesh asked{bvh, pose};
  const auto first = first_hit(asked, ray, rule);
  ASSERT_EQ(first.has_value(), !expected.empty()) << about;
  ASSERT_EQ(any_hit(asked, ray, rule), !expected.empty()) << about;
  ASSERT_EQ(count_hits(asked, ray, rule), expected.size()) << about;
  const std::vector<NumberedHit> all = hits(asked, ray, rule);
  ASSERT_EQ(all.size(), expected.size()) << about;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].index, expected[i].index) << about << " hit " << i;
    ASSERT_EQ(all[i].hit.t, expected[i].t.rounded()) << about << " hit " << i;
  }
  ASSERT_EQ(first_triangle(asked, ray, rule).has_value(), !expected.empty()) << about;
  if (expected.empty()) return;
  ASSERT_EQ(first->index, expected[0].index) << about;
  ASSERT_EQ(*first, all[0]) << about;
  ASSERT_EQ(*first_triangle(asked, ray, rule), expected[0].index) << about;
}

TEST(PosedRay, FindsWhatRationalsSay) {
  long hit = 0, missed = 0;
  on_shapes(1711, battery::fitting(3000), [&](Material& m) {
    const auto triangle = m.shape<Triangle3>();
    const AnyRay ray = ray_of(m);
    const Posed<Triangle3> posed{triangle, any_pose(m)};
    const ByPlane expected = by_plane(ray, posed);
    if (expected.parallel) return;
    const auto found = query::first_hit_parameter(ray, posed, HitRule::closed);
    ASSERT_EQ(found.has_value(), expected.hit) << m.about(triangle, posed.pose) << text_of(ray);
    ++(found ? hit : missed);
    if (found) {
      EXPECT_EQ(found->base.value().value, expected.t) << m.about(triangle, posed.pose) << text_of(ray);
    }
  });
  EXPECT_GT(hit, battery::fitting(200));
  EXPECT_GT(missed, battery::fitting(200));
}

TEST(PosedRay, FindsWhatEveryTriangleSays) {
  on_shapes(1712, battery::fitting(200), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 25);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const Pose pose = any_pose(m);
    const AnyRay ray = ray_of(m);
    for (const HitRule rule : rules) expect_hits(ray, mesh, bvh, pose, rule, m.about() + " " + text_of(ray));
  });
}

TEST(PosedRay, FindsWhatTheExactlyPosedMeshHas) {
  long hit = 0, compared = 0;
  on_shapes(1713, battery::fitting(700), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 25);
    const Pose pose = integer_pose(m);
    const auto posed = exact_mesh(mesh, pose);
    if (!posed) return;
    const Bvh bvh = build_bvh(mesh, any_options(m)), there = build_bvh(*posed);
    const PosedMesh asked{bvh, pose};
    AnyRay ray = ray_of(m);
    if (m.below(2) == 0 && ray.kind != AnyRay::Kind::line) {  // at what is there now
      const Point3 at = posed->vertices.empty() ? Point3{0, 0, 0} : posed->vertices[m.below(posed->vertices.size())];
      ray = Ray3{ray.origin, ray_cases::toward(ray.origin, at)};
    }
    const std::string about = m.about() + " " + text_of(ray);
    for (const HitRule rule : rules) {
      ASSERT_EQ(hits(asked, ray, rule), hits(there, ray, rule)) << about;
      ASSERT_EQ(first_hit(asked, ray, rule), first_hit(there, ray, rule)) << about;
      ASSERT_EQ(count_hits(asked, ray, rule), count_hits(there, ray, rule)) << about;
    }
    for (const Point3& p : {ray.origin, m.probe3(), m.probe3()}) {
      ASSERT_EQ(locate(asked, p), locate(there, p)) << about;
      ASSERT_EQ(winding_number(asked, p), winding_number(there, p)) << about;
      ASSERT_EQ(contains(asked, p), contains(there, p)) << about;
    }
    hit += any_hit(there, ray), ++compared;
  });
  EXPECT_GT(compared, battery::fitting(300));
  EXPECT_GT(hit, battery::fitting(100));
}

TEST(PosedRay, NothingSlipsThroughATurnedMesh) {
  const TriangleMesh mesh = meshes::ring(6);
  const Bvh bvh = build_bvh(mesh);
  on_shapes(1714, battery::fitting(20), [&](Material& m) {
    Pose pose = turn(m);
    pose.translation = {0.1, 0.2, 0.3};
    const PosedMesh asked{bvh, pose};
    std::vector<AnyRay> rays;
    std::vector<Point3> points;
    const Point3 eye{0.25, -7, 3};
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Point3 at = approximate(Posed<Point3>{mesh.vertices[i], pose});
      rays.emplace_back(Ray3{eye, ray_cases::toward(eye, at)});
      points.push_back(at);
    }
    std::vector<std::uint32_t> first(rays.size());
    std::vector<std::size_t> crossed(rays.size());
    std::vector<std::uint8_t> hit(rays.size());
    std::vector<std::vector<NumberedHit>> ordered(rays.size());
    std::vector<std::optional<NumberedHit>> firsts(rays.size());
    first_triangle(asked, rays, first);
    first_hit(asked, rays, firsts);
    any_hit(asked, rays, hit);
    count_hits(asked, rays, crossed, {.rule = HitRule::half_open});
    hits(asked, rays, ordered);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(crossed[i] % 2, 0u) << m.about() << " ray " << i;
      EXPECT_EQ(first[i], first_triangle(asked, rays[i]).value_or(no_triangle)) << m.about() << " ray " << i;
      EXPECT_EQ(firsts[i], first_hit(asked, rays[i])) << m.about() << " ray " << i;
      EXPECT_EQ(hit[i] != 0, first[i] != no_triangle) << m.about() << " ray " << i;
      EXPECT_EQ(ordered[i].empty(), hit[i] == 0) << m.about() << " ray " << i;
    }
    std::vector<Location> located(points.size());
    std::vector<std::optional<std::int64_t>> wound(points.size());
    locate(asked, points, located);
    winding_number(asked, points, wound);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto expected =
          located[i] == Location::boundary ? std::nullopt : std::optional(located[i] == Location::inside ? 1 : 0);
      EXPECT_EQ(wound[i].has_value(), expected.has_value()) << m.about() << " point " << i;
      if (wound[i]) {
        EXPECT_EQ(std::abs(*wound[i]), *expected) << m.about() << " point " << i;
      }
    }
  });
}

TEST(PosedRay, BeyondTheLargestDouble) {
  const Bvh bvh = build_bvh(TriangleMesh{{{1, -1, -1}, {1, 2, -1}, {1, -1, 2}}, {{0, 1, 2}}});
  const Pose far{{{{0x1p1023, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0x1p1023, 0, 0}};  // x = 2^1024
  const auto hit = first_hit({bvh, far}, Ray3{{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->hit.t, std::numeric_limits<double>::infinity());
  EXPECT_EQ(first_hit({bvh, far}, Ray3{{0, 0, 0}, {2, 0, 0}})->hit.t, 0x1p1023);
  EXPECT_FALSE(any_hit({bvh, far}, Segment3{{0, 0, 0}, {0x1.fffffffffffffp1023, 0, 0}}));
}

TEST(PosedRay, RefusesWhatIsNone) {
  const Bvh bvh = build_bvh(meshes::repeated(2));
  Pose pose = identity_pose;
  pose.columns[0].x = std::nan("");
  const Ray3 ray{{0, 0, 1}, {0, 0, -1}};
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit({bvh, pose}, ray);
            }),
            "first_hit: mesh.pose.columns[0].x is nan, not a real number; give a finite double");
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)locate({bvh, pose}, Point3{0, 0, 0});
            }),
            "locate: mesh.pose.columns[0].x is nan, not a real number; give a finite double");
  EXPECT_THROW((void)any_hit(PosedMesh(bvh), Ray3{{INFINITY, 0, 0}, {0, 0, 1}}), NonFinite);
  EXPECT_THROW((void)locate(PosedMesh(bvh), Point3{NAN, 0, 0}), NonFinite);
  std::vector<std::size_t> out(2);
  EXPECT_THROW(count_hits(PosedMesh(bvh), std::vector<AnyRay>{ray}, out), UnequalLengths);
}

}  // namespace
}  // namespace plumb

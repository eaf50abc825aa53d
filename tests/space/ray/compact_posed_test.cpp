// Are moved compact meshes answered for as their exactly moved triangles are, and as the trees that they are made of:
// rays, points within, ranges, what is closest?  And points within those that stand.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;

void expect_hits(const AnyRay& ray, const TriangleMesh& mesh, const PosedCompactMesh& small, HitRule rule,
                 const std::string& about) {
  std::vector<TrueHit> expected;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    auto t = query::first_hit_parameter(ray, posed_triangle(mesh, i, *small.pose.matrix()), rule);
    if (t) expected.push_back({i, std::move(*t)});
  }
  std::stable_sort(expected.begin(), expected.end(), [](const TrueHit& a, const TrueHit& b) { return a.t < b.t; });
  ASSERT_EQ(any_hit(small, ray, rule), !expected.empty()) << about;
  ASSERT_EQ(count_hits(small, ray, rule), expected.size()) << about;
  const std::vector<NumberedHit> all = hits(small, ray, rule);
  ASSERT_EQ(all.size(), expected.size()) << about;
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i].index, expected[i].index) << about << " hit " << i;
  const auto first = first_hit(small, ray, rule);
  ASSERT_EQ(first, all.empty() ? std::nullopt : std::optional(all[0])) << about;
  const auto number = first_triangle(small, ray, rule);
  ASSERT_EQ(number, all.empty() ? std::nullopt : std::optional(all[0].index)) << about;
}

TEST(PosedCompactRay, FindsWhatEveryPosedTriangleSays) {
  long hit = 0, missed = 0;
  on_shapes(963, battery::fitting(250), [&](Material& m) {
    const TriangleMesh mesh = m.below(3) == 0 ? meshes::soup(m, 2 + m.below(12), 30) : drawn_mesh(m, 40);
    const CompactBvh small = build_compact_bvh(mesh, any_options(m));
    const PosedCompactMesh posed{small, any_pose(m)};
    for (int k = 0; k < 2; ++k) {
      const AnyRay ray = ray_of(m);
      for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
        expect_hits(ray, mesh, posed, rule, m.about() + " " + text_of(ray));
      }
      ++(any_hit(posed, ray) ? hit : missed);
    }
  });
  EXPECT_GT(hit, battery::fitting(80));
  EXPECT_GT(missed, battery::fitting(80));
}

TEST(PosedCompactRay, OfManyIsThatOfTheTree) {
  const TriangleMesh mesh = meshes::ring(16);
  const Bvh bvh = build_bvh(mesh);
  const CompactBvh small = compact(bvh);
  std::vector<AnyRay> rays;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Entropy e(964, i);
    const Point3& a = mesh.vertices[e.below(mesh.vertices.size())];
    rays.emplace_back(Ray3{{3, 3 - 6 * static_cast<double>(i % 2), 2}, {a.x - 3, a.y - 2, a.z - 1}});
  }
  const Pose turn{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {0.25, 0.5, 0}};
  const Pose flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}};
  for (const Pose& pose : {turn, flat}) {
    const PosedMesh whole{bvh, pose};
    const PosedCompactMesh posed{small, pose};
    std::vector<std::optional<NumberedHit>> first(rays.size()), expected(rays.size());
    first_hit(whole, rays, expected);
    EXPECT_GT(std::ranges::count_if(expected, [](const auto& h) { return h.has_value(); }), 20);
    for (const std::size_t threads : {1u, 2u}) {
      const ThreadLimit control(threads);
      first_hit(posed, rays, first);
      EXPECT_EQ(first, expected);
    }
    std::vector<std::uint32_t> number(rays.size()), as_number(rays.size());
    first_triangle(posed, rays, number), first_triangle(whole, rays, as_number);
    EXPECT_EQ(number, as_number);
    std::vector<std::uint8_t> any(rays.size()), as_any(rays.size());
    any_hit(posed, rays, any), any_hit(whole, rays, as_any);
    EXPECT_EQ(any, as_any);
    std::vector<std::size_t> count(rays.size()), as_count(rays.size());
    count_hits(posed, rays, count), count_hits(whole, rays, as_count);
    EXPECT_EQ(count, as_count);
    std::vector<std::vector<NumberedHit>> all(rays.size()), as_all(rays.size());
    hits(posed, rays, all), hits(whole, rays, as_all);
    EXPECT_EQ(all, as_all);
  }
}

TEST(CompactInside, IsWhatEveryTriangleSays) {
  std::array<long, 3> told{};
  const auto check = [&](const TriangleMesh& mesh, const CompactBvh& small, const Point3& p, const std::string& about) {
    const Location expected = locate(mesh, p);
    ++told[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
    ASSERT_EQ(locate(small, p), expected) << about;
    ASSERT_EQ(contains(small, p), expected != Location::outside) << about;
    ASSERT_EQ(winding_number(small, p), winding_number(mesh, p)) << about;
  };
  on_shapes(965, battery::fitting(300), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 30);
    const CompactBvh small = build_compact_bvh(mesh, any_options(m));
    for (int k = 0; k < 4; ++k) check(mesh, small, m.probe3(), m.about());
  });
  const TriangleMesh mesh = solids::turned(solids::hollow_torus(3, 1, 16, 8));
  const CompactBvh small = build_compact_bvh(mesh);
  std::vector<Point3> points;
  for (const Point3& p : mesh.vertices) {
    for (const double by : {1.0, 0.9, 1.1}) {
      points.push_back({p.x * by, p.y * by, p.z * by});
      check(mesh, small, points.back(), "torus");
    }
  }
  for (const long n : told) EXPECT_GT(n, battery::fitting(50));
  for (const Execution execution : {Execution::serial, Execution::parallel}) {
    std::vector<Location> where(points.size());
    std::vector<std::optional<std::int64_t>> winding(points.size());
    locate(small, points, where, execution);
    winding_number(small, points, winding, execution);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(where[i], locate(mesh, points[i]));
      EXPECT_EQ(winding[i], winding_number(mesh, points[i]));
    }
  }
}

TEST(PosedCompactInside, IsThatOfTheTree) {
  std::array<long, 3> told{};
  on_shapes(966, battery::fitting(150), [&](Material& m) {
    const TriangleMesh mesh = m.below(2) == 0 ? drawn_mesh(m, 20) : meshes::ring(4);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const CompactBvh small = compact(bvh);
    const Pose pose = any_pose(m);
    const Point3 p = m.probe3();
    const Location expected = locate({bvh, pose}, p);
    ++told[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
    ASSERT_EQ(locate({small, pose}, p), expected) << m.about(p);
    ASSERT_EQ(contains({small, pose}, p), expected != Location::outside) << m.about(p);
    ASSERT_EQ(winding_number({small, pose}, p), winding_number({bvh, pose}, p)) << m.about(p);
    std::array<Location, 1> where{};
    locate({small, pose}, {&p, 1}, where);
    ASSERT_EQ(where[0], expected);
  });
  for (const long n : told) EXPECT_GT(n, battery::fitting(3));
}

template <class Shape>
void expect_range(Material& m, const TriangleMesh& mesh, const PosedCompactMesh& small) {
  const auto shape = m.shape<Shape>();
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (query::intersects(posed_triangle(mesh, i, *small.pose.matrix()), shape)) expected.push_back(i);
  }
  EXPECT_EQ(meeting(small, shape), expected) << m.about();
  EXPECT_EQ(meeting(small, std::span<const Shape>(&shape, 1)).at(0), expected) << m.about();
}

TEST(PosedCompactRange, IsThatOfEachTriangle) {
  on_shapes(967, battery::fitting(40), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(15), m.below(15));
    const CompactBvh small = build_compact_bvh(mesh, any_options(m));
    const PosedCompactMesh posed{small, any_pose(m)};
    expect_range<Aabb3>(m, mesh, posed);
    expect_range<Obb3>(m, mesh, posed);
    expect_range<Sphere3>(m, mesh, posed);
    expect_range<Capsule3>(m, mesh, posed);
    expect_range<Segment3>(m, mesh, posed);
    expect_range<Halfspace3>(m, mesh, posed);
    expect_range<HalfspaceIntersection3>(m, mesh, posed);
  });
}

TEST(PosedCompactClosest, IsThatOfTheTree) {
  long compared = 0;
  on_shapes(968, battery::fitting(120), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(20), m.below(30));
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const CompactBvh small = compact(bvh);
    const Pose pose = any_pose(m);
    const PosedMesh whole{bvh, pose};
    const PosedCompactMesh posed{small, pose};
    const Point3 p = m.probe3();
    const auto near = closest_on_mesh(posed, p);
    ASSERT_EQ(near, closest_on_mesh(whole, p)) << m.about(p);
    ASSERT_EQ(nearest_triangles(posed, p, 5), nearest_triangles(whole, p, 5)) << m.about(p);
    if (!near) return;
    if (const double reach = 1.25 * near->distance; std::isfinite(reach)) {
      ASSERT_EQ(triangles_within(posed, p, reach), triangles_within(whole, p, reach)) << m.about(p);
    }
    std::vector<ClosestOnMesh> out(1);
    closest_on_mesh(posed, std::vector<Point3>{p}, out);
    ASSERT_EQ(out[0], *near);
    ++compared;
  });
  EXPECT_GT(compared, battery::fitting(60));
}

TEST(PosedCompact, OfNothingIsNothingAndBadPosesAreNamed) {
  const CompactBvh none = build_compact_bvh(TriangleMesh{});
  const PosedCompactMesh posed{none};
  EXPECT_FALSE(first_hit(posed, Ray3{{0, 0, 0}, {1, 0, 0}}).has_value());
  EXPECT_EQ(locate(posed, {0, 0, 0}), Location::outside);
  EXPECT_EQ(winding_number(none, {0, 0, 0}), 0);
  EXPECT_FALSE(closest_on_mesh(posed, {0, 0, 0}).has_value());
  EXPECT_TRUE(meeting(posed, Sphere3{{0, 0, 0}, 1}).empty());
  EXPECT_TRUE(intersecting_pairs(posed, posed).empty());
  const CompactBvh small = build_compact_bvh(meshes::repeated(2));
  Pose bad = identity_pose;
  bad.columns[2].y = std::nan("");
  const PosedCompactMesh wrong{small, bad};
  const auto says = [&](const auto& ask, const std::string& function) {
    EXPECT_EQ(text_of<NonFinite>(ask),
              function + ": mesh.pose.columns[2].y is nan, not a real number; give a finite double");
  };
  says([&] { (void)first_hit(wrong, Ray3{{0, 0, 0}, {1, 0, 0}}); }, "first_hit");
  says([&] { (void)locate(wrong, {0, 0, 0}); }, "locate");
  says([&] { (void)closest_on_mesh(wrong, {0, 0, 0}); }, "closest_on_mesh");
  says([&] { (void)meeting(wrong, Sphere3{{0, 0, 0}, 1}); }, "meeting");
}

}  // namespace
}  // namespace plumb

// Are the barycentric coordinates of a hit those of its exact point?  Held against what defines them, in rationals; of
// meshes that stand, are compact and are under poses, one ray or many.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/gmp.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;

RationalPoint rational(double x, double y, double z) { return {mpq_class(x), mpq_class(y), mpq_class(z)}; }
RationalPoint rational(const Point3& p) { return rational(p.x, p.y, p.z); }
/// a + t (b - a).
RationalPoint moved(const RationalPoint& a, const RationalPoint& b, const mpq_class& t) {
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + t * (b[k] - a[k]);
  return p;
}
RationalPoint point_at(const AnyRay& ray, const mpq_class& t) {
  const RationalPoint o = rational(ray.origin);
  if (ray.kind == AnyRay::Kind::segment) return moved(o, rational(ray.end), t);
  const RationalPoint d = rational(ray.direction.x, ray.direction.y, ray.direction.z);
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = o[k] + t * d[k];
  return p;
}
bool are_on_line(const std::array<RationalPoint, 3>& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    if ((c[1][k] - c[0][k]) * (c[2][l] - c[0][l]) != (c[1][l] - c[0][l]) * (c[2][k] - c[0][k])) return false;
  }
  return true;
}

struct Seen {
  long inside = 0, edges = 0, corners = 0, on_lines = 0, missed = 0;
};

/// Of a triangle that is hit at t: do u and v say its point, and of points on a line the first edge's?
void expect_defined(const AnyRay& ray, const std::array<RationalPoint, 3>& corner, const mpq_class& t,
                    const ExactHitBarycentric& exact, Seen& seen, const std::string& about) {
  const mpq_class u = exact.u.value().value, v = exact.v.value().value;
  const std::array<mpq_class, 3> weight{mpq_class(1 - u - v), u, v};
  const RationalPoint point = point_at(ray, t);
  int zeros = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_GE(weight[k], 0) << about;
    zeros += weight[k] == 0;
    ASSERT_EQ(corner[0][k] + u * (corner[1][k] - corner[0][k]) + v * (corner[2][k] - corner[0][k]), point[k]) << about;
  }
  ++(zeros == 2 ? seen.corners : zeros == 1 ? seen.edges : seen.inside);
  if (!are_on_line(corner)) return;
  ++seen.on_lines;
  for (std::size_t i = 0; i < 3; ++i) {
    if (corner[i] != point) continue;
    ASSERT_EQ(weight[i], 1) << about;
    return;
  }
  const auto is_between = [&](const RationalPoint& p, const RationalPoint& q) {
    bool between = p != q;
    for (std::size_t k = 0; k < 3; ++k)
      between = between && (p[k] - point[k]) * (q[k] - point[k]) <= 0 && (p[k] != q[k] || p[k] == point[k]);
    return between;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_between(corner[i], corner[(i + 1) % 3])) continue;
    ASSERT_EQ(weight[(i + 2) % 3], 0) << about;
    return;
  }
  FAIL() << about << ": is on no edge";
}

std::array<RationalPoint, 3> corners_of(const Triangle3& t) { return {rational(t.a), rational(t.b), rational(t.c)}; }

HitBarycentric rounded(const ExactHitBarycentric& exact) { return {exact.u.rounded() + 0.0, exact.v.rounded() + 0.0}; }

TEST(HitBarycentric, SaysTheExactPointOfTriangles) {
  Seen seen;
  on_shapes(1751, battery::fitting(6000), [&](Material& m) {
    auto triangle = m.shape<Triangle3>();
    if (m.below(12) == 0) triangle.c = m.below(2) == 0 ? triangle.a : triangle.b;
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(triangle) + text_of(ray);
    const auto t = first_hit_parameter(ray, triangle);
    const auto exact = exact_hit_barycentric(ray, triangle);
    const auto found = hit_barycentric(ray, triangle);
    ASSERT_EQ(exact.has_value(), t.has_value()) << about;
    ASSERT_EQ(found.has_value(), t.has_value()) << about;
    if (!t) {
      ++seen.missed;
      return;
    }
    expect_defined(ray, corners_of(triangle), t->base.value().value, *exact, seen, about);
    ASSERT_EQ(*found, rounded(*exact)) << about;
  });
  for (const long n : {seen.inside, seen.edges, seen.corners, seen.on_lines, seen.missed})
    EXPECT_GT(n, battery::fitting(100));
}

/// Triangles in general position, which doubles answer.
TEST(HitBarycentric, SaysTheExactPointInGeneralPosition) {
  Seen seen;
  on_shapes(1752, battery::fitting(3000), [&](Material& m) {
    const auto number = [&] { return static_cast<double>(m.entropy().within(1 << 20)) / 3; };
    const auto point = [&] { return Point3{number(), number(), number()}; };
    const Triangle3 triangle{point(), point(), point()};
    const Point3 eye = point(), at{(triangle.a.x + triangle.b.x + 2 * triangle.c.x) / 4,
                                   (triangle.a.y + triangle.b.y + 2 * triangle.c.y) / 4,
                                   (triangle.a.z + triangle.b.z + 2 * triangle.c.z) / 4};
    const AnyRay ray = Ray3{eye, {at.x - eye.x, at.y - eye.y, at.z - eye.z}};
    const auto t = first_hit_parameter(ray, triangle);
    if (!t) return;
    const auto exact = exact_hit_barycentric(ray, triangle);
    ASSERT_TRUE(exact) << m.about(triangle);
    expect_defined(ray, corners_of(triangle), t->base.value().value, *exact, seen, m.about(triangle));
    ASSERT_EQ(*hit_barycentric(ray, triangle), rounded(*exact)) << m.about(triangle);
  });
  EXPECT_GT(seen.inside, battery::fitting(2000));
}

/// Asks every triangle of a mesh, kept and standing in any way.
TEST(HitBarycentric, OfMeshesIsThatOfTheirTriangles) {
  Seen seen;
  on_shapes(1753, battery::fitting(400), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 25);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const CompactBvh small = compact(bvh);
    const Pose pose = any_pose(m);
    const AnyRay ray = ray_of(m);
    const std::string about = m.about() + " " + text_of(ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size() + 2; ++i) {
      if (i >= mesh.triangles.size()) {
        ASSERT_FALSE(hit_barycentric(bvh, ray, i) || hit_barycentric({small, pose}, ray, i)) << about;
        continue;
      }
      const auto expected = hit_barycentric(ray, triangle_of(mesh, i));
      ASSERT_EQ(hit_barycentric(bvh, ray, i), expected) << about;
      ASSERT_EQ(hit_barycentric(small, ray, i), expected) << about;
      ASSERT_EQ(exact_hit_barycentric(small, ray, i).has_value(), expected.has_value()) << about;
      const auto posed = posed_triangle(mesh, i, pose);
      const auto t = query::first_hit_parameter(ray, posed, HitRule::closed);
      const auto exact = exact_hit_barycentric({bvh, pose}, ray, i);
      ASSERT_EQ(exact.has_value(), t.has_value()) << about;
      for (const auto& there : {hit_barycentric({bvh, pose}, ray, i), hit_barycentric({small, pose}, ray, i)})
        ASSERT_EQ(there, exact ? std::optional(rounded(*exact)) : std::nullopt) << about;
      if (!t) continue;
      const auto& s = posed.shape;
      expect_defined(ray, {image(s.a, pose), image(s.b, pose), image(s.c, pose)}, t->base.value().value, *exact, seen,
                     about);
    }
  });
  EXPECT_GT(seen.inside, battery::fitting(50));
  EXPECT_GT(seen.edges + seen.corners, battery::fitting(50));
}

/// Few rays look for their triangles by descents, many by a pass over all.
TEST(HitBarycentric, OfManyRaysIsThatOfEach) {
  const TriangleMesh mesh = meshes::ring(24);
  const Bvh bvh = build_bvh(mesh, {.split_share = 0.5F});
  const CompactBvh small = compact(bvh);
  const RigidPose turn{{2, 0, 1, 1}, {0.25, 0, 0}};
  const MeshView views[] = {bvh, small, MeshView(bvh, MeshPose(turn)), MeshView(small, MeshPose(turn))};
  std::vector<AnyRay> rays;
  for (int i = 0; i < 40; ++i) {
    for (int k = 0; k < 40; ++k) rays.emplace_back(Ray3{{9, 1, 0.5}, {-9, i * 0.1 - 3, k * 0.05 - 1}});
  }
  for (const MeshView& view : views) {
    for (const std::size_t n : {std::size_t{1}, std::size_t{0}, rays.size()}) {
      const auto asked = std::span(rays).first(n);
      std::vector<std::uint32_t> triangles(n);
      first_triangle(view, asked, triangles);
      std::vector<std::optional<HitBarycentric>> one(n), all(n);
      hit_barycentric(view, asked, triangles, one, Execution::serial);
      hit_barycentric(view, asked, triangles, all);
      EXPECT_EQ(one, all);
      std::size_t hit = 0;
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(all[i].has_value(), triangles[i] != no_triangle);
        if (!all[i]) continue;
        ++hit;
        EXPECT_EQ(all[i], hit_barycentric(view, rays[i], triangles[i]));
      }
      if (n > 1) {
        EXPECT_GT(hit, n / 8);
      }
    }
  }
}

TEST(HitBarycentric, RefusesWhatIsNone) {
  const Bvh bvh = build_bvh(meshes::ring(4));
  const AnyRay ray = Ray3{{0, 0, 0}, {1, 0, 0}}, none = Ray3{{0, 0, 0}, {1, 0, std::nan("")}};
  std::vector<std::optional<HitBarycentric>> out(2);
  const std::array<std::uint32_t, 2> triangles{0, no_triangle};
  EXPECT_THROW((void)hit_barycentric(none, Triangle3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), NonFinite);
  EXPECT_THROW((void)hit_barycentric(bvh, none, 0), NonFinite);
  EXPECT_THROW(hit_barycentric(bvh, std::array{ray, none}, triangles, out), NonFinite);
  EXPECT_THROW(hit_barycentric(bvh, std::array{ray}, triangles, out), UnequalLengths);
}

}  // namespace
}  // namespace plumb

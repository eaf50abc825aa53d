// Do rays hit solid leaves where they hit the mesh, at its vertices, along its edges and in the planes of its faces too?
#include "plumb/space/bsp/bsp_ray.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space/bsp/bsp_point.hpp"
#include "plumb/space/bsp/build_bsp.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "space/bsp/closed_meshes.hpp"

namespace plumb {
namespace {

using namespace bsp_cases;

/// Through two points about the mesh, as a segment, a ray or a line.
AnyRay ray_through(const Point3& p, const Point3& q, std::size_t i) {
  const Vector3 d{q.x - p.x, q.y - p.y, q.z - p.z};
  if (i % 4 == 0) return Segment3{p, q};
  if (i % 4 == 1) return Line3{p, d};
  return Ray3{p, d};
}

bool has_solid_on_one_side(const std::string& name) { return name != "heap" && name != "crossing"; }

TEST(BspRay, IsWhatTheMeshSays) {
  std::size_t hits = 0, misses = 0, from_inside = 0, at_begin = 0;
  for (const NamedMesh& m : closed_meshes()) {
    const Bvh bvh = build_bvh(m.mesh);
    for (const BspPlanes planes : {BspPlanes::faces, BspPlanes::faces_and_axes}) {
      const BspTree tree = build_bsp(m.mesh, {.planes = planes});
      const std::vector<Point3> points = points_about(m.mesh, 95, battery::fitting(2000u));
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const AnyRay ray = ray_through(points[i], points[i + 1], i);
        const auto expected = first_hit(bvh, ray);
        const auto found = first_hit(tree, ray);
        EXPECT_EQ(any_hit(tree, ray), found.has_value());
        if (!has_solid_on_one_side(m.name)) {  // told by the places alone
          EXPECT_TRUE(!found || (expected && expected->hit.t <= found->hit.t));
          continue;
        }
        ASSERT_EQ(found.has_value(), expected.has_value()) << m.name << ", points_about(mesh, 95, ...)[" << i << "]";
        if (!found) {
          ++misses;
          continue;
        }
        ++hits;
        EXPECT_EQ(found->hit, expected->hit) << m.name << ", points_about(mesh, 95, ...)[" << i << "]";
        EXPECT_EQ(found->face, expected->index) << m.name << ", points_about(mesh, 95, ...)[" << i << "]";
        from_inside += found->from_inside ? 1 : 0;
        at_begin += found->hit.t == 0 ? 1 : 0;
        if (ray.kind != AnyRay::Kind::line) {
          const Location begin = locate(tree, ray.origin);
          EXPECT_EQ(begin == Location::boundary, found->hit.t == 0 && found->hit.point == ray.origin);
          EXPECT_EQ(found->from_inside, begin == Location::inside);
        }
      }
    }
  }
  for (const std::size_t n : {hits, misses, from_inside, at_begin}) EXPECT_GT(n, battery::fitting(500u));
}

TEST(BspRay, SheetsAreNotHit) {
  TriangleMesh mesh = solids::box({0, 0, 0}, {4, 4, 4});
  solids::append(mesh, {{{1, 1, 2}, {3, 1, 2}, {1, 3, 2}}, {{0, 1, 2}, {0, 2, 1}}});
  const BspTree tree = build_bsp(mesh);
  const auto up = first_hit(tree, Ray3{{1.5, 1.5, 1}, {0, 0, 1}});
  ASSERT_TRUE(up);
  EXPECT_EQ(up->hit.t, 3);
  EXPECT_TRUE(up->from_inside);
  EXPECT_LT(up->face, 12u);
}

TEST(BspRay, OfPolygons) {
  const PolygonMesh cube{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}},
                         {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7},
                         {0, 4, 8, 12, 16, 20, 24}};
  const BspTree tree = build_bsp(cube, {.planes = BspPlanes::faces});
  EXPECT_EQ(tree.report.pieces, 6u);
  const auto hit = first_hit(tree, Ray3{{1, 1, 5}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->face, 1u);
  EXPECT_EQ(hit->hit.t, 3);
  EXPECT_FALSE(first_hit(tree, Segment3{{1, 1, 5}, {1, 1, 3}}));
  EXPECT_FALSE(first_hit(tree, Ray3{{1, 1, 5}, {0, 0, 0}}));
  EXPECT_EQ(first_hit(tree, Ray3{{1, 1, 2}, {0, 0, 0}})->face, 1u);
}

TEST(BspRay, SaysWhatItRefuses) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 2, 3});
  const double nan = std::nan("");
  EXPECT_THROW((void)first_hit(build_bsp(mesh), Ray3{{0, 0, 0}, {nan, 0, 0}}), NonFinite);
  EXPECT_THROW((void)first_hit(build_bsp(mesh), Segment3{{0, 0, 0}, {nan, 0, 0}}), NonFinite);
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)first_hit(build_bsp(mesh, {.kind = BspKind::node_storing}), Ray3{{0, 0, 0}, {1, 0, 0}});
              }),
              testing::HasSubstr("solid leaves"));
}

}  // namespace
}  // namespace plumb

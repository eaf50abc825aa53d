// Does what moves touch the solid when it first touches one of the mesh's triangles, each asked alone?
#include "plumb/space/bsp/bsp_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/coplanar.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "plumb/space/bsp/build_bsp.hpp"
#include "space/bsp/closed_meshes.hpp"

namespace plumb {
namespace {

using namespace bsp_cases;

struct Told {
  std::size_t nothing = 0, within = 0, at_once = 0, later = 0;
};

template <class Shape>
void check(const BspTree& tree, const TriangleMesh& mesh, const Translating<Shape>& moving, const Point3& of_shape,
           Told& told) {
  std::optional<Root> first;
  std::uint32_t face = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    const Triangle3 triangle{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    if (coplanar_orientation(triangle.a, triangle.b, triangle.c) == Sign::zero) continue;
    const auto time = first_contact_time(moving, triangle);
    if (!time || (first && !(*time < *first))) continue;
    first = time;
    face = f;
  }
  const auto found = first_touch(tree, moving);
  const bool at_once = first && *first == Root(Rational(0));
  if (!at_once && locate(mesh, of_shape) == Location::inside) {
    ++told.within;
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->within);
    EXPECT_EQ(found->contact.time, 0);
    return;
  }
  ASSERT_EQ(found.has_value(), first.has_value());
  if (!found) {
    ++told.nothing;
    return;
  }
  ++(at_once ? told.at_once : told.later);
  const auto& t = mesh.triangles[face];
  EXPECT_FALSE(found->within);
  EXPECT_EQ(found->face, face);
  EXPECT_EQ(found->contact,
            first_contact(moving, Triangle3{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}));
}

TEST(BspMotion, TouchesWhenItTouchesATriangle) {
  Told told;
  for (const NamedMesh& m : closed_meshes()) {
    if (m.name == "tiny box" || m.name == "hollow torus" || m.name == "ring") continue;
    const BspTree tree = build_bsp(m.mesh);
    const std::vector<Point3> points = points_about(m.mesh, 98, battery::fitting(120u));
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      SCOPED_TRACE(m.name + ", points_about(mesh, 98, ...)[" + std::to_string(i) + "]");
      Entropy e(99, i);
      const auto part = [&] { return static_cast<double>(e.below(9)) / 16; };
      const Point3 &p = points[i], &q = points[i + 1];
      const Vector3 by{q.x - p.x, q.y - p.y, q.z - p.z};
      if (i % 4 == 0) check(tree, m.mesh, Translating{Sphere3{p, part()}, by}, p, told);
      if (i % 4 == 1) {
        const Aabb3 box{p, {p.x + part(), p.y + part(), p.z + part()}};
        check(tree, m.mesh, Translating{box, by}, p, told);
      }
      if (i % 4 == 2) {
        const Capsule3 capsule{p, {p.x + part(), p.y - part(), p.z}, part() / 4};
        check(tree, m.mesh, Translating{capsule, by}, p, told);
      }
      if (i % 4 == 3) {
        const std::vector<Point3> corners{p, {p.x + 0.5, p.y, p.z}, {p.x, p.y + 0.25, p.z}, {p.x, p.y, p.z - 0.25}};
        const ConvexPolyhedron3 body = convex_polyhedron(convex_hull(corners), corners);
        check(tree, m.mesh, Translating<ConvexPolyhedron3>{body, by}, body.mesh.vertices[0], told);
      }
      if (HasFatalFailure()) return;
    }
  }
  for (const std::size_t n : {told.nothing, told.within, told.at_once, told.later}) EXPECT_GE(n, battery::fitting(10u));
}

TEST(BspMotion, SaysWhatItRefuses) {
  const TriangleMesh mesh = solids::box({0, 0, 0}, {1, 2, 3});
  const BspTree tree = build_bsp(mesh);
  EXPECT_THROW((void)first_touch(tree, Translating{Sphere3{{0, 0, 9}, -1}, Vector3{0, 0, 1}}), InvalidShape);
  EXPECT_THROW((void)first_touch(tree, Translating{Sphere3{{0, 0, 9}, 1}, Vector3{0, std::nan(""), 1}}), NonFinite);
  EXPECT_THROW((void)first_touch(tree, Translating{Sphere3{{0, std::nan(""), 9}, 1}, Vector3{0, 0, 1}}), NonFinite);
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)first_touch(build_bsp(mesh, {.kind = BspKind::node_storing}),
                                  Translating{Sphere3{{0, 0, 9}, 1}, Vector3{0, 0, 1}});
              }),
              testing::HasSubstr("solid leaves"));
}

}  // namespace
}  // namespace plumb

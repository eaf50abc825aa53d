// Are the numbers of a ray that is moved back as near to the exact ones as is said?  In rationals.
#include "space/ray/seen_ray.hpp"

#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "plumb/arith/gmp.hpp"
#include "space/bvh/poses.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;
using namespace poses;
using Exact = arith::Vec<mpq_class>;
using Floats = arith::Vec<double>;

template <class Numbers>
Exact exact(const Numbers& p) {
  return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
}
mpq_class product(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Exact across(const Exact& a, const Exact& b) {
  return {mpq_class(a.y * b.z - a.z * b.y), mpq_class(a.z * b.x - a.x * b.z), mpq_class(a.x * b.y - a.y * b.x)};
}
Exact less(const Exact& a, const Exact& b) {
  return {mpq_class(a.x - b.x), mpq_class(a.y - b.y), mpq_class(a.z - b.z)};
}

/// Where the pose takes from what it takes to v; of a regular one.
Exact moved_back(const Pose& pose, const Exact& v) {
  const Exact a = exact(pose.columns[0]), b = exact(pose.columns[1]), c = exact(pose.columns[2]);
  const Exact bc = across(b, c), ca = across(c, a), ab = across(a, b);
  const mpq_class determinant = product(a, bc);
  return {mpq_class(product(bc, v) / determinant), mpq_class(product(ca, v) / determinant),
          mpq_class(product(ab, v) / determinant)};
}

/// As the lanes have it.
struct Sides {
  double ab, bc, ca, sum, plane;
};
Sides sides_of(const query::BatchRay& ray, const Triangle3& t) {
  const Floats o{ray.origin[0], ray.origin[1], ray.origin[2]}, d{ray.direction[0], ray.direction[1], ray.direction[2]};
  const Floats a = arith::vec<double>(t.a) - o, b = arith::vec<double>(t.b) - o, c = arith::vec<double>(t.c) - o;
  const Floats of_bc = cross(c, b);
  const double ab = dot(d, cross(b, a)), bc = dot(d, of_bc), ca = dot(d, cross(a, c));
  return {ab, bc, ca, ab + bc + ca, dot(a, of_bc)};
}

bool is_near(double computed, const mpq_class& exact, double doubt) {
  return abs(mpq_class(computed) - exact) <= mpq_class(doubt);
}

/// Of every triangle; false where the ray is not seen.
bool expect_near(const AnyRay& ray, const TriangleMesh& mesh, const Bvh& bvh, const Pose& pose,
                 const std::string& about) {
  const auto seen = space::Sight(PosedMesh{bvh, pose})(ray);
  if (!seen) return false;
  const bool segment = ray.kind == AnyRay::Kind::segment;
  const Exact from = moved_back(pose, less(exact(ray.origin), exact(pose.translation)));
  const Exact way = moved_back(pose, segment ? less(exact(ray.end), exact(ray.origin)) : exact(ray.direction));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle3 t = triangle_of(mesh, i);
    const Sides sides = sides_of(seen->ray, t);
    const Exact a = less(exact(t.a), from), b = less(exact(t.b), from), c = less(exact(t.c), from);
    const mpq_class ab = product(way, across(b, a)), bc = product(way, across(c, b)), ca = product(way, across(a, c)),
                    sum = ab + bc + ca, plane = product(a, across(c, b));
    EXPECT_TRUE(is_near(sides.ab, ab, seen->doubts.edge)) << about << " triangle " << i;
    EXPECT_TRUE(is_near(sides.bc, bc, seen->doubts.edge)) << about << " triangle " << i;
    EXPECT_TRUE(is_near(sides.ca, ca, seen->doubts.edge)) << about << " triangle " << i;
    EXPECT_TRUE(is_near(sides.sum, sum, seen->doubts.sum)) << about << " triangle " << i;
    EXPECT_TRUE(is_near(sides.plane, plane, seen->doubts.plane)) << about << " triangle " << i;
    EXPECT_TRUE(is_near(sides.plane - sides.sum, plane - sum, seen->doubts.end)) << about << " triangle " << i;
  }
  return true;
}

TEST(SeenRay, IsOffByItsDoubtsAtMost) {
  long seen = 0;
  on_shapes(1721, battery::fitting(1500), [&](Material& m) {
    const TriangleMesh mesh = drawn_mesh(m, 8);
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const Pose pose = any_pose(m);
    const AnyRay ray = ray_of(m);
    seen += expect_near(ray, mesh, bvh, pose, m.about() + " " + text_of(ray)) ? 1 : 0;
  });
  EXPECT_GT(seen, battery::fitting(300));
}

// Then the rounding of the place that it is moved back to is more than all others.
TEST(SeenRay, IsOffByItsDoubtsAtMostNearASmallMeshFarFromWhereItWasBuilt) {
  TriangleMesh mesh = meshes::ring(3);
  for (Point3& p : mesh.vertices) p = {1000 + 0x1p-20 * p.x, 900 + 0x1p-20 * p.y, 800 + 0x1p-20 * p.z};
  const Bvh bvh = build_bvh(mesh);
  on_shapes(1723, battery::fitting(50), [&](Material& m) {
    Pose pose = turn(m);
    pose.translation = {0.1, 0.2, 0.3};
    const Point3 at = approximate(Posed<Point3>{mesh.vertices[m.below(mesh.vertices.size())], pose});
    const Ray3 ray{{at.x + 0x1p-20, at.y, at.z - 0x1p-21}, {-2, 0.1, 1}};
    EXPECT_TRUE(expect_near(ray, mesh, bvh, pose, m.about() + " " + text_of(ray)));
  });
}

TEST(SeenRay, IsSeenThroughATurnAndHardlyInDoubt) {
  const Bvh bvh = build_bvh(meshes::ring(6));
  on_shapes(1722, battery::fitting(50), [&](Material& m) {
    Pose pose = turn(m);
    pose.translation = {0.1, 0.2, 0.3};
    const auto seen = space::Sight(PosedMesh{bvh, pose})(Ray3{{5, 4, 3}, {-5, -4, -2}});
    ASSERT_TRUE(seen) << m.about();
    EXPECT_LT(seen->doubts.edge, 1e-11) << m.about();
    EXPECT_LT(seen->doubts.end, 1e-10) << m.about();
  });
}

TEST(SeenRay, NothingIsSeenWhereThePoseFlattens) {
  const Bvh bvh = build_bvh(meshes::ring(6));
  const Ray3 ray{{5, 4, 3}, {-5, -4, -2}};
  EXPECT_FALSE(space::Sight(PosedMesh{bvh, Pose{{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {0, 0, 0}}})(ray));
  EXPECT_FALSE(space::Sight(PosedMesh{bvh, Pose{{{{0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}, {0, 0, 1}}}, {0, 0, 0}}})(ray));
  EXPECT_FALSE(space::Sight(PosedMesh{bvh, identity_pose})(Ray3{{0, 0, 0}, {0, 0, 0}}));
  const Bvh nothing = build_bvh(TriangleMesh{});
  EXPECT_FALSE(space::Sight(PosedMesh{nothing, identity_pose})(ray));
}

}  // namespace
}  // namespace plumb

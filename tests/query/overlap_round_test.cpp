// Balls, capsules and lozenges against what is flat and convex, and one another: against brute force over rationals.
#include "plumb/query/overlap_round.hpp"

#include <gtest/gtest.h>

#include "plumb/query/overlap.hpp"
#include "query/round_oracle.hpp"

namespace plumb {
namespace {

TEST(OverlapRound, PointSphere) { expect_as_brute_force<Point3, Sphere3>(499, 400); }
TEST(OverlapRound, LineSphere) { expect_as_brute_force<Line3, Sphere3>(500, 600); }
TEST(OverlapRound, RaySphere) { expect_as_brute_force<Ray3, Sphere3>(501, 600); }
TEST(OverlapRound, SegmentSphere) { expect_as_brute_force<Segment3, Sphere3>(502, 600); }
TEST(OverlapRound, PlaneSphere) { expect_as_brute_force<Plane3, Sphere3>(503, 300); }
TEST(OverlapRound, ThreePointPlaneSphere) { expect_as_brute_force<ThreePointPlane3, Sphere3>(504, 300); }
TEST(OverlapRound, HalfspaceSphere) { expect_as_brute_force<Halfspace3, Sphere3>(505, 300); }
TEST(OverlapRound, TriangleSphere) { expect_as_brute_force<Triangle3, Sphere3>(506, 800); }
TEST(OverlapRound, RectangleSphere) { expect_as_brute_force<Rectangle3, Sphere3>(507, 300); }
TEST(OverlapRound, TetrahedronSphere) { expect_as_brute_force<Tetrahedron3, Sphere3>(508, 400); }
TEST(OverlapRound, AabbSphere) { expect_as_brute_force<Aabb3, Sphere3>(509, 400); }
TEST(OverlapRound, ObbSphere) { expect_as_brute_force<Obb3, Sphere3>(510, 200); }
TEST(OverlapRound, KDopSphere) { expect_as_brute_force<KDop3, Sphere3>(511, 60); }
TEST(OverlapRound, PolyhedronSphere) { expect_as_brute_force<ConvexPolyhedron3, Sphere3>(512, 200); }

TEST(OverlapRound, LineCapsule) { expect_as_brute_force<Line3, Capsule3>(520, 400); }
TEST(OverlapRound, RayCapsule) { expect_as_brute_force<Ray3, Capsule3>(521, 400); }
TEST(OverlapRound, SegmentCapsule) { expect_as_brute_force<Segment3, Capsule3>(522, 400); }
TEST(OverlapRound, PlaneCapsule) { expect_as_brute_force<Plane3, Capsule3>(523, 200); }
TEST(OverlapRound, ThreePointPlaneCapsule) { expect_as_brute_force<ThreePointPlane3, Capsule3>(524, 200); }
TEST(OverlapRound, HalfspaceCapsule) { expect_as_brute_force<Halfspace3, Capsule3>(525, 200); }
TEST(OverlapRound, TriangleCapsule) { expect_as_brute_force<Triangle3, Capsule3>(526, 400); }
TEST(OverlapRound, RectangleCapsule) { expect_as_brute_force<Rectangle3, Capsule3>(527, 100); }
TEST(OverlapRound, TetrahedronCapsule) { expect_as_brute_force<Tetrahedron3, Capsule3>(528, 150); }
TEST(OverlapRound, AabbCapsule) { expect_as_brute_force<Aabb3, Capsule3>(529, 100); }
TEST(OverlapRound, ObbCapsule) { expect_as_brute_force<Obb3, Capsule3>(530, 100); }
TEST(OverlapRound, KDopCapsule) { expect_as_brute_force<KDop3, Capsule3>(531, 50); }
TEST(OverlapRound, PolyhedronCapsule) { expect_as_brute_force<ConvexPolyhedron3, Capsule3>(532, 80); }

TEST(OverlapRound, LineLozenge) { expect_as_brute_force<Line3, Lozenge3>(540, 120); }
TEST(OverlapRound, RayLozenge) { expect_as_brute_force<Ray3, Lozenge3>(541, 120); }
TEST(OverlapRound, SegmentLozenge) { expect_as_brute_force<Segment3, Lozenge3>(542, 80); }
TEST(OverlapRound, PlaneLozenge) { expect_as_brute_force<Plane3, Lozenge3>(543, 60); }
TEST(OverlapRound, ThreePointPlaneLozenge) { expect_as_brute_force<ThreePointPlane3, Lozenge3>(544, 60); }
TEST(OverlapRound, HalfspaceLozenge) { expect_as_brute_force<Halfspace3, Lozenge3>(545, 60); }
TEST(OverlapRound, TriangleLozenge) { expect_as_brute_force<Triangle3, Lozenge3>(546, 50); }
TEST(OverlapRound, AabbLozenge) { expect_as_brute_force<Aabb3, Lozenge3>(549, 6); }
TEST(OverlapRound, ObbLozenge) { expect_as_brute_force<Obb3, Lozenge3>(550, 6); }
TEST(OverlapRound, KDopLozenge) { expect_as_brute_force<KDop3, Lozenge3>(551, 2); }

TEST(OverlapRound, SphereCapsule) { expect_round_as_brute_force<Sphere3, Capsule3>(560, 400); }
TEST(OverlapRound, SphereLozenge) { expect_round_as_brute_force<Sphere3, Lozenge3>(561, 200); }
TEST(OverlapRound, CapsuleLozenge) { expect_round_as_brute_force<Capsule3, Lozenge3>(562, 100); }

TEST(OverlapRound, AnEndThatOverflowsIsNotLeftOut) {
  const Point3 a{1e76, -1e76, 0}, b{1e300, 2e301, 0}, c{1e76, -1e76, 1e70};
  const Capsule3 ball{{0, 0, 0}, {0, 0, 0}, 1.2e76};
  EXPECT_EQ(relate(Triangle3{a, b, c}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, c, b}, ball), Relation::overlapping);
  EXPECT_EQ(relate(Triangle3{a, b, c}, Sphere3{{0, 0, 0}, 1.2e76}), Relation::overlapping);
}

}  // namespace
}  // namespace plumb

// Do bodies with a radius meet?  What doubles prove, and what integers tell of the rest, against exact distances; and the
// same under rigid poses.
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/rotation.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/gjk/met_at_once.hpp"

namespace plumb::query {
namespace {

struct Seen {
  int by_doubles = 0, by_integers = 0, touching = 0, apart = 0, meeting = 0;
};

template <class A, class B>
void ask(const A& a, const B& b, Seen& seen) {
  const BodyView of_a = body_view(a), of_b = body_view(b);
  QuickBody p{of_a}, q{of_b};
  ASSERT_TRUE(p.set() && q.set());
  const mpq_class reach = mpq_class(p.radius) + mpq_class(q.radius);
  const int gap = sgn(mpq_class(*squared_distance(core_of(of_a.figure), core_of(of_b.figure)) - reach * reach));
  GjkCache found;
  std::uint32_t steps = 0;
  const Told quick = quickly_told_round(p, q, found, steps);
  ++(quick == Told::unsure ? seen.by_integers : seen.by_doubles);
  ++(gap == 0 ? seen.touching : gap > 0 ? seen.apart : seen.meeting);
  if (quick != Told::unsure) {
    EXPECT_EQ(quick == Told::apart ? 1 : -1, gap);
  }
  GjkCache none;
  EXPECT_EQ(met_at_once(p, q, none), gap > 0 ? MetAtOnce::apart : gap == 0 ? MetAtOnce::touch : MetAtOnce::overlap);
  EXPECT_EQ(static_cast<int>(plumb::relate(a, b)), -gap);
  EXPECT_EQ(gjk_intersects(a, b), gap <= 0);
  EXPECT_EQ(gjk_intersects(a, b, {.cache = &found}), gap <= 0);
  EXPECT_EQ(gjk_distance(a, b) > 0, gap > 0);
}

/// On a grid of so many steps of this length, where much touches.
class GridShapes {
 public:
  GridShapes(std::uint64_t seed, std::uint64_t steps, double unit) : entropy_(97, seed), steps_(steps), unit_(unit) {}

  double number() {
    return (static_cast<double>(entropy_.below(2 * steps_ + 1)) - static_cast<double>(steps_)) * unit_;
  }
  double radius() { return static_cast<double>(1 + entropy_.below(steps_)) * unit_; }
  Point3 point() { return {number(), number(), number()}; }
  Vector3 vector() { return {number() / unit_, number() / unit_, number() / unit_}; }
  Segment3 segment() { return {point(), point()}; }
  Aabb3 box() {
    const Point3 p = point(), q = point();
    return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
            {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
  }

 private:
  Entropy entropy_;
  std::uint64_t steps_;
  double unit_;
};

TEST(RoundMeeting, WhatIsToldIsSoAndIntegersTellWhatTouches) {
  for (const double unit : {1.0, 0x1p-200, 1.0 + 0x1p-52}) {
    SCOPED_TRACE(unit);
    Seen seen;
    for (std::uint64_t i = 0; i < (battery::sanitized ? 100 : 2000); ++i) {
      SCOPED_TRACE(i);
      GridShapes s(i, 3 + i % 3, unit);
      const Capsule3 capsule{s.point(), s.point(), s.radius()};
      const Sphere3 ball{s.point(), s.radius()};
      const Lozenge3 lozenge{s.point(), {s.vector(), s.vector()}, s.radius()};
      ask(Triangle3{s.point(), s.point(), s.point()}, ball, seen);
      ask(capsule, lozenge, seen);
      ask(s.box(), capsule, seen);
      ask(Tetrahedron3{s.point(), s.point(), s.point(), s.point()}, capsule, seen);
      ask(Obb3{s.point(), {s.vector(), s.vector(), s.vector()}, {s.radius(), s.radius(), s.radius()}}, lozenge, seen);
    }
    if (battery::reaches_rare) {
      EXPECT_GE(seen.touching, 50);  // fewest touch where multiples of the unit are rounded
      EXPECT_GE(seen.by_integers, seen.touching);
      EXPECT_GE(seen.apart * 4, seen.meeting);
    }
  }
}

TEST(RoundMeeting, NumbersFarApartAreDecidedAsWell) {
  const Sphere3 ball{{0, 0, 0}, 0x1p1000};
  EXPECT_EQ(plumb::relate(Point3{0x1p1000, 0, 0}, ball), Relation::touching);
  EXPECT_EQ(plumb::relate(Capsule3{{0x1p1000, 0x1p-1000, 0}, {0x1p1001, 0, 0}, 0x1p-1000}, ball),
            Relation::overlapping);
  EXPECT_EQ(plumb::relate(Triangle3{{0x1p1000, 0x1p-1000, 0}, {0x1p1001, 0, 0}, {0x1p1000, 0, 1}}, ball),
            Relation::disjoint);
}

RigidPose pose_of(GridShapes& s) {
  const auto part = [&s] { return s.number() / 8; };
  return {rotation({part(), part(), part() + 2}, part()).turn, {part(), part(), part()}};
}

/// A common rigid pose changes no relation, whatever touches.
template <class A, class B>
void pose_both(const A& a, const B& b, const RigidPose& pose, Seen& seen) {
  const Relation plain = plumb::relate(a, b);
  ++(plain == Relation::touching ? seen.touching : plain == Relation::disjoint ? seen.apart : seen.meeting);
  const RigidChain chain{{pose, {{2, 1, 0, 0}, {1, 2, 3}}}};
  EXPECT_EQ(plumb::relate(Posed{a, pose}, Posed{b, pose}), plain);
  EXPECT_EQ(plumb::intersects(Posed{a, pose}, Posed{b, pose}), plain != Relation::disjoint);
  EXPECT_EQ(gjk_intersects(Posed{a, pose}, Posed{b, pose}), plain != Relation::disjoint);
  EXPECT_EQ(plumb::relate(Posed{a, chain}, Posed{b, chain}), plain);
}

TEST(RoundMeeting, ACommonRigidPoseChangesNothing) {
  Seen seen;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 10 : 100); ++i) {
    SCOPED_TRACE(i);
    GridShapes s(i, 3, 1);
    const RigidPose pose = pose_of(s);
    const Tetrahedron3 tetrahedron{s.point(), s.point(), s.point(), s.point()};
    const Aabb3 box = s.box();
    const Capsule3 capsule{s.point(), s.point(), s.radius()};
    pose_both(tetrahedron, capsule, pose, seen);
    pose_both(box, Tetrahedron3{s.point(), s.point(), s.point(), s.point()}, pose, seen);
    pose_both(box, s.box(), pose, seen);
    pose_both(Triangle3{s.point(), s.point(), s.point()}, tetrahedron, pose, seen);
    pose_both(s.segment(), Triangle3{s.point(), s.point(), s.point()}, pose, seen);
    const Point3 p = s.point();
    const std::vector<Point3> points{p, {p.x + 2, p.y, p.z}, {p.x, p.y + 2, p.z}, {p.x, p.y, p.z + 2}};
    const ConvexPolyhedron3 solid = convex_polyhedron(convex_hull(points), points);
    pose_both(capsule, solid, pose, seen);
    pose_both(tetrahedron, solid, pose, seen);
  }
  if (battery::reaches_rare) {
    EXPECT_GE(seen.touching, 20);
    EXPECT_GE(seen.apart, 100);
    EXPECT_GE(seen.meeting, 100);
  }
}

}  // namespace
}  // namespace plumb::query

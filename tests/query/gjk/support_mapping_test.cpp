// Black boxes: polytopes, whose distance is known exactly, balls and ellipsoids in doubles, and mappings that are none.
#include "plumb/query/gjk/support_mapping.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/query/gjk/figure_support.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/penetration/penetration_bounds.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/gjk/any_body.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb {
namespace {

using namespace drawn_body;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The farthest of some points, exactly.
struct Listed {
  std::vector<Point3> points;
  Point3 operator()(const Vector3& d) const {
    const Point3* best = nullptr;
    mpq_class most;
    for (const Point3& p : points) {
      const mpq_class reach = query::dot(Exact3{d.x, d.y, d.z}, Exact3{p.x, p.y, p.z});
      if (best == nullptr || reach > most) best = &p, most = reach;
    }
    return *best;
  }
};

TEST(SupportMappings, OfPolytopesBoundTheirDistance) {
  int meet = 0, apart = 0, undecided = 0, exact = 0;
  shape_cases::on_shapes(35'001, battery::sanitized ? 30 : 200, [&](Material& m) {
    const auto points = [&] {
      std::vector<Point3> all;
      for (std::size_t n = 1 + m.below(8); n-- > 0;) all.push_back(m.below(2) == 0 ? m.point3() : m.probe3());
      return all;
    };
    const Listed a{points()}, b{points()};
    FlatSet p, q;
    for (const Point3& v : a.points) p.points.push_back({v.x, v.y, v.z});
    for (const Point3& v : b.points) q.points.push_back({v.x, v.y, v.z});
    const mpq_class square = query::nearest_pair(p, q, query::WhichPair::any)->square;
    const GjkBounds bounds = gjk_bounds(a, b);
    const double d = query::rounded_distance(square, 0);
    EXPECT_LE(bounds.lower, d) << m.about();
    EXPECT_GE(bounds.upper, d) << m.about();
    EXPECT_NE(bounds.told, sgn(square) == 0 ? GjkTold::disjoint : GjkTold::meeting) << m.about();
    if (bounds.told == GjkTold::undecided) {
      ++undecided;
    } else {
      (sgn(square) == 0 ? meet : apart) += 1;
    }
    exact += std::nextafter(bounds.lower, HUGE_VAL) >= d && std::nextafter(bounds.upper, 0.0) <= d;
  });
  std::printf("%d meet, %d apart, %d undecided, %d within an ulp\n", meet, apart, undecided, exact);
  EXPECT_GT(meet, battery::sanitized ? 3 : 20);
  EXPECT_GT(apart, battery::sanitized ? 3 : 20);
  EXPECT_LT(undecided * 10, meet + apart);
}

/// In plain doubles, of half axes along those of space.
struct Ellipsoid {
  Point3 center;
  Vector3 half;
  Point3 operator()(const Vector3& d) const {
    const Vector3 s{d.x * half.x, d.y * half.y, d.z * half.z};
    const double length = std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
    return {center.x + half.x * s.x / length, center.y + half.y * s.y / length, center.z + half.z * s.z / length};
  }
};

TEST(SupportMappings, OfRoundBodiesComeNear) {
  const Ellipsoid ball{{0, 0, 0}, {1, 1, 1}}, other{{3, 4, 12}, {2, 2, 2}};
  const GjkBounds apart = gjk_bounds(ball, other, {.rounding = 0x1p-48, .within = 1e-9});
  EXPECT_EQ(apart.told, GjkTold::disjoint);
  EXPECT_LE(apart.lower, 10);
  EXPECT_GE(apart.upper, 10);
  EXPECT_LT(apart.upper - apart.lower, 1e-9);
  const GjkBounds meet = gjk_bounds(ball, Ellipsoid{{0.5, 0.5, 0}, {2, 1, 0.5}}, {.rounding = 0x1p-48});
  EXPECT_EQ(meet.told, GjkTold::meeting);
  EXPECT_EQ(meet.lower, 0);
  EXPECT_EQ(meet.upper, 0);
  const GjkBounds touch = gjk_bounds(ball, Ellipsoid{{2, 0, 0}, {1, 1, 1}}, {.rounding = 0x1p-48});
  EXPECT_EQ(touch.told, GjkTold::undecided);
  EXPECT_EQ(touch.lower, 0);
  EXPECT_LT(touch.upper, 1e-12);
  const GjkBounds long_one = gjk_bounds(Ellipsoid{{0, 0, 0}, {5, 0.1, 1}}, Ellipsoid{{0, 3, 0}, {4, 1, 0.2}},
                                        {.rounding = 0x1p-46, .within = 1e-9});
  EXPECT_EQ(long_one.told, GjkTold::disjoint);
  EXPECT_NEAR(long_one.lower, 1.9, 1e-8);
}

TEST(SupportMappings, OfFiguresKnowTheirRounding) {
  const Cylinder3 pipe{{0, 0, 0}, {0, 0, 4}, 1};
  const GjkBounds beside = gjk_bounds(pipe, Aabb3{{4, 5, 1}, {9, 9, 2}}, {.within = 1e-12});
  const double apart = std::sqrt(41) - 1;
  EXPECT_EQ(beside.told, GjkTold::disjoint);
  EXPECT_LE(beside.lower, apart);
  EXPECT_GE(beside.upper, apart);
  EXPECT_LE(beside.upper - beside.lower, 1e-12);
  const GjkBounds above = gjk_bounds(Cone3{{0, 0, 9}, {0, 0, 6}, 2}, pipe, {.within = 1e-12});
  EXPECT_NEAR(above.lower, 2, 1e-12);
  const Ellipsoid3 egg{{8, 0, 2}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {3, 2, 1}};
  const GjkBounds eggs = gjk_bounds(egg, pipe, {.within = 1e-12});
  EXPECT_LE(eggs.lower, 4);
  EXPECT_GE(eggs.upper, 4);
  EXPECT_LE(eggs.upper - eggs.lower, 1e-12);
  EXPECT_EQ(gjk_bounds(egg, Point3{8, 0, 2}).told, GjkTold::meeting);
}

/// Around one axis, across, and around one center: the origin is on an edge or a face of the first difference of hulls.
TEST(SupportMappings, OfFiguresDeepInOneAnotherAreCertain) {
  const Cylinder3 pipe{{0, 0, 0}, {0, 0, 4}, 1}, along{{0, 0, 1}, {0, 0, 9}, 0.5}, across{{-2, 0, 2}, {3, 0, 2}, 1};
  const Cone3 hat{{0, 0, 5}, {0, 0, 1}, 2};
  EXPECT_EQ(gjk_bounds(pipe, pipe).told, GjkTold::meeting);
  EXPECT_EQ(gjk_bounds(pipe, along).told, GjkTold::meeting);
  EXPECT_EQ(gjk_bounds(pipe, across).told, GjkTold::meeting);
  EXPECT_EQ(gjk_bounds(hat, across).told, GjkTold::meeting);
  EXPECT_EQ(gjk_bounds(pipe, Cylinder3{{0, 0, 4}, {0, 0, 9}, 1}).told, GjkTold::undecided);  // one face
  int meet = 0, undecided = 0;
  shape_cases::on_shapes(35'003, battery::sanitized ? 20 : 150, [&](Material& m) {
    const Cylinder3 a{m.point3(), m.point3(), 2}, b{m.point3(), m.point3(), 1};
    GjkBounds bounds;
    PenetrationBounds depth;
    try {
      bounds = gjk_bounds(a, b);
      depth = penetration(a, b, {.most_steps = 16});
    } catch (const Error&) {  // beyond doubles, or no cylinder
      return;
    }
    const bool meet_surely = bounds.told == GjkTold::meeting;
    EXPECT_TRUE(!meet_surely || (bounds.upper == 0 && depth.told != GjkTold::disjoint)) << m.about();
    if (depth.told != GjkTold::meeting) return;
    meet += meet_surely, undecided += bounds.told == GjkTold::undecided;
    EXPECT_NE(bounds.told, GjkTold::disjoint) << m.about();
  });
  std::printf("%d meet, %d undecided of these\n", meet, undecided);
  EXPECT_GT(meet, battery::sanitized ? 1 : 5);
  EXPECT_LE(10 * undecided, meet);
}

/// Both hold the distance, and are near to one another.
void expect_of_one(const GjkBounds& a, const GjkBounds& b, double within) {
  EXPECT_LE(a.lower, b.upper);
  EXPECT_LE(b.lower, a.upper);
  EXPECT_EQ(a.told, b.told);
  EXPECT_LE(std::max(a.upper, b.upper) - std::min(a.lower, b.lower), within);
}

TEST(SupportMappings, OfPosedFiguresAreThoseOfTheirImages) {
  // A turn by integers, and lengths times five: the image of a cylinder and of a cone is one in doubles.
  const Pose turn{{{{0, 3, 4}, {5, 0, 0}, {0, 4, -3}}}, {1, -2, 7}};
  const auto image = [&](const Point3& p) { return rounded_image(turn, p); };
  const Cylinder3 pipe{{0, 0, 0}, {1, 2, 4}, 1}, turned_pipe{image(pipe.a), image(pipe.b), 5};
  const Cone3 cone{{0, 0, 9}, {0, 1, 6}, 2}, turned_cone{image(cone.apex), image(cone.base), 10};
  const Aabb3 box{{40, 50, 10}, {90, 90, 20}};
  const double within = 1e-11;
  expect_of_one(gjk_bounds(Posed{pipe, turn}, box, {.within = 1e-12}), gjk_bounds(turned_pipe, box, {.within = 1e-12}),
                within);
  expect_of_one(gjk_bounds(box, Posed{cone, turn}, {.within = 1e-12}), gjk_bounds(box, turned_cone, {.within = 1e-12}),
                within);
  // Both under one pose: five times as far, whatever the two are.
  const GjkBounds apart = gjk_bounds(pipe, cone, {.within = 1e-12}),
                  both = gjk_bounds(Posed{pipe, turn}, Posed{cone, turn}, {.within = 1e-11});
  EXPECT_EQ(both.told, GjkTold::disjoint);
  EXPECT_LE(both.lower, 5 * apart.upper);
  EXPECT_GE(both.upper, 5 * apart.lower);
  EXPECT_LT(both.upper - both.lower, within);
  // A ball that is sheared and mirrored is an ellipsoid; one that is flattened a disk.
  const Pose stretch{{{{-3, 0, 0}, {0, 2, 0}, {0, 0, 1}}}, {8, 0, 2}},
      flat{{{{3, 0, 0}, {0, 2, 0}, {0, 0, 0}}}, {8, 0, 2}};
  const Sphere3 ball{{0, 0, 0}, 1};
  const Ellipsoid3 egg{{8, 0, 2}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {3, 2, 1}};
  expect_of_one(gjk_bounds(Posed{ball, stretch}, pipe, {.within = 1e-12}), gjk_bounds(egg, pipe, {.within = 1e-12}),
                within);
  const GjkBounds disk = gjk_bounds(Posed{ball, flat}, Point3{8, 0, 5}, {.within = 1e-12});
  EXPECT_LE(disk.lower, 3);
  EXPECT_GE(disk.upper, 3);
  EXPECT_LT(disk.upper - disk.lower, within);
}

TEST(SupportMappings, OfPosedPolytopesBoundTheirExactDistance) {
  int disjoint = 0, close = 0, meet = 0, undecided = 0;
  shape_cases::on_shapes(35'002, battery::sanitized ? 20 : 80, [&](Material& m) {
    std::vector<Point3> p, q;
    for (std::size_t n = 1 + m.below(6); n-- > 0;) p.push_back(m.point3()), q.push_back(m.probe3());
    const auto check = [&](const auto& pose) {
      if (m.below(3) == 0) q.push_back(rounded_image(pose, p[0]));  // about touching
      const Posed a{VertexHull3{p}, pose};
      const VertexHull3 b{q};
      GjkBounds bounds;
      try {
        bounds = gjk_bounds(a, b);
      } catch (const BeyondDoubles&) {
        return;
      }
      const double d = gjk_distance(a, b);
      EXPECT_LE(bounds.lower, d) << m.about();
      EXPECT_GE(bounds.upper, d) << m.about();
      EXPECT_NE(bounds.told, d > 0 ? GjkTold::meeting : GjkTold::disjoint) << m.about();
      disjoint += bounds.told == GjkTold::disjoint, meet += bounds.told == GjkTold::meeting;
      undecided += bounds.told == GjkTold::undecided;
      close += bounds.upper - bounds.lower <= 1e-9 * d;
    };
    check(m.below(3) == 0 ? pair_cases::regular_pose(m) : pair_cases::whole_pose(m));
    std::visit(check, pair_cases::rigid_case(m).space);
  });
  std::printf("%d disjoint, %d close, %d meet, %d undecided\n", disjoint, close, meet, undecided);
  EXPECT_GT(disjoint, battery::sanitized ? 2 : 15);
  EXPECT_GT(close, battery::sanitized ? 2 : 15);
  EXPECT_GT(undecided + meet, battery::sanitized ? 1 : 5);
}

TEST(SupportMappings, OfRoundFiguresKeepTheirDistanceUnderARigidPose) {
  const RigidPose turn{{3, 1, -2, 0.5}, {4, -5, 6}};
  const RigidChain chain{{turn, {{1, 0, 0, 1}, {0.25, 0, 0}}}};
  const Cylinder3 pipe{{0, 0, 0}, {1, 2, 4}, 1};
  const Cone3 cone{{0, 0, 9}, {0, 1, 6}, 2};
  const Sphere3 ball{{7, 0, 2}, 1};
  const auto expect = [&](const auto& a, const auto& b) {
    const GjkBounds plain = gjk_bounds(a, b, {.within = 1e-12});
    const auto under = [&](const auto& pose) {
      expect_of_one(gjk_bounds(Posed{a, pose}, Posed{b, pose}, {.within = 1e-12}), plain, 1e-11);
      const AnyFigure x = Posed{a, pose}, y = Posed{b, pose};
      const GjkBounds any = gjk_bounds(x, y, {.within = 1e-12});
      const GjkBounds of_kinds = gjk_bounds(Posed{a, pose}, Posed{b, pose}, {.within = 1e-12});
      EXPECT_EQ(any.lower, of_kinds.lower);
      EXPECT_EQ(any.upper, of_kinds.upper);
    };
    under(turn), under(chain);
  };
  expect(pipe, ball), expect(ball, cone), expect(pipe, cone);
}

TEST(SupportMappings, TellTheirRoundingWhereverCoordinatesAre) {
  const auto expect = [](double x) {
    const Point3 p{x, x / 2, 0};
    const bool is_last = x == std::numeric_limits<double>::max();
    const double gap = is_last ? x - std::nextafter(x, 0) : std::nextafter(x, HUGE_VAL) - x;
    const double of_point = FigureSupport3<Point3>(p).rounding();
    EXPECT_GE(of_point, gap * (std::sqrt(3) / 2)) << x;
    EXPECT_LE(of_point, gap * 4) << x;
    if (x > 0x1p1000) return;
    const Posed stays{p, identity_pose};
    const double of_image = FigureSupport3<Posed<Point3, Pose>>(stays).rounding();
    EXPECT_GE(of_image, of_point) << x;
    EXPECT_LE(of_image, gap * 256) << x;
  };
  for (int e = -1074; e <= 1023; ++e) expect(std::ldexp(1.0, e));
  expect(0), expect(std::numeric_limits<double>::max());
}

TEST(SupportMappings, RefusePosesThatAreNone) {
  const Cylinder3 pipe{{0, 0, 0}, {1, 2, 4}, 1};
  Pose pose = identity_pose;
  pose.columns[1].x = NAN;
  EXPECT_THAT(
      [&] {
        (void)gjk_bounds(Posed{pipe, pose}, Point3{9, 9, 9});
      },
      ThrowsMessage<NonFinite>(HasSubstr("support_point: pose.columns[1].x is nan")));
  pose.columns[1].x = 0x1p1023;
  EXPECT_THAT(
      [&] {
        (void)gjk_bounds(Posed{pipe, pose}, Point3{9, 9, 9});
      },
      ThrowsMessage<BeyondDoubles>(HasSubstr("beyond all doubles")));
}

TEST(SupportMappings, AreHeldToWhatTheyTold) {
  const Listed sound{{{0, 0, 0}, {1, 0, 0}}};
  int calls = 0;
  const auto nan_later = [&calls](const Vector3&) { return ++calls < 2 ? Point3{9, 1, 1} : Point3{9, NAN, 1}; };
  EXPECT_THAT(
      [&] { (void)gjk_bounds(nan_later, sound); },
      ThrowsMessage<NonFinite>(AllOf(HasSubstr("gjk_bounds: a tells"), HasSubstr("nan"), HasSubstr("direction"))));
  int turn = 0;  // tells ever nearer points
  const auto retreats = [&turn](const Vector3&) { return Point3{5.0 + ++turn, 3, 2}; };
  EXPECT_THAT([&] { (void)gjk_bounds(retreats, sound); },
              ThrowsMessage<InvalidShape>(HasSubstr("gjk_bounds: a contradicts itself")));
  EXPECT_THROW((void)gjk_bounds(sound, sound, {.rounding = -1}), InvalidShape);
  EXPECT_THROW((void)gjk_bounds(sound, sound, {.within = NAN}), NonFinite);
}

}  // namespace
}  // namespace plumb

// Penetration of bodies in every position to one another, of hulls by their vertices, of small ones in large ones,
// under poses; what is told of them by the numbers, and what is no body.
#include <gmock/gmock.h>

#include <cstdio>
#include <numbers>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/figure/generated/generated.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/query/penetration/penetration_bounds.hpp"
#include "query/penetration/told_checks.hpp"

namespace plumb {
namespace {

using namespace penetration_oracle;
using degenerate::Nearness, degenerate::PositionInfo;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Seen {
  int none = 0, touching = 0, deep = 0, several = 0, features = 0;
};

template <class A, class B>
void expect_as_brute_force(const A& a, const B& b, const std::string& about, Seen& seen) {
  const Round p = round_of(a), q = round_of(b);
  const auto wanted = expected(p, q);
  const auto told = penetration(a, b);
  ASSERT_EQ(told.has_value(), wanted.has_value()) << about;
  if (!wanted) {
    ++seen.none;
    return;
  }
  const auto exact = exact_penetration(a, b);
  EXPECT_EQ(told_checks::fault(*wanted, p, q, *told, *exact), "") << about;
  EXPECT_EQ(told_checks::fault_of_features(*wanted, p, q, query::body_view(a), query::body_view(b), told->feature_a,
                                           told->feature_b, seen.features),
            "")
      << about;
  EXPECT_EQ(told_checks::fault_of_move(*exact, p, q), "") << about;
  (told->depth == 0 ? seen.touching : seen.deep) += 1;
  seen.several += told->is_unique ? 0 : 1;
}

template <class A, class B>
void expect_in_positions(int cases, Seen& seen) {
  constexpr auto of_a = generated_kind<A>, of_b = generated_kind<B>;
  for (const PositionInfo& position : degenerate::positions) {
    if (!has_position<A, B>(position.position)) continue;
    for (int i = 0; i < cases; ++i) {
      Entropy entropy(77, static_cast<std::uint64_t>(i));
      const Nearness nearness = i % 2 == 0 ? Nearness::exactly : Nearness::nearly;
      const auto [a, b] = pair_from<A, B>(shape_pair(of_a, of_b, 3, position.position, nearness, entropy));
      const std::string about = std::string(position.name) + " " + std::to_string(i);
      expect_as_brute_force(a, b, about, seen);
    }
  }
}

TEST(PenetrationOfBodies, InEveryPosition) {
  const int few = battery::sanitized ? 1 : 6;
  Seen seen;
  expect_in_positions<Tetrahedron3, Tetrahedron3>(few, seen);
  expect_in_positions<Tetrahedron3, Triangle3>(few, seen);
  expect_in_positions<Triangle3, Triangle3>(few, seen);
  expect_in_positions<Obb3, Triangle3>(few / 3 + 1, seen);
  expect_in_positions<Aabb3, Tetrahedron3>(few / 3 + 1, seen);
  expect_in_positions<Sphere3, Triangle3>(few, seen);
  expect_in_positions<Capsule3, Capsule3>(few, seen);
  std::printf("none %d, touching %d, deep %d, several %d\n", seen.none, seen.touching, seen.deep, seen.several);
  EXPECT_GE(std::min({seen.none, seen.touching, seen.deep, seen.several}), battery::sanitized ? 2 : 20);
}

/// Of the size of this power of two, somewhere near to the origin.
std::vector<Point3> some_points(std::size_t count, int exponent, Entropy& entropy) {
  std::vector<Point3> points;
  const auto number = [&] { return std::ldexp(static_cast<double>(entropy.within(1 << 20)), exponent - 20); };
  for (std::size_t i = 0; i < count; ++i) points.push_back({number(), number(), number()});
  return points;
}

TEST(PenetrationOfBodies, OfHullsSmallAndLarge) {
  Seen seen;
  for (int i = 0; i < (battery::sanitized ? 4 : 60); ++i) {
    Entropy entropy(5, static_cast<std::uint64_t>(i));
    const int ratio = i % 4 == 0 ? 60 : i % 4 == 1 ? -60 : 0;
    const int scale = i % 6 == 5 ? -900 : i % 6 == 4 ? 800 : 0;  // where products of doubles end
    const auto p = some_points(3 + entropy.below(4), scale, entropy);
    auto q = some_points(1 + entropy.below(4), scale + ratio, entropy);
    if (i % 5 == 0) q.push_back(p[0]);
    if (i % 7 == 0) q.insert(q.end(), q.begin(), q.end() - 1);
    expect_as_brute_force(VertexHull3{p}, VertexHull3{q}, "hulls " + std::to_string(i), seen);
    expect_as_brute_force(VertexHull3{q}, VertexHull3{p}, "hulls turned " + std::to_string(i), seen);
  }
  std::printf("none %d, touching %d, deep %d, several %d\n", seen.none, seen.touching, seen.deep, seen.several);
  EXPECT_GE(std::min({seen.none, seen.touching, seen.deep}), battery::sanitized ? 0 : 4);
}

TEST(PenetrationOfBodies,
     OfLargerOnesByAllPolytopesAlike) {  // as a hull, as a polyhedron, and under a pose that does nothing
  for (const Cloud cloud : {Cloud::ball, Cloud::lattice, Cloud::exact_sphere, Cloud::facets}) {
    Entropy entropy(9, static_cast<std::uint64_t>(cloud));
    const auto p = cloud3(cloud, 64, entropy);
    auto q = cloud3(cloud, 40, entropy);
    for (Point3& x : q) x.x += 0.25;
    const ConvexPolyhedron3 a = convex_polyhedron(convex_hull(p), p), b = convex_polyhedron(convex_hull(q), q);
    const auto by_vertices = penetration(VertexHull3{p}, VertexHull3{q}), by_faces = penetration(a, b);
    const auto posed = penetration(Posed{a, identity_pose}, Posed{b, identity_pose});
    ASSERT_TRUE(by_vertices && by_faces && posed);
    EXPECT_EQ(*posed, *by_faces) << name_of(cloud);
    EXPECT_EQ(by_vertices->depth, by_faces->depth) << name_of(cloud);
    EXPECT_EQ(by_vertices->direction, by_faces->direction) << name_of(cloud);
    EXPECT_EQ(by_vertices->translation, by_faces->translation) << name_of(cloud);
    EXPECT_EQ(by_vertices->is_unique, by_faces->is_unique) << name_of(cloud);
    EXPECT_EQ(by_vertices->feature_a.kind, by_faces->feature_a.kind) << name_of(cloud);
  }
}

TEST(PenetrationOfBodies, ACommonPoseTurnsTheAnswer) {
  const Pose turn{{{{0, 2, 0}, {0, 0, 2}, {2, 0, 0}}}, {3, -5, 7}};  // x to y to z to x, twice as large
  int unique = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 5 : 60); ++i) {
    pair_cases::Material m(31, i);
    const auto a = pair_cases::figure<Tetrahedron3>(m);
    const auto b = pair_cases::near_figure<Triangle3>(m);
    const auto still = exact_penetration(a, b), turned = exact_penetration(Posed{a, turn}, Posed{b, turn});
    ASSERT_EQ(still.has_value(), turned.has_value()) << m.about(a, b);
    if (!still) continue;
    EXPECT_EQ(turned->core_square, still->core_square * Rational(4)) << m.about(a, b);
    EXPECT_EQ(turned->is_unique, still->is_unique) << m.about(a, b);
    if (!still->is_unique) continue;
    ++unique;
    const ExactVector3& u = still->direction;
    EXPECT_EQ(turned->direction, (ExactVector3{u.z, u.x, u.y})) << m.about(a, b);
    EXPECT_EQ(turned->feature_a, still->feature_a) << m.about(a, b);
    EXPECT_EQ(turned->feature_b, still->feature_b) << m.about(a, b);
  }
  EXPECT_GE(unique, battery::sanitized ? 0 : 5);
}

TEST(PenetrationOfBodies, UnderPosesThatAreNoRotations) {
  const Pose skew{{{{2, 1, 0}, {0, 3, 0.5}, {-1, 0, 0.1}}}, {0.125, -0.25, 0.3}},
      flat{{{{1, 0, 0}, {0, 1, 0}, {}}}, {}};
  Seen seen;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 4 : 40); ++i) {
    pair_cases::Material m(32, i);
    const auto a = pair_cases::figure<Tetrahedron3>(m);
    const auto b = pair_cases::near_figure<Triangle3>(m);
    expect_as_brute_force(Posed{a, skew}, Posed{b, skew}, m.about(a, b), seen);
    expect_as_brute_force(Posed{a, flat}, b, m.about(a, b), seen);
  }
  const Pose large{{{{0, 0x1p40, 0}, {0, 0, 0x1p40}, {0x1p40, 0, 0}}}, {1, 2, 3}};
  expect_as_brute_force(Posed{Sphere3{{1, 2, 3}, 0.75}, large}, Aabb3{{0, 0, 0}, {1, 1, 1}}, "a ball", seen);
  std::printf("none %d, touching %d, deep %d, several %d\n", seen.none, seen.touching, seen.deep, seen.several);
  EXPECT_GE(std::min({seen.none, seen.touching, seen.deep}), battery::sanitized ? 0 : 5);
}

TEST(PenetrationOfBodies, ByNumbers) {
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  const auto beside = penetration(box, Aabb3{{1.5, 0.25, 0.5}, {3.5, 3, 3}});
  EXPECT_EQ(*beside,
            (Penetration{0.5, {-1, 0, 0}, {-0.5, 0, 0}, {FeatureKind::face, 1}, {FeatureKind::face, 0}, true}));
  const auto itself = penetration(box, box);
  EXPECT_EQ(itself->depth, 2);
  EXPECT_EQ(itself->direction, (Vector3{-1, 0, 0}));
  EXPECT_FALSE(itself->is_unique);
  EXPECT_FALSE(penetration(box, Aabb3{{2.5, 0, 0}, {3, 1, 1}}));
  const Triangle3 triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(penetration(triangle, triangle)->direction, (Vector3{0, 0, -1}));  // flat bodies in one plane
  EXPECT_EQ(penetration(triangle, triangle)->depth, 0);
  EXPECT_EQ(penetration(Point3{}, Point3{})->direction, (Vector3{-1, 0, 0}));
  EXPECT_EQ(penetration(Sphere3{{0, 0, 0}, 1}, Sphere3{{0, 0, 0}, 2})->depth, 3);
  EXPECT_EQ(penetration(Sphere3{{0, 0, 0}, 1}, Sphere3{{2, 0, 0}, 1})->depth, 0);
  EXPECT_EQ(penetration(Sphere3{{0, 0, 0}, 1}, Sphere3{{2, 0, 0}, 1})->direction, (Vector3{-1, 0, 0}));
  EXPECT_EQ(exact_penetration(Sphere3{{0, 0, 0}, 1}, Sphere3{{1, 1, 0}, 1})->core_square, Rational(2));
}

TEST(PenetrationOfBodies, WhatIsNoBodyIsNamed) {
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}}, nothing{{1, 0, 0}, {0, 1, 1}};
  const std::vector<Point3> bad{{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}};
  EXPECT_THAT([&] { (void)penetration(box, VertexHull3{bad}); },
              ThrowsMessage<NonFinite>(HasSubstr("penetration: hull.vertices[2].y")));
  EXPECT_THAT([&] { (void)penetration(nothing, box); },
              ThrowsMessage<InvalidShape>(HasSubstr("penetration: a is empty")));
  EXPECT_THAT(
      [&] {
        (void)exact_penetration(box, Sphere3{{0, 0, 0}, -1});
      },
      ThrowsMessage<InvalidShape>(HasSubstr("exact_penetration: sphere.radius")));
  EXPECT_THROW(static_cast<void>(penetration(box, Polygon3{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}})),
               InvalidShape);
}

/// A prism of 24 sides in a cylinder of this radius around an axis of space, or around it.
std::vector<Point3> prism(const Cylinder3& c, bool is_around) {
  constexpr int sides = 24;
  const double radius =
      is_around ? c.radius / std::cos(std::numbers::pi / sides) * (1 + 1e-12) : c.radius * (1 - 1e-12);
  std::vector<Point3> corners;
  for (int i = 0; i < sides; ++i) {
    const double x = radius * std::cos(i * 2 * std::numbers::pi / sides),
                 y = radius * std::sin(i * 2 * std::numbers::pi / sides);
    corners.push_back({c.a.x + x, c.a.y + y, c.a.z}), corners.push_back({c.b.x + x, c.b.y + y, c.b.z});
  }
  return corners;
}

TEST(PenetrationOfBodies, ByFarthestPointsIsBetweenBounds) {
  int meet = 0, apart = 0, undecided = 0, near = 0;
  const auto expect_bounds = [&](const PenetrationBounds& p, const std::optional<Penetration>& exact,
                                 const std::string& about) {
    const double depth = exact ? exact->depth : 0;
    EXPECT_LE(p.lower, depth) << about;
    EXPECT_GE(p.upper, depth) << about;
    EXPECT_NE(p.told, exact ? GjkTold::disjoint : GjkTold::meeting) << about;
    near += exact && p.upper - p.lower <= depth * 0x1p-20;
    (p.told == GjkTold::meeting ? meet : p.told == GjkTold::disjoint ? apart : undecided) += 1;
  };
  for (std::uint64_t i = 0; i < (battery::sanitized ? 6 : 80); ++i) {
    pair_cases::Material m(77, i);
    const auto a = pair_cases::figure<Tetrahedron3>(m);
    const auto b = pair_cases::near_figure<Triangle3>(m);
    expect_bounds(penetration_bounds(a, b), penetration(a, b), m.about(a, b));
    const Capsule3 rod{a.a, a.b, std::ldexp(static_cast<double>(m.below(9)), -2)};
    expect_bounds(penetration_bounds(rod, b, {.most_steps = 12}), penetration(rod, b), m.about(rod, b));
  }
  std::printf("%d meet, %d apart, %d undecided; within a millionth %d\n", meet, apart, undecided, near);
  EXPECT_GE(std::min({meet, apart, near}), battery::sanitized ? 1 : 8);
}

TEST(PenetrationOfBodies, OfCylindersIsBetweenThatOfPrisms) {
  int deep = 0;
  for (int i = 0; i < (battery::sanitized ? 1 : 12); ++i) {
    Entropy entropy(21, static_cast<std::uint64_t>(i));
    const Cylinder3 c{{0, 0, 0}, {0, 0, 4}, 1};
    const auto points = some_points(6, 1, entropy);
    const VertexHull3 within{points};
    const ConvexPolyhedron3 solid = convex_polyhedron(convex_hull(points), points);
    const PenetrationBounds p = penetration(c, solid, {.within = 1e-6});
    const std::vector<Point3> inner = prism(c, false), outer = prism(c, true);
    const auto least = penetration(VertexHull3{inner}, within), most = penetration(VertexHull3{outer}, within);
    if (!most) {
      EXPECT_NE(p.told, GjkTold::meeting) << i;
      continue;
    }
    deep += p.told == GjkTold::meeting;
    EXPECT_LE(p.lower, most->depth) << i;
    EXPECT_GE(p.upper, least ? least->depth : 0) << i;
    EXPECT_LE(p.upper - p.lower, 1e-6) << i;
  }
  EXPECT_GE(deep, battery::sanitized ? 0 : 6);
  const Aabb3 box{{0.5, -1, 1}, {3, 1, 2}};
  const PenetrationBounds side = penetration(Cylinder3{{0, 0, 0}, {0, 0, 5}, 1}, box, {.within = 1e-12});
  EXPECT_EQ(side.told, GjkTold::meeting);
  EXPECT_LE(side.lower, 0.5);
  EXPECT_GE(side.upper, 0.5);
  EXPECT_LE(side.upper - side.lower, 1e-12);
  EXPECT_EQ(side.direction, (Vector3{-1, 0, 0}));
  const Ellipsoid3 egg{{1, 0, 1}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {3, 2, 1}};
  EXPECT_NEAR(penetration(egg, box, {.within = 1e-9}).upper, 1, 1e-9);
  EXPECT_EQ(penetration(egg, Aabb3{{9, 9, 9}, {10, 10, 10}}).told, GjkTold::disjoint);
  const Sphere3 ball{{0, 0, 0}, 1};
  const PenetrationBounds around = penetration_bounds(ball, ball, {.most_steps = 20});  // every direction is as short
  EXPECT_LE(around.lower, 2);
  EXPECT_GE(around.upper, 2);
  EXPECT_EQ(around.steps, 20U);
  EXPECT_THROW(static_cast<void>(penetration(egg, box, {.most_steps = 0})), InvalidShape);
  EXPECT_THROW(static_cast<void>(penetration(egg, box, {.within = -1})), InvalidShape);
  EXPECT_THAT(
      [&] {
        (void)penetration(Cylinder3{{0, 0, 0}, {0, 0, NAN}, 1}, box);
      },
      ThrowsMessage<NonFinite>(HasSubstr("cylinder.b.z")));
}

static_assert(QuadricBody3<Cone3> && !QuadricBody3<Sphere3> && !ConvexBody3<Cone3>);

}  // namespace
}  // namespace plumb

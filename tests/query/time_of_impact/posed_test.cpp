// Posed figures in motion: as the plain question tells it where poses stay or images are doubles, and alike under a common
// pose that moves the way as well.
#include "plumb/query/time_of_impact/posed.hpp"

#include <cmath>

#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct MotionSeen {
  int cases = 0, meet = 0, mapped = 0;
};

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) { return a == b; }

/// Of equal sets named alike: whether, when, and by which kinds of features.
bool alike(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return !a == !b;
  return a->time == b->time && a->feature_a.kind == b->feature_a.kind && a->feature_b.kind == b->feature_b.kind;
}

template <class A, class B>
void expect_motions(MotionSeen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 2 : 6, [&](Material& m) {
    const auto pair = pair_of<A, B>(m);
    const A& a = pair.first;
    const B& b = pair.second;
    const Vector3 by = m.vector3(), other{m.number(), 0, m.number()};
    const Translating moving{a, by};
    const auto plain = first_contact(moving, Translating{b, other});
    ++seen.cases, seen.meet += plain.has_value();
    const Translating stays{Posed{a, identity_pose}, by};
    EXPECT_TRUE(same(first_contact(stays, Translating{b, other}), plain)) << pair_name<A, B>() << m.about(a, b);
    EXPECT_EQ(intersects(stays, Translating{Posed{b, identity_pose}, other}), plain.has_value());
    Map map(m, 3, map_kind<A, B>(m), m.below(2) == 0);
    const Pose pose = pose_of(map);
    const A c = mapped(a, map);
    const B d = mapped(b, map);
    const Vector3 way = map.vector(by);
    if (!map.exact()) return;
    ++seen.mapped;
    const auto of_images = first_contact(Translating{c, way}, d);
    constexpr auto is_renamed = [](FigureKind k) {
      return query::is_one_of(k, {FigureKind::aabb, FigureKind::convex_polyhedron});
    };
    const auto posed = first_contact(Translating{Posed{a, pose}, way}, d), both = first_contact(moving, b);
    if constexpr (is_renamed(figure_kind<A>) || is_renamed(figure_kind<B>)) {  // corners that the map names anew
      EXPECT_TRUE(alike(posed, of_images)) << pair_name<A, B>() << m.about(a, b);
    } else {
      EXPECT_TRUE(same(posed, of_images)) << pair_name<A, B>() << m.about(a, b);
    }
    EXPECT_TRUE(same(first_contact(Translating{Posed{a, pose}, way}, Posed{b, pose}), both))
        << pair_name<A, B>() << m.about(a, b);
  });
}

template <class... Shapes>
void expect_all_motions(Types<Shapes...>, std::uint64_t start) {
  MotionSeen seen;
  const auto with = [&]<class A>(const A*) {
    const auto ask = [&]<class B>(const B*) {
      if constexpr (MovingPair<A, B> && figure_kind<A> <= figure_kind<B>) expect_motions<A, B>(seen, start++);
    };
    (ask(static_cast<const Shapes*>(nullptr)), ...);
  };
  (with(static_cast<const Shapes*>(nullptr)), ...);
  std::printf("%d cases, %d meet, %d mapped\n", seen.cases, seen.meet, seen.mapped);
  EXPECT_GT(seen.meet * 4, seen.cases);
  EXPECT_GT(seen.mapped * 3, seen.cases);
}

TEST(PosedMotion, AllPairs) {
  expect_all_motions(Types<Point3, Segment3, Plane3, Triangle3, Sphere3, Aabb3, Obb3, Capsule3, ConvexPolyhedron3>{},
                     3101);
}

/// Figures of the plane: their times are those of before under poses that stay, and alike under a common one.
template <class A, class B>
void expect_flat_motions(MotionSeen& seen, std::uint64_t start) {
  constexpr Pose2 stays{{{{1, 0}, {0, 1}}}, {0, 0}}, turned{{{{6, 8}, {-8, 6}}}, {1, -3}};
  shape_cases::on_shapes(start, battery::sanitized ? 2 : 6, [&](Material& m) {
    const auto pair = pair_of<A, B>(m);
    const A& a = pair.first;
    const B& b = pair.second;
    const Vector2 by = m.vector2();
    const auto plain = first_contact(Translating<A>{a, by}, b);
    ++seen.cases, seen.meet += plain.has_value();
    const Translating<Posed<A, Pose2>> moving{{a, stays}, by};
    EXPECT_TRUE(same(first_contact(moving, b), plain)) << pair_name<A, B>() << m.about(a, b);
    EXPECT_EQ(intersects(moving, Posed{b, stays}), plain.has_value()) << pair_name<A, B>() << m.about(a, b);
    const Vector2 way{6 * by.x - 8 * by.y, 8 * by.x + 6 * by.y};
    if (std::fabs(by.x) > 1e6 || std::fabs(by.y) > 1e6 || by.x != std::rint(by.x) || by.y != std::rint(by.y)) return;
    ++seen.mapped;
    const Translating<Posed<A, Pose2>> both{{a, turned}, way};
    EXPECT_TRUE(same(first_contact(both, Posed{b, turned}), plain)) << pair_name<A, B>() << m.about(a, b);
  });
}
template <class A, class... Bs>
void expect_flat_row(Types<Bs...>, MotionSeen& seen, std::uint64_t start) {
  (expect_flat_motions<A, Bs>(seen, start++), ...);
}

TEST(PosedMotion, PairsOfThePlane) {
  MotionSeen seen;
  expect_flat_row<Triangle2>(Types<Point2, Segment2, Triangle2, Aabb2, Obb2, Circle2, Capsule2>{}, seen, 3301);
  expect_flat_row<Circle2>(Types<Point2, Segment2, Aabb2, Obb2, Circle2, Capsule2>{}, seen, 3321);
  expect_flat_row<Polygon2>(Types<Segment2, Triangle2, Circle2, Polygon2>{}, seen, 3341);
  expect_flat_row<Obb2>(Types<Obb2, HoledPolygon2>{}, seen, 3361);
  std::printf("%d cases, %d meet, %d mapped\n", seen.cases, seen.meet, seen.mapped);
  EXPECT_GT(seen.meet * 4, seen.cases);
  EXPECT_GT(seen.mapped * 8, seen.cases);
}

TEST(PosedMotion, WhatIsFlattenedMeetsAsAFlatFigure) {
  const Pose flatten{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 2}};
  const Posed square{Aabb3{{0, 0, -5}, {2, 3, 5}}, flatten};
  const auto met = first_contact(Translating{Point3{1, 1, 0}, {0, 0, 4}}, square);
  ASSERT_TRUE(met);
  EXPECT_EQ(met->time, 0.5);
  EXPECT_EQ(met->feature_b.kind, FeatureKind::face);
  EXPECT_FALSE(first_contact(Translating{Point3{3, 1, 0}, {0, 0, 4}}, square));
}

TEST(PosedMotion, WhatIsNotAnsweredSaysSo) {
  const Pose sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 0}}, twice{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {}};
  const Sphere3 ball{{0, 0, 0}, 1};
  EXPECT_THROW(first_contact(Translating{Posed{ball, sheared}, {1, 0, 0}}, Point3{9, 0, 0}), UnevenPose);
  EXPECT_THROW(first_contact(Translating{Posed{Plane3{{1, 0, 0}, 1}, Pose{}}, {1, 0, 0}}, Point3{9, 0, 0}), UnevenPose);
  EXPECT_EQ(first_contact(Translating{Posed{ball, twice}, {14, 0, 0}}, Point3{9, 0, 0})->time, 0.5);
  const Pose2 slanted{{{{1, 0}, {1, 1}}}, {0, 0}};
  EXPECT_THROW(first_contact(Posed{Circle2{{0, 0}, 1}, slanted}, Translating<Point2>{{9, 0}, {-9, 0}}), UnevenPose);
  const Posed<Aabb2, Pose2> bad{{{0, 0}, {1, std::nan("")}}, slanted};
  EXPECT_THROW(first_contact(bad, Translating<Point2>{{9, 0}, {-9, 0}}), NonFinite);
  EXPECT_THROW(first_contact(Posed{Point2{}, slanted}, Translating<Point2>{{9, 0}, {std::nan(""), 0}}), NonFinite);
}

}  // namespace
}  // namespace plumb::pair_cases

// What posed figures have in common: as the plain question tells it where poses stay or images are doubles, and the
// image of the common part under a common pose.
#include "plumb/query/section/posed.hpp"

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_types.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

template <class Answer>
Answer ask(const query::PosedView& a, const query::PosedView& b) {
  if constexpr (std::is_same_v<Answer, Intersection2>) {
    return query::posed_intersection2(a, b);
  } else if constexpr (std::is_same_v<Answer, SolidIntersection3>) {
    return query::posed_solid(a, b);
  } else {
    return query::posed_intersection3(a, b);
  }
}
query::PosedView by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space} : query::PosedView{v, &flat};
}

/// The same kind and the same number of corners under a common pose, which maps corners to corners.
template <class Answer>
bool is_told_alike(const query::FigureView& a, const query::FigureView& b, const Pose& pose, const Answer& plain) {
  const Pose2 flat = in_plane(pose);
  const Pose2 stays{{{{1, 0}, {0, 1}}}, {0, 0}};
  const Answer moved = ask<Answer>(by(a, pose, flat), by(b, pose, flat));
  return ask<Answer>(by(a, identity_pose, stays), {b}) == plain &&
         ask<Answer>({b}, by(a, identity_pose, stays)) == plain && moved.kind == plain.kind &&
         moved.vertices.size() == plain.vertices.size();
}

struct SectionSeen {
  int cases = 0, met = 0, mapped = 0;
};

template <class A, class B>
void expect_sections(SectionSeen& seen, std::uint64_t start) {
  using PosedA = Posed<A, std::conditional_t<figure_dimension<A> == 2, Pose2, Pose>>;
  if constexpr (query::PosedSection<PosedA, B> || query::PosedSolids<PosedA, B>) {
    const bool is_costly = pair_cases::is_costly(figure_kind<A>) || pair_cases::is_costly(figure_kind<B>);
    shape_cases::on_shapes(start, battery::sanitized || is_costly ? 3 : 10, [&](Material& m) {
      const auto pair = pair_of<A, B>(m);
      const A& a = pair.first;
      const B& b = pair.second;
      using Answer = decltype(intersection(a, b));
      if constexpr (figure_kind<A> == FigureKind::polygon || figure_kind<B> == FigureKind::polygon) {
        try {
          (void)intersection(a, b);
        } catch (const InvalidShape&) {
          EXPECT_THROW(ask<Answer>({query::view_of(a)}, {query::view_of(b)}), InvalidShape);
          return;
        }
      }
      const Answer plain = intersection(a, b);
      ++seen.cases, seen.met += !plain.empty();
      EXPECT_TRUE(is_told_alike(query::view_of(a), query::view_of(b), regular_pose(m), plain))
          << pair_name<A, B>() << m.about(a, b);
      Map map(m, figure_dimension<A>, map_kind<A, B>(m), m.below(2) == 0);
      const Pose pose = pose_of(map);
      const A c = mapped(a, map);
      const B d = mapped(b, map);
      if (!map.exact()) return;
      ++seen.mapped;
      const Pose2 flat = in_plane(pose);
      const auto expected = intersection(c, d);
      EXPECT_EQ(
          ask<std::remove_cvref_t<decltype(plain)>>(by(query::view_of(a), pose, flat), {query::view_of(d)}) == expected,
          true)
          << pair_name<A, B>() << m.about(a, b);
    });
  }
}

template <class All>
void expect_all_sections(std::uint64_t start) {
  SectionSeen seen;
  on_pairs(All{}, [&]<class A, class B>(const A*, const B*) { expect_sections<A, B>(seen, start++); });
  std::printf("%d cases, %d meet, %d mapped\n", seen.cases, seen.met, seen.mapped);
  EXPECT_GT(seen.met * 4, seen.cases);
  EXPECT_GT(seen.mapped * 3, seen.cases);
}

TEST(PosedSection, AllPairsOfThePlane) { expect_all_sections<Plane>(2101); }
TEST(PosedSection, AllPairsOfSpace) { expect_all_sections<Space>(2301); }

TEST(PosedSection, SolidsUnderPosesHaveTheVolumeOfTheirImages) {
  const Pose sheared{{{{2, 0, 0}, {1, 1, 0}, {0.5, 0.25, 3}}}, {1, 2, 3}},
      flat{{{{1, 0, 0}, {0, 1, 0}, {}}}, {0, 0, 1}};
  const Aabb3 box{{0, 0, 0}, {4, 4, 4}}, other{{1, 1, 1}, {5, 3, 9}};
  const SolidIntersection3 plain = intersection(box, other),
                           moved = intersection(Posed{box, sheared}, Posed{other, sheared});
  EXPECT_EQ(volume(plain), 3 * 2 * 3);
  EXPECT_EQ(volume(moved), 3 * 2 * 3 * 6);  // times the determinant
  EXPECT_EQ(moved.faces(), plain.faces());
  EXPECT_EQ(intersection(Posed{box, flat}, other), intersection(Aabb3{{0, 0, 1}, {4, 4, 1}}, other));
  EXPECT_TRUE(intersection(Posed{box, flat}, Tetrahedron3{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}}).empty());
  const Polygon3 square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  EXPECT_EQ(intersection(Posed{square, sheared}, Posed{Plane3{{1, 0, 0}, 1}, sheared}).kind, IntersectionKind::segment);
}

TEST(PosedSection, WhatIsFlattenedIsCutAsAFlatFigure) {
  const Pose flatten{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 2}};
  const Aabb3 box{{0, 0, -5}, {2, 3, 5}};
  const Intersection3 square = intersection(Posed{box, flatten}, Triangle3{{-9, -9, 2}, {9, -9, 2}, {0, 30, 2}});
  EXPECT_EQ(square, intersection(Aabb3{{0, 0, 2}, {2, 3, 2}}, Triangle3{{-9, -9, 2}, {9, -9, 2}, {0, 30, 2}}));
  const Intersection3 across = intersection(Line3{{1, 1, 0}, {0, 0, 1}}, Posed{box, flatten});
  ASSERT_EQ(across.kind, IntersectionKind::point);
  EXPECT_EQ(approximate(across)[0], (Point3{1, 1, 2}));
}

bool same(const FlatIntersection& a, const FlatIntersection& b) {
  return a.kind == b.kind && a.point == b.point && a.directions == b.directions;
}
ThreePointPlane3 image_of(const ThreePointPlane3& plane, const Pose& pose) {
  const auto at = [&](const Point3& p) { return rounded_image(pose, p); };
  return {at(plane.a), at(plane.b), at(plane.c)};
}

// What two planes have in common is told by the one reduced form of its equations: equal sets are equal answers.
TEST(PosedSection, OfPlanesIsThatOfTheirImages) {
  std::array<int, 5> seen{};
  shape_cases::on_shapes(2601, 400, [&](Material& m) {
    const auto n = [&] { return static_cast<double>(m.below(5)) - 2; };
    const auto drawn = [&] { return ThreePointPlane3{{n(), n(), n()}, {n(), n(), n()}, {n(), n(), n()}}; };
    const ThreePointPlane3 a = drawn(), b = m.below(3) == 0 ? a : drawn();
    const Pose p = whole_pose(m), q = m.below(2) == 0 ? p : whole_pose(m);
    const FlatIntersection common = intersection(Posed{a, p}, Posed{b, q});
    ++seen[static_cast<std::size_t>(static_cast<int>(common.kind) + 1)];
    EXPECT_TRUE(same(common, intersection(image_of(a, p), image_of(b, q)))) << m.about(a, b);
    EXPECT_TRUE(same(common, intersection(Posed{b, q}, Posed{a, p}))) << m.about(a, b);
    EXPECT_TRUE(same(intersection(Posed{a, identity_pose}, b), intersection(a, b))) << m.about(a, b);
    EXPECT_TRUE(same(std::get<FlatIntersection>(intersection(plumb::AnyFigure(Posed{a, p}), Posed{b, q})), common))
        << m.about(a, b);
    const double at = n();
    const Plane3 level{{0, 0, 1}, at};
    EXPECT_TRUE(same(intersection(Posed{level, p}, b),
                     intersection(Posed{ThreePointPlane3{{0, 0, at}, {1, 0, at}, {0, 1, at}}, p}, b)))
        << m.about(a, b);
  });
  for (std::size_t k = 0; k < 4; ++k) EXPECT_GT(seen[k], 1) << k;
  const Plane3 all{{0, 0, 0}, 0}, none{{0, 0, 0}, 1}, wall{{2, 0, 0}, 6};
  const RigidPose turn{{1, 0, 0, 1}, {1, 2, 3}};
  EXPECT_EQ(intersection(Posed{all, turn}, Posed{all, turn}).kind, FlatKind::space);
  EXPECT_TRUE(same(intersection(Posed{all, turn}, wall), intersection(wall, wall)));
  EXPECT_EQ(intersection(Posed{none, turn}, all).kind, FlatKind::nothing);
  const FlatIntersection line = intersection(Posed{wall, turn}, Plane3{{1, 0, 0}, 4});  // y = 3 + 2
  EXPECT_TRUE(same(line, intersection(Plane3{{0, 1, 0}, 5}, Plane3{{1, 0, 0}, 4})));
}

}  // namespace
}  // namespace plumb::pair_cases

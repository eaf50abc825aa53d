// Posed figures in posed figures: as the plain question tells it where poses stay or images are doubles, alike under a
// common pose, and as the outer one's answers about the inner one's corners.
#include "plumb/query/convex/containment.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/convex/posed_set.hpp"

namespace plumb::pair_cases {
namespace {

struct HeldSeen {
  int cases = 0, held = 0;
};

query::PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space} : query::PosedView{v, &flat};
}

/// Often within the other: grown a little.
template <class Shape>
Shape grown(Shape s, Material& m) {
  if (m.below(3) != 0) return s;
  if constexpr (requires { s.radius; }) {
    s.radius += m.radius();
  } else if constexpr (requires { s.directions; }) {
    for (double& x : s.max) x += m.radius();
  } else {
    s.max.x += m.radius(), s.max.y += m.radius();
  }
  return s;
}

template <class Shape>
void expect_held(HeldSeen& seen, std::uint64_t start) {
  using By = std::conditional_t<figure_dimension<Shape> == 2, Pose2, Pose>;
  static_assert(query::PosedHolder<Posed<Shape, By>, Shape>);
  shape_cases::on_shapes(start, battery::sanitized ? 10 : 60, [&](Material& m) {
    const Shape inner = figure<Shape>(m), outer = m.below(2) == 0 ? grown(inner, m) : near_figure<Shape>(m);
    const bool plain = contains(outer, inner);
    ++seen.cases, seen.held += plain;
    const Pose pose = regular_pose(m);
    const Pose2 flat = in_plane(pose), stays{{{{1, 0}, {0, 1}}}, {0, 0}};
    const query::FigureView o = query::view_of(outer), i = query::view_of(inner);
    EXPECT_EQ(query::posed_contains(posed_by(o, identity_pose, stays), {i}), plain) << m.about(outer, inner);
    EXPECT_EQ(query::posed_contains({o}, posed_by(i, identity_pose, stays)), plain) << m.about(outer, inner);
    EXPECT_EQ(query::posed_contains(posed_by(o, pose, flat), posed_by(i, pose, flat)), plain) << m.about(outer, inner);
  });
}

TEST(PosedContains, BoundsOfOneKindAsWithoutPoses) {
  HeldSeen seen;
  expect_held<Aabb2>(seen, 6101);
  expect_held<Circle2>(seen, 6102);
  expect_held<KDop2>(seen, 6103);
  expect_held<Aabb3>(seen, 6104);
  expect_held<Sphere3>(seen, 6105);
  expect_held<Capsule3>(seen, 6106);
  expect_held<Lozenge3>(seen, 6107);
  expect_held<KDop3>(seen, 6108);
  std::printf("%d cases, %d held\n", seen.cases, seen.held);
  EXPECT_GT(seen.held * 5, seen.cases);
  EXPECT_GT((seen.cases - seen.held) * 5, seen.cases);
}

// A convex set holds a tetrahedron where it holds its corners.
TEST(PosedContains, TetrahedraByTheirCorners) {
  int held = 0, all = 0;
  shape_cases::on_shapes(6201, battery::sanitized ? 40 : 150, [&](Material& m) {
    const Pose pose = whole_pose(m), other = m.below(2) == 0 ? pose : whole_pose(m);
    const auto corner = [&] {
      return Point3{static_cast<double>(m.below(5)) - 2, static_cast<double>(m.below(5)) - 2,
                    static_cast<double>(m.below(5)) - 2};
    };
    const Tetrahedron3 t{corner(), corner(), corner(), corner()};
    const auto expect = [&](const auto& shape) {
      bool corners = true;
      for (const Point3& p : {t.a, t.b, t.c, t.d}) corners = corners && contains(Posed{shape, pose}, Posed{p, other});
      ++all, held += corners;
      const query::PosedView outer{query::view_of(shape), &pose}, inner{query::view_of(t), &other};
      EXPECT_EQ(query::posed_contains(outer, inner), corners) << m.about(t);
    };
    expect(Aabb3{{-2, -2, -2}, {2, 2, 1}});
    expect(Sphere3{{0, 0, 0}, 3});
    expect(Capsule3{{-1, 0, 0}, {1, 0, 0}, 2});
  });
  EXPECT_GT(held * 10, all);
  EXPECT_GT((all - held) * 10, all);
}

// A ball is in a box where its image's extents are: of a sheared one the root of the sum of squares of a row.
TEST(PosedContains, EllipsoidsInBoxes) {
  const Pose pose{{{{3, 0, 0}, {4, 1, 0}, {0, 0, 2}}}, {1, 0, 0}};  // x up to 1 + 5, y up to 1, z up to 2
  const Posed ellipsoid{Sphere3{{0, 0, 0}, 1}, pose};
  const auto held = [&](const Aabb3& box) {
    const Pose stays = identity_pose;
    return query::posed_contains({query::view_of(box), &stays}, {query::view_of(ellipsoid.shape), &ellipsoid.pose});
  };
  EXPECT_TRUE(held({{-4, -1, -2}, {6, 1, 2}}));
  EXPECT_FALSE(held({{-4, -1, -2}, {0x1.7ffffffffffffp+2, 1, 2}}));
  EXPECT_FALSE(held({{-0x1.fffffffffffffp+1, -1, -2}, {6, 1, 2}}));
}

/// Nothing where the outer one or the pair is refused.
std::optional<bool> told(const query::PosedView& outer, const query::PosedView& inner) {
  try {
    if (outer.pose.stands() && inner.pose.stands()) return query::holds(outer.figure, inner.figure);
    return query::posed_contains(outer, inner);
  } catch (const InvalidShape&) {
    return {};
  } catch (const UnevenPose&) {
    return {};
  }
}

/// By each of the corners that the inner one is the hull of, nothing where they are no doubles or it has others.
std::optional<bool> told_of_corners(const query::PosedView& outer, const query::PosedView& inner) {
  const query::PosedSet s = query::posed_set(inner);
  const query::FlatSet& core = s.core;
  if (core.points.empty() || s.is_round() || s.has_axis() || !core.directions.empty() || !core.lines.empty()) return {};
  bool all = true;
  for (const query::Exact3& p : core.points) {
    const Point3 corner{p[0].get_d(), p[1].get_d(), p[2].get_d()};
    if (corner.x != p[0] || corner.y != p[1] || corner.z != p[2]) return {};
    const Point2 flat{corner.x, corner.y};
    const query::FigureView view = inner.figure.dimension == 2 ? query::view_of(flat) : query::view_of(corner);
    all = all && query::relate_posed("contains", outer, {view, inner.pose}) != Relation::disjoint;
  }
  return all;
}

template <class... Shapes>
std::vector<const FigureRow*> rows_of(Types<Shapes...>) {
  return {&figure_row(figure_kind<Shapes>, figure_dimension<Shapes>)...};
}

/// Under a common singular pose: what was held is held, and corners tell of their hull.
void expect_flattened(Material& m, const AnyFigure& a, const AnyFigure& b, std::optional<bool> plain, HeldSeen& seen) {
  const Pose pose = singular_pose(m);
  const Pose2 flat = singular_pose2(m);
  const query::PosedView outer = posed_by(a.view(), pose, flat), inner = posed_by(b.view(), pose, flat);
  const auto held = told(outer, inner);
  if (!held) return;
  ++seen.cases, seen.held += *held;
  EXPECT_LE(plain.value_or(false), *held) << about(m, a, b);
  EXPECT_EQ(told_of_corners(outer, inner).value_or(*held), *held) << about(m, a, b);
}

/// Each that is asked without poses: one that stays, a common pose, and images on one side.
template <class All>
void expect_all_held(std::uint64_t start) {
  HeldSeen seen, flattened;
  int mapped_cases = 0;
  const auto rows = rows_of(All{});
  for (const FigureRow* outer : rows) {
    for (const FigureRow* inner : rows) {
      if (!query::answers_containment(outer->kind, inner->kind) ||
          !query::contains_pairs.answers(outer->kind, inner->kind, outer->dimension))
        continue;
      shape_cases::on_shapes(start++, battery::sanitized ? 1 : 4, [&](Material& m) {
        const AnyFigure a = figure(*outer, m), b = near_figure(*inner, m);
        const Pose pose = regular_pose(m);
        const Pose2 flat = in_plane(pose), stays{{{{1, 0}, {0, 1}}}, {0, 0}};
        const auto plain = told({a.view()}, {b.view()});
        if (m.below(4) == 0) expect_flattened(m, a, b, plain, flattened);
        ++seen.cases, seen.held += plain.value_or(false);
        const std::string name = std::string(name_of(outer->kind)).append(" of ").append(name_of(inner->kind));
        EXPECT_EQ(told(posed_by(a.view(), identity_pose, stays), {b.view()}), plain) << name << about(m, a, b);
        EXPECT_EQ(told(posed_by(a.view(), pose, flat), posed_by(b.view(), pose, flat)), plain)
            << name << about(m, a, b);
        Map map(m, outer->dimension, map_kind(outer->kind, inner->kind, m), m.below(2) == 0);
        const Pose exact = pose_of(map);
        const Pose2 exact2 = in_plane(exact);
        const AnyFigure c = mapped(a, map), d = mapped(b, map);
        if (!map.exact()) return;
        ++mapped_cases;
        EXPECT_EQ(told(posed_by(a.view(), exact, exact2), {d.view()}), plain) << name << about(m, a, b);
        EXPECT_EQ(told({c.view()}, posed_by(b.view(), exact, exact2)), plain) << name << about(m, a, b);
      });
    }
  }
  std::printf("%d cases, %d held, %d mapped; %d flattened, %d held\n", seen.cases, seen.held, mapped_cases,
              flattened.cases, flattened.held);
  EXPECT_GT(flattened.cases * 10, seen.cases);
  EXPECT_GT(flattened.held * 10, flattened.cases);
  EXPECT_GT((flattened.cases - flattened.held) * 10, flattened.cases);
  EXPECT_GT(seen.held * 20, seen.cases);
  EXPECT_GT(mapped_cases * 3, seen.cases);
}

TEST(PosedContains, AllFiguresOfThePlane) { expect_all_held<Plane>(6301); }
TEST(PosedContains, AllFiguresOfSpace) { expect_all_held<Space>(6501); }

// A can that is sheared along x by its height, in boxes; a ball in a can that is sheared alike, and in one that is not.
TEST(PosedContains, CansAsWhatHoldsAndIsHeld) {
  const Pose sheared{{{{1, 0, 0}, {0, 1, 0}, {1, 0, 1}}}, {0, 0, 0}}, twice{{{{2, 0, 0}, {0, 0, 2}, {0, 2, 0}}}, {}};
  const Posed can{Cylinder3{{0, 0, 0}, {0, 0, 4}, 1}, sheared};
  EXPECT_TRUE(contains(Aabb3{{-1, -1, 0}, {5, 1, 4}}, can));
  EXPECT_FALSE(contains(Aabb3{{-1, -1, 0}, {0x1.3ffffffffffffp+2, 1, 4}}, can));
  EXPECT_FALSE(contains(Aabb3{{-1, -0x1.fffffffffffffp-1, 0}, {5, 1, 4}}, can));
  EXPECT_TRUE(contains(Aabb3{{-4, -1, 0}, {4, 1, 4}}, Posed{Cone3{{0, 0, 4}, {0, 0, 0}, 1}, sheared}));
  EXPECT_TRUE(contains(can, Segment3{{1, 0, 0}, {5, 0, 4}}));
  EXPECT_FALSE(contains(can, Segment3{{1, 0, 0}, {0x1.4000000000001p+2, 0, 4}}));
  EXPECT_FALSE(contains(can, Ray3{{0, 0, 0}, {1, 0, 1}}));
  EXPECT_TRUE(contains(can, Posed{Sphere3{{0, 0, 1}, 1}, sheared}));
  EXPECT_FALSE(contains(can, Posed{Sphere3{{0, 0, 0x1.fffffffffffffp-1}, 1}, sheared}));
  EXPECT_THROW(contains(can, Sphere3{{2, 0, 2}, 0.25}), UnevenPose);
  // From its center the rim of the can is 3 and 4 away, twice that as it is posed.
  EXPECT_TRUE(contains(Sphere3{{0, 4, 0}, 10}, Posed{Cylinder3{{0, 0, -2}, {0, 0, 6}, 3}, twice}));
  EXPECT_FALSE(contains(Sphere3{{0, 4, 0}, 0x1.3ffffffffffffp+3}, Posed{Cylinder3{{0, 0, -2}, {0, 0, 6}, 3}, twice}));
  // A cap whose circle has the radius 4, at the height -3.
  const Posed cap{SphericalCap3{{{0, 0, 0}, 5}, {{0, 0, 1}, -3}}, sheared};
  EXPECT_TRUE(contains(cap, Point3{1, 0, -3}));
  EXPECT_FALSE(contains(cap, Point3{0x1.0000000000001p+0, 0, -3}));
  EXPECT_EQ(relate(cap, Segment3{{1, 0, -3}, {9, 0, 9}}), Relation::touching);
  EXPECT_EQ(relate(cap, Posed{Sphere3{{7, 0, 1}, 5}, sheared}), Relation::touching);
  EXPECT_THROW(relate(cap, Sphere3{{7, 0, 1}, 5}), UnevenPose);
  // A square's plane under a shear, and what is a little beside it.
  const Posed square{Polygon3{{{0, 0, 0}, {4, 0, 4}, {4, 4, 4}, {0, 4, 0}}}, sheared};
  EXPECT_TRUE(contains(square, Segment3{{0, 1, 0}, {8, 4, 4}}));
  EXPECT_FALSE(contains(square, Segment3{{0, 1, 0}, {8, 4, 0x1.0000000000001p+2}}));
  EXPECT_THROW(contains(Posed{Polygon2{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, Pose2{{{{1, 0}, {0, 1}}}, {}}},
                        Segment2{{1, 0}, {0, 1}}),
               InvalidShape);
}

}  // namespace
}  // namespace plumb::pair_cases

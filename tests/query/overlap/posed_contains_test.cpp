// Posed figures in posed figures: as the plain question tells it where poses stay or images are doubles, alike under a
// common pose, and as the outer one's answers about the inner one's corners.
#include "plumb/query/overlap/posed.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct HeldSeen {
  int cases = 0, held = 0;
};

query::PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space, nullptr} : query::PosedView{v, nullptr, &flat};
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
      const query::PosedView outer{query::view_of(shape), &pose, nullptr}, inner{query::view_of(t), &other, nullptr};
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
    return query::posed_contains({query::view_of(box), &stays, nullptr},
                                 {query::view_of(ellipsoid.shape), &ellipsoid.pose, nullptr});
  };
  EXPECT_TRUE(held({{-4, -1, -2}, {6, 1, 2}}));
  EXPECT_FALSE(held({{-4, -1, -2}, {0x1.7ffffffffffffp+2, 1, 2}}));
  EXPECT_FALSE(held({{-0x1.fffffffffffffp+1, -1, -2}, {6, 1, 2}}));
}

}  // namespace
}  // namespace plumb::pair_cases

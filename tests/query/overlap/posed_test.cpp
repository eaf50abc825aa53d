// Posed figures, in every pair of the table: one that stays put, a common pose, and exact images on one side change no
// answer; what a singular pose flattens is the flat figure that it becomes.
#include "plumb/query/overlap/posed.hpp"

#include "figure/basic/thrown.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

using query::PosedView;

struct PosedSeen {
  int cases = 0, moved = 0;
  Answers answers;
};

PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& in_plane) {
  return v.dimension == 3 ? PosedView{v, &in_space} : PosedView{v, &in_plane};
}

constexpr Pose2 identity_pose2{{{{1, 0}, {0, 1}}}, {0, 0}};

/// Is the relation another one: bit 0; is it another answer whether they meet: bit 1.
int broken_of(const std::array<PosedView, 2>& pair, Relation expected) {
  const auto& [a, b] = pair;
  const bool meets = query::relate_posed("intersects", a, b) != Relation::disjoint;
  return (query::relate_posed("relate", a, b) != expected ? 1 : 0) |
         (meets != (expected != Relation::disjoint) ? 2 : 0);
}

/// Which of the laws fails: two bits each.  Without the types, so that it is compiled once.
int broken(const query::FigureView& a, const query::FigureView& b, const Pose& pose, Relation expected) {
  const Pose2 flat = in_plane(pose);
  const auto stays = [](const query::FigureView& v) { return posed_by(v, identity_pose, identity_pose2); };
  const auto by = [&](const query::FigureView& v) { return posed_by(v, pose, flat); };
  return broken_of({stays(a), PosedView{b}}, expected) | broken_of({PosedView{b}, stays(a)}, expected) << 2 |
         broken_of({by(a), by(b)}, expected) << 4 | broken_of({by(b), by(a)}, expected) << 6;
}

int broken_maps(const query::FigureView& a, const query::FigureView& a_image, const query::FigureView& b,
                const query::FigureView& b_image, const Pose& pose, Relation expected) {
  const Pose2 flat = in_plane(pose);
  return broken_of({posed_by(a, pose, flat), PosedView{b_image}}, expected) |
         broken_of({PosedView{a_image}, posed_by(b, pose, flat)}, expected) << 2;
}

void expect_posed_laws(const PairRow& pair, PosedSeen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 1 : 3, [&](Material& m) {
    const AnyPair drawn = pair_of(pair, m);
    const AnyFigure &a = drawn.a, &b = drawn.b;
    const Relation r = relate(pair, a, b);
    const auto name = [&] { return pair.name() + about(m, a, b); };
    ++seen.cases;
    seen.answers.add(r);
    const Pose pose = regular_pose(m);
    EXPECT_EQ(broken(a.view(), b.view(), pose, r), 0) << name();
    const MapKind kind = map_kind(a.row().kind, b.row().kind, m);
    Map map(m, pair.dimension(), kind, m.below(2) == 0);
    const Pose exact = pose_of(map);
    const AnyFigure c = mapped(a, map), d = mapped(b, map);
    if (!map.exact()) return;
    ++seen.moved;
    EXPECT_EQ(broken_maps(a.view(), c.view(), b.view(), d.view(), exact, r), 0) << name() << " to" << about(m, c, d);
  });
}

template <class All>
void expect_posed_laws_of_all(std::uint64_t start) {
  PosedSeen seen;
  for (const PairRow& pair : pairs_of(All{})) {
    if (pair.is_posed) expect_posed_laws(pair, seen, start++);
  }
  std::printf("%d cases, %d mapped; disjoint %d, touching %d, overlapping %d\n", seen.cases, seen.moved,
              seen.answers.of(Relation::disjoint), seen.answers.of(Relation::touching),
              seen.answers.of(Relation::overlapping));
  EXPECT_GT(seen.moved * 3, seen.cases);
  EXPECT_GT(seen.answers.of(Relation::touching) * 20, seen.cases);
}

TEST(PosedOverlap, LawsHoldForAllPairsOfThePlane) { expect_posed_laws_of_all<Plane>(801); }
TEST(PosedOverlap, LawsHoldForAllPairsOfSpace) { expect_posed_laws_of_all<Space>(1201); }

double small(Material& m) { return static_cast<double>(m.below(7)) - 3; }
Point3 small_point(Material& m) { return {small(m), small(m), small(m)}; }

/// The image of whole numbers, exact in doubles.
Point3 moved(const Point3& p, const Pose& pose) {
  const auto& [c, t] = pose;
  return {c[0].x * p.x + c[1].x * p.y + c[2].x * p.z + t.x, c[0].y * p.x + c[1].y * p.y + c[2].y * p.z + t.y,
          c[0].z * p.x + c[1].z * p.y + c[2].z * p.z + t.z};
}
Vector3 moved(const Vector3& v, const Pose& pose) {
  const Point3 p = moved(Point3{v.x, v.y, v.z}, {pose.columns, {0, 0, 0}});
  return {p.x, p.y, p.z};
}

TEST(PosedOverlap, WhatIsFlattenedIsTheFlatFigureThatItBecomes) {
  Answers answers;
  shape_cases::on_shapes(31, battery::sanitized ? 20 : 100, [&](Material& m) {
    const Pose pose = singular_pose(m);
    const std::array p{small_point(m), small_point(m), small_point(m), small_point(m)};
    const std::array q{moved(p[0], pose), moved(p[1], pose), moved(p[2], pose), moved(p[3], pose)};
    const Vector3 u{small(m), small(m), small(m)}, v{small(m), small(m), small(m)}, w{small(m), small(m), small(m)};
    const Obb3 box{p[0], {u, v, w}, {1, 2, 0.5}},
        flat_box{q[0], {moved(u, pose), moved(v, pose), moved(w, pose)}, {1, 2, 0.5}};
    const Quadrilateral3 quad{{p[0].x, p[0].y, 0}, {p[1].x, p[1].y, 0}, {p[2].x, p[2].y, 0}, {p[3].x, p[3].y, 0}};
    const Quadrilateral3 flat_quad{moved(quad.a, pose), moved(quad.b, pose), moved(quad.c, pose), moved(quad.d, pose)};
    const std::array r{small_point(m), small_point(m), small_point(m), small_point(m)};
    const auto expect = [&](const auto& other) {
      const auto ask = [&](const auto& shape, const auto& image) {
        const Relation expected = relate(image, other);
        answers.add(expected);
        EXPECT_EQ(relate(Posed{shape, pose}, other), expected) << m.about(image, other);
        EXPECT_EQ(relate(other, Posed{shape, pose}), expected) << m.about(image, other);
        EXPECT_EQ(intersects(Posed{shape, pose}, other), expected != Relation::disjoint) << m.about(image, other);
      };
      ask(Segment3{p[0], p[1]}, Segment3{q[0], q[1]});
      ask(Triangle3{p[0], p[1], p[2]}, Triangle3{q[0], q[1], q[2]});
      ask(Tetrahedron3{p[0], p[1], p[2], p[3]}, Tetrahedron3{q[0], q[1], q[2], q[3]});
      ask(box, flat_box);
      ask(quad, flat_quad);
    };
    expect(Triangle3{r[0], r[1], r[2]});
    expect(Aabb3{{-1, -1, -1}, {r[0].x + 4, 1, 2}});
    expect(Sphere3{r[0], 2});
    expect(Plane3{{r[0].x, r[0].y, r[0].z}, r[1].x});
  });
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GT(answers.of(r) * 50, answers.all());
}

// What goes on is cut to the polyhedron that it is asked with, which holds of both as they are given: a pose of either
// moves it away, or brings it there.
TEST(PosedOverlap, LinesAndRaysAreAskedWithPolyhedraWhereThePosesPutThem) {
  Answers answers;
  shape_cases::on_shapes(34, battery::sanitized ? 20 : 200, [&](Material& m) {
    const std::vector<Point3> corners{small_point(m), small_point(m), small_point(m), small_point(m), small_point(m)};
    const Hull3 hull = convex_hull(corners);
    const Pose pose = whole_pose(m);
    const Point3 from = m.below(2) == 0 ? corners[m.below(corners.size())] : small_point(m);
    const Vector3 along{small(m), small(m), small(m)};
    if (hull.dimension != 3 || determinant(pose) == 0 || along == Vector3{}) return;
    std::vector<Point3> images;
    for (const Point3& p : corners) images.push_back(moved(p, pose));
    const ConvexPolyhedron3 solid = convex_polyhedron(hull, corners),
                            image = convex_polyhedron(convex_hull(images), images);
    const auto ask = [&](const auto& straight, const auto& straight_image) {
      const Relation expected = relate(straight, solid);
      answers.add(expected);
      const auto expect = [&](const auto& a, const auto& b) {
        EXPECT_EQ(relate(a, b), expected) << m.about(straight);
        EXPECT_EQ(relate(b, a), expected) << m.about(straight);
        EXPECT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about(straight);
        EXPECT_EQ(intersects(b, a), expected != Relation::disjoint) << m.about(straight);
      };
      expect(straight_image, image);
      expect(straight_image, Posed{solid, pose});
      expect(Posed{straight, pose}, image);
      expect(Posed{straight, pose}, Posed{solid, pose});
    };
    ask(Line3{from, along}, Line3{moved(from, pose), moved(along, pose)});
    ask(Ray3{from, along}, Ray3{moved(from, pose), moved(along, pose)});
  });
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GT(answers.of(r) * 10, answers.all());
}

// A ball under any matrix is the ellipsoid of its columns.
TEST(PosedOverlap, EllipsoidsContainPointsAsTheirOwnStructSays) {
  int inside = 0, boundary = 0, all = 0;
  shape_cases::on_shapes(32, battery::sanitized ? 100 : 600, [&](Material& m) {
    const bool regular = m.below(2) == 0;
    const Pose pose = regular ? whole_pose(m) : singular_pose(m);
    const auto& [c, t] = pose;
    const Posed ball{Sphere3{{0, 0, 0}, 5}, pose};
    const std::array on{Point3{0, 0, 0}, Point3{3, 4, 0}, Point3{0, -3, 4}, Point3{0, 0, 5}, Point3{1, 2, 2}};
    const Point3 p = m.below(3) == 0 ? small_point(m) : moved(on[m.below(on.size())], pose);
    const Location expected = locate(Ellipsoid3{{t.x, t.y, t.z}, c, {5, 5, 5}}, p);
    ++all, inside += expected == Location::inside, boundary += expected == Location::boundary;
    EXPECT_EQ(contains(ball, p), expected != Location::outside) << m.about(p);
    if (determinant(pose) != 0) {
      EXPECT_EQ(relate(ball, p), static_cast<Relation>(expected)) << m.about(p);
    }
  });
  EXPECT_GT(inside * 10, all);
  EXPECT_GT(boundary * 10, all);
}

TEST(PosedOverlap, BallsFlattenedOntoAPlaneAreDisks) {
  const Pose flatten{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}};
  shape_cases::on_shapes(33, battery::sanitized ? 50 : 200, [&](Material& m) {
    const Point2 c{small(m), small(m)}, p{small(m), small(m)}, q{small(m), small(m)}, r{small(m), small(m)};
    const auto lift = [](const Point2& x) { return Point3{x.x, x.y, 1}; };
    const Posed disk{Sphere3{{c.x, c.y, small(m)}, 2}, flatten};
    EXPECT_EQ(relate(disk, Segment3{lift(p), lift(q)}), relate(Circle2{c, 2}, Segment2{p, q})) << m.about(p, q);
    EXPECT_EQ(relate(disk, Triangle3{lift(p), lift(q), lift(r)}), relate(Circle2{c, 2}, Triangle2{p, q, r}));
    EXPECT_EQ(relate(disk, Triangle3{lift(p), lift(q), {r.x, r.y, 1.5}}),
              std::min(relate(Circle2{c, 2}, Segment2{p, q}), Relation::touching));
    EXPECT_EQ(relate(disk, Point3{p.x, p.y, 0x1.0000000000001p0}), Relation::disjoint);
  });
}

TEST(PosedOverlap, WhatIsNotAnsweredSaysSo) {
  const Pose sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 0}}, flat{{{{1, 0, 0}, {0, 1, 0}, {}}}, {0, 0, 0}};
  const Sphere3 ball{{0, 0, 0}, 1};
  EXPECT_EQ(relate(Posed{ball, sheared}, ball), Relation::overlapping);
  EXPECT_THROW(relate(Posed{ball, sheared}, Capsule3{{0, 0, 0}, {1, 0, 0}, 1}), UnevenPose);
  EXPECT_EQ(relate(Posed{ball, sheared}, Posed{Capsule3{{2, 0, 0}, {3, 0, 0}, 1}, sheared}), Relation::touching);
  EXPECT_EQ(relate(Posed{ball, sheared}, Sphere3{{1, 0, 0}, 0}), Relation::touching);  // a point
  EXPECT_EQ(relate(Posed{ball, Pose{{}, {3, 0, 0}}}, Sphere3{{1, 0, 0}, 2}), Relation::touching);
  EXPECT_THROW(relate(Posed{ball, flat}, Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), UnevenPose);
  const Posed can{Cylinder3{{0, 0, 0}, {1, 0, 0}, 1}, flat};  // a rectangle
  EXPECT_EQ(relate(can, Segment3{{0, 0, 0}, {1, 0, 0}}), Relation::overlapping);
  EXPECT_EQ(relate(can, Segment3{{0, 1, -1}, {1, 1, 1}}), Relation::touching);
  EXPECT_THROW(relate(can, ball), UnevenPose);
}

// A cap without an interior is a point or empty, whatever the pose; the matrix zero makes a point of any other.
TEST(PosedOverlap, CapsThatAreNothingOrBecomeAPoint) {
  const Pose sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 0}}, flat{{{{1, 0, 0}, {0, 1, 0}, {}}}, {0, 0, 0}},
      zero{{}, {3, 0, 0}};
  const SphericalCap3 solid{{{1, 1, 0}, 2}, {{0, 0, 1}, 0}}, none{{{1, 1, 0}, 2}, {{0, 0, 1}, -2.5}},
      single{{{2, 0, 5}, 0}, {{0, 0, 1}, 5}}, outside{{{2, 0, 5}, 0}, {{0, 0, 1}, 4}};
  const SphericalCap3 tip{{{0, 3, 5}, 5}, {{0, 6, 8}, 8}};  // its plane touches the ball at (0, 0, 1)
  const auto expect = [](const SphericalCap3& cap, const Pose& pose, const auto& other, Relation expected) {
    EXPECT_EQ(relate(Posed{cap, pose}, other), expected);
    EXPECT_EQ(relate(other, Posed{cap, pose}), expected);
  };
  for (const Pose& pose : {sheared, flat, zero}) {
    for (const SphericalCap3& cap : {none, outside}) {
      expect(cap, pose, Sphere3{{0, 0, 0}, 9}, Relation::disjoint);
      expect(cap, pose, Posed{Sphere3{{0, 0, 0}, 9}, flat}, Relation::disjoint);
      expect(cap, pose, Aabb3{{-9, -9, -9}, {9, 9, 9}}, Relation::disjoint);
    }
  }
  expect(single, sheared, Sphere3{{2, 0, 3}, 2}, Relation::touching);
  expect(single, flat, Sphere3{{2, 0, 3}, 3}, Relation::touching);
  expect(single, flat, Sphere3{{2, 0, 2}, 3}, Relation::overlapping);
  expect(single, sheared, Posed{Sphere3{{2, 0, 3}, 2}, sheared}, Relation::touching);
  expect(single, flat, Posed{Sphere3{{2, 0, 3}, 2}, flat}, Relation::overlapping);  // with the disk that it becomes
  expect(tip, sheared, Sphere3{{0, 0, 4}, 3}, Relation::touching);
  expect(tip, sheared, Sphere3{{0, 0, 0x1.0000000000001p+2}, 3}, Relation::disjoint);
  expect(tip, flat, Sphere3{{0, 0, 3}, 3}, Relation::touching);
  expect(tip, sheared, Segment3{{0, 0, 0}, {0, 0, 2}}, Relation::overlapping);
  for (const SphericalCap3& cap : {solid, single, tip}) {
    expect(cap, zero, Sphere3{{1, 0, 0}, 3}, Relation::overlapping);
    expect(cap, zero, Sphere3{{1, 0, 0}, 2}, Relation::touching);
    expect(cap, zero, Sphere3{{1, 0, 0}, 0x1.fffffffffffffp+0}, Relation::disjoint);
    expect(cap, zero, Segment3{{3, 0, 0}, {4, 0, 0}}, Relation::touching);
    expect(cap, zero, Aabb3{{2, -1, -1}, {4, 1, 1}}, Relation::overlapping);
  }
  for (const Pose& pose : {sheared, flat}) EXPECT_THROW(relate(Posed{solid, pose}, Sphere3{{0, 0, 0}, 9}), UnevenPose);
}

TEST(PosedOverlap, NumbersThatAreNoneAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle3 t{{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, good{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto told = [](auto f) { return text_of<NonFinite>(f).substr(0, 48); };
  EXPECT_EQ(told([&] {
              relate(Posed{t, identity_pose}, Point3{0, 0, 0});
            }),
            std::string("relate: triangle.shape.b.y is nan, not a real number").substr(0, 48));
  Pose pose = identity_pose;
  pose.columns[1].x = nan;
  EXPECT_EQ(told([&] {
              intersects(good, Posed{good, pose});
            }),
            std::string("intersects: b.pose.columns[1].x is nan, not a real number").substr(0, 48));
  EXPECT_THROW(relate(Posed{Sphere3{{0, 0, 0}, -1}, identity_pose}, good), InvalidShape);
}

}  // namespace
}  // namespace plumb::pair_cases

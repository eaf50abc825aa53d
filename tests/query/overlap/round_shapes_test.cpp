// Cylinders and cones; the book's figures of round shapes, laws and bad input.
#include <gtest/gtest.h>

#include <cmath>

#include "figure/basic/powers_of_two.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/axis_oracle.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;
constexpr Relation disjoint = Relation::disjoint, touching = Relation::touching, overlapping = Relation::overlapping;

/// All pairs with a cylinder or a cone.
TEST(OverlapCylinderAndCone, AllPairsAsTheOracle) {
  pair_cases::AnswersByKind answers{};
  std::uint64_t start = 640;
  using pair_cases::PairOracle;
  pair_cases::on_pairs_of<PairOracle::surface>(pair_cases::Space{}, [&]<class A, class B>(const A*, const B*) {
    pair_cases::Answers one;
    on_shapes(start++, 800, [&](Material& m) {
      const auto round = m.shape<B>();
      const auto other = pair_cases::near_figure<A>(m);
      const Relation answer = oracle::relation_to_axis_shape(other, round);
      one.add(answer);
      expect_relation(other, round, answer, pair_cases::pair_name<A, B>() + m.about(other, round));
    });
    pair_cases::add_to_kinds<A, B>(answers, one);
  });
  pair_cases::expect_every_answer(answers);
}

TEST(OverlapRoundFigures, SphereAndPlane515) {  // figure 5.15
  const Plane3 plane{{0, 0, 2}, 4};             // z = 2
  const Halfspace3 below{{0, 0, 2}, 4};
  const Sphere3 across{{0, 0, 2.5}, 1}, behind{{0, 0, 0}, 1}, level{{0, 0, 3}, 1}, above{{0, 0, 3.5}, 1};
  EXPECT_EQ(relate(plane, across), overlapping);
  EXPECT_EQ(relate(plane, behind), disjoint);
  EXPECT_EQ(relate(plane, level), touching);
  EXPECT_EQ(relate(below, across), overlapping);
  EXPECT_EQ(relate(below, behind), overlapping);
  EXPECT_EQ(relate(below, level), touching);
  EXPECT_EQ(relate(below, above), disjoint);
}

TEST(OverlapRoundFigures, ConeAndPlane517) {  // figure 5.17
  const Cone3 cone{{0, 0, 0}, {0, 0, 4}, 3};
  EXPECT_EQ(relate(Halfspace3{{1, 0, 0}, -3}, cone), touching);  // at the rim
  EXPECT_EQ(relate(Halfspace3{{1, 0, 0}, -3.0000000001}, cone), disjoint);
  EXPECT_EQ(relate(Plane3{{0, 0, 1}, 0}, cone), touching);   // at the apex
  EXPECT_EQ(relate(Plane3{{0, 0, 1}, 4}, cone), touching);   // the base
  EXPECT_EQ(relate(Plane3{{4, 0, -3}, 0}, cone), touching);  // along a line of its side
  EXPECT_EQ(relate(Plane3{{4, 0, -3}, -0x1p-1074}, cone), overlapping);
  EXPECT_EQ(relate(Plane3{{4, 0, -3}, 0x1p-1074}, cone), disjoint);
  EXPECT_EQ(relate(Line3{{0, 0, 0}, {3, 0, 4}}, cone), touching);
  EXPECT_EQ(relate(Line3{{0, 0, 0}, {3, 0, 4.0000000001}}, cone), overlapping);
}

TEST(OverlapRoundFigures, SphereNearABoxCorner518) {  // figure 5.18: outside, though of no face plane alone
  const Aabb3 box{{0, 0, 0}, {4, 4, 4}};
  EXPECT_EQ(relate(Sphere3{{6, 7, 10}, 7}, box), touching);  // 2, 3, 6 off the corner
  EXPECT_EQ(relate(Sphere3{{6, 7, 10}, 6.999999999}, box), disjoint);
  EXPECT_EQ(relate(Sphere3{{4.75, 5, 4}, 1.25}, box), touching);  // 3/4 and 1 off an edge
  EXPECT_EQ(relate(Sphere3{{4.75, 4.75, 4.75}, 1}, box), disjoint);
  EXPECT_EQ(relate(Sphere3{{2, 2, 2}, 0}, box), overlapping);
  EXPECT_EQ(relate(Sphere3{{4, 2, 2}, 0}, box), touching);
}

TEST(OverlapRoundFigures, RayAndSphere521) {  // figure 5.21
  const Sphere3 ball{{5, 0, 0}, 3};
  EXPECT_EQ(relate(Ray3{{0, 1, 0}, {1, 0, 0}}, ball), overlapping);  // (a) twice
  EXPECT_EQ(relate(Ray3{{9, 0, 0}, {1, 0, 0}}, ball), disjoint);     // (b) behind the origin
  EXPECT_EQ(relate(Ray3{{0, 3, 0}, {1, 0, 0}}, ball), touching);     // (c) tangent
  EXPECT_EQ(relate(Ray3{{5, 1, 0}, {1, 0, 0}}, ball), overlapping);  // (d) from inside
  EXPECT_EQ(relate(Ray3{{0, 4, 0}, {1, 0, 0}}, ball), disjoint);     // (e)
  EXPECT_EQ(relate(Ray3{{8, 0, 0}, {1, 0, 0}}, ball), touching);     // starts on it, leaves
}

TEST(OverlapRoundFigures, LinesAndCylinder526) {  // figure 5.26
  const Cylinder3 can{{0, 0, 0}, {0, 0, 10}, 5};
  EXPECT_EQ(relate(Segment3{{-9, 3, 5}, {9, 3, 5}}, can), overlapping);
  EXPECT_EQ(relate(Segment3{{-9, 5, 5}, {9, 5, 5}}, can), touching);    // along the side
  EXPECT_EQ(relate(Segment3{{-9, 0, 10}, {9, 0, 10}}, can), touching);  // within an end
  EXPECT_EQ(relate(Segment3{{3, 4, -1}, {3, 4, 11}}, can), touching);   // a line of the side
  EXPECT_EQ(relate(Segment3{{1, 1, 1}, {2, 2, 2}}, can), overlapping);  // within
  EXPECT_EQ(relate(Segment3{{-9, 3, 11}, {9, 3, 11}}, can), disjoint);
  EXPECT_EQ(relate(Ray3{{9, 3, 5}, {1, 0, 0}}, can), disjoint);
  EXPECT_EQ(relate(Line3{{9, 3, 5}, {1, 0, 0}}, can), overlapping);
  EXPECT_EQ(relate(Segment3{{4, 0, 10}, {4, 0, 20}}, can), touching);  // stands on it
}

TEST(OverlapRoundFigures, CapsuleIsTheSweptSphere537) {  // figure 5.37: corners are rounded, edges are cylinders
  const Aabb3 box{{0, 0, 0}, {10, 10, 10}};
  const double off = 2;  // the corner of the enlarged box is farther than the radius
  EXPECT_EQ(relate(box, Capsule3{{10 + off, 10 + off, 10 + off}, {20, 20, 20}, 3}), disjoint);
  EXPECT_EQ(relate(box, Capsule3{{12, 13, 16}, {22, 23, 26}, 7}), touching);
  EXPECT_EQ(relate(box, Capsule3{{13, -5, 14}, {13, 15, 14}, 5}), touching);  // along an edge
  EXPECT_EQ(relate(box, Capsule3{{13, -5, 14}, {13, 15, 14}, 5.000000001}), overlapping);
}

TEST(OverlapRoundFigures, RadiiAreNotAdded) {  // 1 + 2^-60 is no double
  EXPECT_EQ(relate(Sphere3{{0, 0, 0}, 1}, Capsule3{{1, 0, 0}, {2, 0, 0}, 0x1p-60}), overlapping);
  EXPECT_EQ(relate(Sphere3{{0, 0, 0}, 1}, Capsule3{{1 + 0x1p-52, 0, 0}, {2, 0, 0}, 0x1p-53}), disjoint);
  EXPECT_EQ(relate(Sphere3{{0, 0, 0}, 1}, Capsule3{{1 + 0x1p-52, 0, 0}, {2, 0, 0}, 0x1p-52}), touching);
}

TEST(OverlapRoundFigures, SquaresThatUnderflow) {  // of the radius and the offset, beside a long line
  const double r = 0x1p-540;
  const Point3 o{0, 0, 0}, far{0x1p300, 0, 0};
  for (const auto& [y, expected] : {std::pair{r / 2, overlapping}, {r, touching}, {2 * r, disjoint}}) {
    const Point3 p{r, y, 0}, q{r, y, 1};
    EXPECT_EQ(relate(Line3{o, {0x1p300, 0, 0}}, Sphere3{p, r}), expected) << y;
    EXPECT_EQ(relate(Ray3{o, {0x1p300, 0, 0}}, Sphere3{p, r}), expected) << y;
    EXPECT_EQ(relate(Segment3{o, far}, Sphere3{p, r}), expected) << y;
    EXPECT_EQ(relate(Segment3{o, far}, Capsule3{p, q, r}), expected) << y;
    EXPECT_EQ(relate(Triangle3{o, far, {0, -1, 0}}, Sphere3{p, r}), expected) << y;
    EXPECT_EQ(relate(Plane3{{0, 0x1p300, 0}, 0}, Sphere3{p, r}), expected) << y;
  }
}

TEST(OverlapRoundFigures, UnboundedHalfspaces) {
  const HalfspaceIntersection3 wedge{{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}}};
  EXPECT_EQ(relate(Sphere3{{3, 4, 100}, 5}, wedge), touching);
  EXPECT_EQ(relate(Sphere3{{3, 4, 100}, 4.999}, wedge), disjoint);
  EXPECT_EQ(relate(Capsule3{{3, 4, -1e6}, {3, 4, 1e6}, 5.001}, wedge), overlapping);
  EXPECT_EQ(relate(Sphere3{{3, 4, 0}, 1}, HalfspaceIntersection3{}), overlapping);
  EXPECT_EQ(relate(Sphere3{{3, 4, 0}, 1e9}, HalfspaceIntersection3{{{{0, 0, 0}, -1}}}), disjoint);
  EXPECT_EQ(relate(Circle2{{3, 4}, 5}, HalfspaceIntersection2{{{{1, 0}, 0}, {{0, 1}, 0}}}), touching);
}

// A k-DOP is the intersection of its sides, and that of one side is a halfspace.
TEST(OverlapRoundFigures, HalfspacesAsKDops) {
  on_shapes(655, 60, [](Material& m) {
    const auto k_dop = pair_cases::figure<KDop3>(m);
    const auto capsule = m.shape<Capsule3>();
    EXPECT_EQ(relate(oracle::sides_of(k_dop), capsule), relate(k_dop, capsule)) << m.about(capsule);
    const auto half = m.shape<Halfspace3>();
    const Sphere3 ball{capsule.a, capsule.radius};
    EXPECT_EQ(relate(HalfspaceIntersection3{{half, half}}, ball), relate(half, ball)) << m.about(half, ball);
  });
}

TEST(OverlapRoundFigures, PolygonsThatCoverEdgesTwice) {
  const Polygon3 spike{{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};  // a square, and there and back
  EXPECT_EQ(relate(spike, Sphere3{{7, 0, 0}, 1}), touching);
  EXPECT_EQ(relate(spike, Sphere3{{7, 0, 0}, 3}), touching);
  EXPECT_EQ(relate(spike, Sphere3{{7, 0, 0}, 3.5}), overlapping);
  EXPECT_EQ(relate(spike, Sphere3{{2, 2, 0}, 0x1p-1074}), overlapping);
  const Polygon3 slit{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  EXPECT_EQ(relate(slit, Sphere3{{2, 1, 1}, 1}), touching);
  EXPECT_EQ(relate(slit, Sphere3{{2, 1, 1}, 1.5}), overlapping);
  const HoledPolygon3 nothing{{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}, {{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}}};
  EXPECT_EQ(relate(nothing, Sphere3{{3, 1, 0}, 0.5}), disjoint);
  EXPECT_EQ(relate(nothing, Sphere3{{2, 0, 0}, 0.5}), touching);
}

template <class Shape, std::size_t N = sizeof(Shape) / sizeof(double)>
Shape changed(const Shape& s, auto change) {
  auto numbers = std::bit_cast<std::array<double, N>>(s);
  for (double& x : numbers) x = change(x);
  return std::bit_cast<Shape>(numbers);
}

// Powers of two that lose no bit, and turning the axes around.
template <class Flat, class Round>
void expect_laws(std::uint64_t start) {
  on_shapes(start, 150, [&](Material& m) {
    const auto flat = pair_cases::near_figure<Flat>(m);
    const auto round = m.shape<Round>();
    const Relation answer = relate(flat, round);
    for (const int k : {-40, 17}) {
      const auto scale = [k](double x) { return std::ldexp(x, k); };
      const auto back = [k](double x) { return std::ldexp(x, -k); };
      const Flat f = changed(flat, scale);
      const Round r = changed(round, scale);
      if (!(changed(f, back) == flat) || !(changed(r, back) == round)) continue;
      ASSERT_EQ(relate(f, r), answer) << m.about(flat, round);
    }
  });
}
TEST(OverlapRoundLaws, PowersOfTwo) {
  expect_laws<Line3, Capsule3>(660);
  expect_laws<Ray3, Sphere3>(661);
  expect_laws<Segment3, Cylinder3>(662);
  expect_laws<Triangle3, Capsule3>(663);
  expect_laws<Tetrahedron3, Sphere3>(664);
  expect_laws<Aabb3, Capsule3>(665);
  expect_laws<Segment3, Cone3>(666);
  expect_laws<Triangle2, Circle2>(667);
}
TEST(OverlapRoundLaws, PowersOfTwoFromTheLeastDoublesToTheLargest) {
  powers_of_two::expect_same_relation<Triangle3, Sphere3>(669, 100);
  powers_of_two::expect_same_relation<Sphere3, Obb3>(670, 100);
  powers_of_two::expect_same_relation<Segment3, Capsule3>(671, 100);
  powers_of_two::expect_same_relation<Aabb3, Capsule3>(672, 100);
}

TEST(OverlapRoundLaws, OrderOfCornersAndExactTranslation) {
  Entropy entropy(668);
  const auto number = [&] { return static_cast<double>(entropy.within(6)); };
  const auto point = [&] { return Point3{number(), number(), number()}; };
  for (int i = 0; i < 300; ++i) {
    const Triangle3 t{point(), point(), point()};
    const Capsule3 c{point(), point(), std::fabs(number())};
    const Relation answer = relate(t, c);
    EXPECT_EQ(relate(Triangle3{t.b, t.c, t.a}, c), answer) << i;
    EXPECT_EQ(relate(Triangle3{t.b, t.a, t.c}, Capsule3{c.b, c.a, c.radius}), answer) << i;
    const auto moved = [by = 0x1p40 + number()](const Point3& p) { return Point3{p.x + by, p.y - by, p.z + by}; };
    EXPECT_EQ(relate(Triangle3{moved(t.a), moved(t.b), moved(t.c)}, Capsule3{moved(c.a), moved(c.b), c.radius}), answer)
        << i;
    const auto turned = [](const Point3& p) { return Point3{p.y, p.z, p.x}; };
    EXPECT_EQ(relate(Triangle3{turned(t.a), turned(t.b), turned(t.c)}, Capsule3{turned(c.a), turned(c.b), c.radius}),
              answer)
        << i;
  }
}

TEST(OverlapRoundBadInput, NamesThePart) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Sphere3 ball{{0, 0, 0}, 1};
  const auto expect = [](const std::string& text, std::string_view start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
  };
  expect(text_of<Error>([&] {
           (void)relate(Triangle3{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, ball);
         }),
         "relate: triangle.c.y is nan");
  expect(text_of<Error>([&] { (void)relate(ball, Aabb3{{0, 0, 0}, {1, infinite, 1}}); }), "relate: aabb.max.y is inf");
  expect(text_of<Error>([&] { (void)relate(Line3{{0, 0, 0}, {1, nan, 0}}, ball); }), "relate: line.direction.y is nan");
  expect(text_of<Error>([&] { (void)relate(Plane3{{0, 0, 1}, nan}, ball); }), "relate: plane.offset is nan");
  expect(text_of<Error>([&] {
           (void)relate(Segment3{{0, 0, 0}, {1, 0, 0}}, Cylinder3{{0, 0, 0}, {1, 0, 0}, nan});
         }),
         "relate: cylinder.radius is nan");
  expect(text_of<Error>([&] {
           (void)relate(Segment3{{0, 0, 0}, {1, 0, 0}}, Capsule3{{0, 0, 0}, {1, 0, 0}, -1});
         }),
         "relate: capsule.radius is negative");
  expect(text_of<Error>([&] {
           (void)relate(Plane3{{0, 0, 1}, 0}, Cone3{{0, 0, 0}, {1, 0, 0}, -1});
         }),
         "relate: cone.radius is negative");
  expect(text_of<Error>([&] {
           (void)relate(Polygon3{{{0, 0, 0}, {1, 0, 0}}}, ball);
         }),
         "relate: polygon.vertices has 2 vertices");
  expect(text_of<Error>([&] {
           (void)relate(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}, ball);
         }),
         "relate: the quadrilateral is not planar");
  expect(text_of<Error>([&] {
           (void)relate(Circle2{{0, nan}, 1}, Aabb2{{0, 0}, {1, 1}});
         }),
         "relate: circle.center.y is nan");
  expect(text_of<Error>([&] {
           (void)relate(Sphere3{{0, 0, 0}, -1}, KDop3{k_dop_directions(6), {0, 0, 0}, {1, 1, 1}});
         }),
         "relate: sphere.radius is negative");
}

}  // namespace
}  // namespace plumb

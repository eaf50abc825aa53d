// Round figures against polygons, and in the plane; cylinders and cones; the book's figures, laws and bad input.
#include <gtest/gtest.h>

#include "plumb/query/overlap.hpp"
#include "query/round_oracle.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;
constexpr Relation disjoint = Relation::disjoint, touching = Relation::touching, overlapping = Relation::overlapping;

TEST(OverlapRoundPolygon, QuadrilateralSphere) { expect_as_brute_force<Quadrilateral3, Sphere3>(600, 150); }
TEST(OverlapRoundPolygon, PolygonSphere) { expect_as_brute_force<Polygon3, Sphere3>(601, 100); }
TEST(OverlapRoundPolygon, HoledPolygonSphere) { expect_as_brute_force<HoledPolygon3, Sphere3>(602, 30); }
TEST(OverlapRoundPolygon, QuadrilateralCapsule) { expect_as_brute_force<Quadrilateral3, Capsule3>(603, 60); }
TEST(OverlapRoundPolygon, PolygonCapsule) { expect_as_brute_force<Polygon3, Capsule3>(604, 16); }
TEST(OverlapRoundPolygon, HoledPolygonCapsule) { expect_as_brute_force<HoledPolygon3, Capsule3>(605, 4); }

TEST(OverlapRoundPlane, LineCircle) { expect_as_brute_force<Line2, Circle2>(620, 200); }
TEST(OverlapRoundPlane, RayCircle) { expect_as_brute_force<Ray2, Circle2>(621, 200); }
TEST(OverlapRoundPlane, SegmentCircle) { expect_as_brute_force<Segment2, Circle2>(622, 200); }
TEST(OverlapRoundPlane, HalfspaceCircle) { expect_as_brute_force<Halfspace2, Circle2>(623, 100); }
TEST(OverlapRoundPlane, TriangleCircle) { expect_as_brute_force<Triangle2, Circle2>(624, 200); }
TEST(OverlapRoundPlane, PolygonCircle) { expect_as_brute_force<Polygon2, Circle2>(625, 60); }
TEST(OverlapRoundPlane, AabbCircle) { expect_as_brute_force<Aabb2, Circle2>(626, 200); }
TEST(OverlapRoundPlane, ObbCircle) { expect_as_brute_force<Obb2, Circle2>(627, 200); }
TEST(OverlapRoundPlane, KDopCircle) { expect_as_brute_force<KDop2, Circle2>(628, 50); }
TEST(OverlapRoundPlane, PointCapsule) { expect_as_brute_force<Point2, Capsule2>(629, 200); }
TEST(OverlapRoundPlane, LineCapsule) { expect_as_brute_force<Line2, Capsule2>(630, 200); }
TEST(OverlapRoundPlane, RayCapsule) { expect_as_brute_force<Ray2, Capsule2>(631, 200); }
TEST(OverlapRoundPlane, SegmentCapsule) { expect_as_brute_force<Segment2, Capsule2>(632, 200); }
TEST(OverlapRoundPlane, HalfspaceCapsule) { expect_as_brute_force<Halfspace2, Capsule2>(633, 100); }
TEST(OverlapRoundPlane, TriangleCapsule) { expect_as_brute_force<Triangle2, Capsule2>(634, 150); }
TEST(OverlapRoundPlane, HoledPolygonCapsule) { expect_as_brute_force<HoledPolygon2, Capsule2>(635, 8); }
TEST(OverlapRoundPlane, AabbCapsule) { expect_as_brute_force<Aabb2, Capsule2>(636, 100); }
TEST(OverlapRoundPlane, ObbCapsule) { expect_as_brute_force<Obb2, Capsule2>(637, 100); }
TEST(OverlapRoundPlane, CircleCapsule) { expect_round_as_brute_force<Circle2, Capsule2>(638, 200); }

// Cylinders and cones, from the structs' comments: by the places along the line where something can change, and by what
// a disk reaches along a normal.

using oracle::dot;
using oracle::RationalPoint;

struct AxisShape {
  RationalPoint from, axis;
  mpq_class radius;
  bool is_cone;
};
AxisShape axis_shape(const Cylinder3& c) {
  return {oracle::rational(c.a), oracle::difference(oracle::rational(c.b), oracle::rational(c.a)), c.radius, false};
}
AxisShape axis_shape(const Cone3& c) {
  return {oracle::rational(c.apex), oracle::difference(oracle::rational(c.base), oracle::rational(c.apex)), c.radius,
          true};
}

/// Below zero inside the infinite surface, for a share `along` of the axis.
mpq_class beyond_surface(const AxisShape& s, const RationalPoint& p, const mpq_class& along) {
  const RationalPoint off = oracle::sum(oracle::difference(p, s.from), -along, s.axis);
  const mpq_class reach = s.is_cone ? mpq_class(s.radius * along) : s.radius;
  return dot(off, off) - reach * reach;
}

struct RationalLine {
  RationalPoint from, along;
  std::optional<mpq_class> first, last;
};
RationalLine rational_line(const Line3& l) {
  return {oracle::rational(l.point), oracle::rational(l.direction), {}, {}};
}
RationalLine rational_line(const Ray3& r) {
  return {oracle::rational(r.origin), oracle::rational(r.direction), mpq_class(0), {}};
}
RationalLine rational_line(const Segment3& s) {
  return {oracle::rational(s.a), oracle::difference(oracle::rational(s.b), oracle::rational(s.a)), mpq_class(0),
          mpq_class(1)};
}

Relation expected_crossing(const AxisShape& s, const RationalLine& line) {
  const mpq_class square = dot(s.axis, s.axis);
  const auto share = [&](const mpq_class& t) {
    return mpq_class(dot(oracle::difference(oracle::sum(line.from, t, line.along), s.from), s.axis) / square);
  };
  const auto value = [&](const mpq_class& t) {
    return beyond_surface(s, oracle::sum(line.from, t, line.along), share(t));
  };
  const mpq_class start = share(0), rise = share(1) - start;
  auto [first, last] = std::pair(line.first, line.last);
  bool strictly = true;
  if (rise == 0) {
    if (start < 0 || start > 1) return disjoint;
    strictly = start > 0 && start < 1;
  } else {
    const mpq_class at0 = -start / rise, at1 = (1 - start) / rise;
    const mpq_class in = std::min(at0, at1), out = std::max(at0, at1);
    if (!first || in > *first) first = in;
    if (!last || out < *last) last = out;
  }
  if (first && last && *first > *last) return disjoint;
  const bool has_length = !first || !last || *first < *last;
  // The quadratic through three values.
  const mpq_class v0 = value(0), v1 = value(1), v2 = value(2);
  const mpq_class a = (v2 - 2 * v1 + v0) / 2, b = v1 - v0 - a;
  std::vector<mpq_class> places;
  if (first) places.push_back(*first);
  if (last) places.push_back(*last);
  if (a > 0) {
    const mpq_class bottom = -b / (2 * a);
    if ((!first || bottom > *first) && (!last || bottom < *last)) places.push_back(bottom);
  }
  if (places.empty()) places.push_back(0);
  mpq_class least = value(places[0]);
  for (const mpq_class& t : places) least = std::min(least, value(t));
  if (least > 0) return disjoint;
  return least < 0 && has_length && strictly ? overlapping : touching;
}

/// The point p, or a ball, or a segment, where the shape is one.
template <class Line, class Round>
Relation expected_line(const Line& line, const Round& round) {
  const AxisShape s = axis_shape(round);
  const bool is_ball = dot(s.axis, s.axis) == 0;
  const RationalLine l = rational_line(line);
  if (is_ball || s.radius == 0) {
    oracle::Spanned core{{s.from}, {}};
    if (!is_ball) core.points.push_back(oracle::sum(s.from, 1, s.axis));
    return oracle::RoundOracle(core, {{oracle::spanned(line)}, {}}).relation(s.radius);
  }
  if (dot(l.along, l.along) == 0) {
    const mpq_class share = dot(oracle::difference(l.from, s.from), s.axis) / dot(s.axis, s.axis);
    const mpq_class off = beyond_surface(s, l.from, share);
    if (share < 0 || share > 1 || off > 0) return disjoint;
    return share > 0 && share < 1 && off < 0 ? overlapping : touching;
  }
  return expected_crossing(s, l);
}

/// The sign of h - root of square, for square >= 0.
int above_root(const mpq_class& h, const mpq_class& square) {
  if (sgn(h) < 0) return -1;
  return sgn(mpq_class(h * h - square));
}

template <class Plane, class Round>
Relation expected_plane(const Plane& plane, const Round& round) {
  const AxisShape s = axis_shape(round);
  const RationalPoint n = oracle::rational(plane.normal);
  const mpq_class nn = dot(n, n), hh = dot(s.axis, s.axis), along = dot(n, s.axis);
  const bool is_ball = hh == 0;
  if (s.radius == 0 || nn == 0 || is_ball) {
    oracle::Spanned core{{s.from}, {}};
    if (!is_ball) core.points.push_back(oracle::sum(s.from, 1, s.axis));
    return oracle::RoundOracle(core, {{oracle::spanned(plane)}, {}}).relation(s.radius);
  }
  const mpq_class reach = s.radius * s.radius * (nn - along * along / hh);
  const mpq_class low = dot(n, s.from) - mpq_class(plane.offset), high = low + along;
  const mpq_class of_from = s.is_cone ? mpq_class(0) : reach;
  const int above = std::min(above_root(low, of_from), above_root(high, reach));
  if constexpr (std::is_same_v<Plane, Halfspace3>) {
    return static_cast<Relation>(-above);
  } else {
    const int below = std::min(above_root(-low, of_from), above_root(-high, reach));
    return static_cast<Relation>(-std::max(above, below));
  }
}

template <class Flat, class Round, class Expected>
void expect_axis_shape(std::uint64_t start, std::uint64_t cases, Expected expected) {
  Counts counts;
  on_shapes(start, cases, [&](Material& m) {
    const auto round = m.shape<Round>();
    const auto flat = pair_cases::near_figure<Flat>(m);
    const Relation answer = expected(flat, round);
    counts.add(answer);
    ASSERT_EQ(relate(flat, round), answer) << m.about(flat, round);
    ASSERT_EQ(relate(round, flat), answer) << m.about(flat, round);
  });
  std::printf("disjoint %d, touching %d, overlapping %d\n", counts.of[0], counts.of[1], counts.of[2]);
  expect_all_answers(counts, cases * shape_cases::more);
}
template <class Line, class Round>
void expect_lines(std::uint64_t start) {
  expect_axis_shape<Line, Round>(start, 1500, expected_line<Line, Round>);
}
template <class Plane, class Round>
void expect_planes(std::uint64_t start) {
  expect_axis_shape<Plane, Round>(start, 800, expected_plane<Plane, Round>);
}
TEST(OverlapCylinder, Line) { expect_lines<Line3, Cylinder3>(640); }
TEST(OverlapCylinder, Ray) { expect_lines<Ray3, Cylinder3>(641); }
TEST(OverlapCylinder, Segment) { expect_lines<Segment3, Cylinder3>(642); }
TEST(OverlapCylinder, Plane) { expect_planes<Plane3, Cylinder3>(643); }
TEST(OverlapCylinder, Halfspace) { expect_planes<Halfspace3, Cylinder3>(644); }
TEST(OverlapCone, Line) { expect_lines<Line3, Cone3>(645); }
TEST(OverlapCone, Ray) { expect_lines<Ray3, Cone3>(646); }
TEST(OverlapCone, Segment) { expect_lines<Segment3, Cone3>(647); }
TEST(OverlapCone, Plane) { expect_planes<Plane3, Cone3>(648); }
TEST(OverlapCone, Halfspace) { expect_planes<Halfspace3, Cone3>(649); }

// Three points span what the plane of their normal is, or a line, or a place.
TEST(OverlapCylinder, ThreePointPlane) {
  int lines = 0, planes = 0;
  on_shapes(650, 600, [&](Material& m) {
    const auto cylinder = m.shape<Cylinder3>();
    const auto cone = m.shape<Cone3>();
    const auto p = pair_cases::near_figure<ThreePointPlane3>(m);
    const RationalPoint a = oracle::rational(p.a), u = oracle::difference(oracle::rational(p.b), a),
                        v = oracle::difference(oracle::rational(p.c), a);
    const RationalPoint n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const Plane3 plane{{n[0].get_d(), n[1].get_d(), n[2].get_d()}, mpq_class(dot(n, a)).get_d()};
    const RationalPoint way = dot(u, u) == 0 ? v : u;
    const Line3 line{p.a, {way[0].get_d(), way[1].get_d(), way[2].get_d()}};
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::ranges::all_of(coordinates(plane.normal), finite) || !finite(plane.offset) ||
        !std::ranges::all_of(coordinates(line.direction), finite))
      return;
    if (dot(n, n) == 0) {
      if (oracle::rational(line.direction) != way) return;
      ++lines;
      EXPECT_EQ(relate(p, cylinder), relate(line, cylinder)) << m.about(p, cylinder);
      EXPECT_EQ(relate(p, cone), relate(line, cone)) << m.about(p, cone);
    } else {
      if (oracle::rational(plane.normal) != n || mpq_class(plane.offset) != dot(n, a)) return;
      ++planes;
      EXPECT_EQ(relate(p, cylinder), relate(plane, cylinder)) << m.about(p, cylinder);
      EXPECT_EQ(relate(p, cone), relate(plane, cone)) << m.about(p, cone);
    }
  });
  EXPECT_GT(lines, 20);
  EXPECT_GT(planes, 200);
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

template <class Call>
std::string failure(Call call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing";
}

TEST(OverlapRoundBadInput, NamesThePart) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Sphere3 ball{{0, 0, 0}, 1};
  const auto expect = [](const std::string& text, std::string_view start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
  };
  expect(failure([&] { (void)relate(Triangle3{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, ball); }), "relate: a.c.y is nan");
  expect(failure([&] { (void)relate(ball, Aabb3{{0, 0, 0}, {1, infinite, 1}}); }), "relate: b.max.y is inf");
  expect(failure([&] { (void)relate(Line3{{0, 0, 0}, {1, nan, 0}}, ball); }), "relate: a.direction.y is nan");
  expect(failure([&] { (void)relate(Plane3{{0, 0, 1}, nan}, ball); }), "relate: a.offset is nan");
  expect(failure([&] {
           (void)relate(Segment3{{0, 0, 0}, {1, 0, 0}}, Cylinder3{{0, 0, 0}, {1, 0, 0}, nan});
         }),
         "relate: b.radius is nan");
  expect(failure([&] {
           (void)relate(Segment3{{0, 0, 0}, {1, 0, 0}}, Capsule3{{0, 0, 0}, {1, 0, 0}, -1});
         }),
         "relate: b.radius is negative");
  expect(failure([&] {
           (void)relate(Plane3{{0, 0, 1}, 0}, Cone3{{0, 0, 0}, {1, 0, 0}, -1});
         }),
         "relate: b.radius is negative");
  expect(failure([&] { (void)relate(Polygon3{{{0, 0, 0}, {1, 0, 0}}}, ball); }), "relate: a.vertices has 2 vertices");
  expect(failure([&] {
           (void)relate(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}, ball);
         }),
         "relate: the polygon is not planar");
  expect(failure([&] { (void)relate(Circle2{{0, nan}, 1}, Aabb2{{0, 0}, {1, 1}}); }), "relate: a.center.y is nan");
  expect(failure([&] {
           (void)relate(Sphere3{{0, 0, 0}, -1}, KDop3{k_dop_directions(6), {0, 0, 0}, {1, 1, 1}});
         }),
         "relate: a.radius is negative");
}

}  // namespace
}  // namespace plumb

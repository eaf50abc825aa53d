// Polygons against rationals, the laws of nearest points, comparisons of distances, figures 5.1 to 5.6 by hand, and
// what is no shape.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "arith/difference_search.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/closest/oracle.hpp"

namespace plumb {

std::ostream& operator<<(std::ostream& out, const Feature& f) {
  return out << std::array{"vertex", "edge", "face", "interior"}[static_cast<std::size_t>(f.kind)] << ' ' << f.index;
}

namespace {

using namespace closest_oracle;
using rationals::is_nearest;
using shape_cases::Material, shape_cases::on_shapes;
using testing::HasSubstr;

/// Is q inside of the chains, by edges that cross the line to its right?  Of what is on a chain anything may be said.
bool is_odd(const std::vector<Corners>& chains, const Vector& q) {
  bool odd = false;
  for (const Corners& chain : chains) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Vector &a = chain[i], &b = chain[(i + 1) % chain.size()];
      if ((a[1] > q[1]) == (b[1] > q[1])) continue;
      const mpq_class x = a[0] + (q[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      if (x > q[0]) odd = !odd;
    }
  }
  return odd;
}

/// The vertices and edges of all chains in turn.
closest_oracle::Shape outline(const std::vector<Corners>& chains) {
  Corners all;
  Numbers edges;
  for (const Corners& chain : chains) {
    const std::size_t first = all.size();
    for (std::size_t i = 0; i < chain.size(); ++i) edges.push_back({first + i, first + (i + 1) % chain.size()});
    all.insert(all.end(), chain.begin(), chain.end());
  }
  return shape_of(all, edges, {});
}

template <class Polygon, class Point>
void expect_nearest(const Polygon& polygon, const Point& p, const Nearest& expected) {
  const auto c = closest_points(p, polygon);
  EXPECT_EQ(c.feature_b, expected.feature);
  const auto at = coordinates(c.on_b);
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_TRUE(is_nearest(at[i], expected.point[i])) << i;
  EXPECT_EQ(squared_distance_exact(p, polygon).value().value, expected.square);
  EXPECT_EQ(distance(polygon, p), rounded_root(Rounding::nearest, squared_distance_exact(p, polygon)));
  EXPECT_EQ(closest_point(polygon, p), c.on_b);
  EXPECT_EQ(closest_points(polygon, p), swapped(c));
}

struct Seen {
  std::array<int, 4> kind{};
  void add(const Feature& f) { ++kind[static_cast<std::size_t>(f.kind)]; }
};

std::vector<Corners> chains_of(const HoledPolygon2& polygon) {
  std::vector<Corners> chains;
  const auto add = [&](const Polygon2& chain) {
    chains.emplace_back();
    for (const Point2& v : chain.vertices) chains.back().push_back(exact(v));
  };
  add(polygon.outer);
  for (const Polygon2& hole : polygon.holes) add(hole);
  return chains;
}
Quadrilateral2 first_four(const Polygon2& p) { return {p.vertices[0], p.vertices[1], p.vertices[2], p.vertices[3]}; }

TEST(ClosestTest, OfPolygonsInThePlane) {
  Seen seen;
  on_shapes(31, 400, [&](Material& m) {
    const auto holed = m.shape<HoledPolygon2>();
    const Point2 p = m.probe2();
    SCOPED_TRACE(m.about(p));
    const auto expected_of = [&](const HoledPolygon2& polygon) {
      const auto chains = chains_of(polygon);
      const Nearest on_chain = nearest_of(outline(chains), exact(p));
      if (on_chain.square == 0 || !is_odd(chains, exact(p))) return on_chain;
      return Nearest{exact(p), 0, face(0)};
    };
    seen.add(expected_of(holed).feature);
    expect_nearest(holed, p, expected_of(holed));
    expect_nearest(holed.outer, p, expected_of({holed.outer, {}}));
    if (holed.outer.vertices.size() < 4) return;
    const Quadrilateral2 q = first_four(holed.outer);
    expect_nearest(q, p, expected_of({{{q.a, q.b, q.c, q.d}}, {}}));
  });
  EXPECT_GT(seen.kind[0], 100);
  EXPECT_GT(seen.kind[1], 50);
  EXPECT_GT(seen.kind[2], 20);
}

/// Polygons of small integers, brought into space by integers: in a plane, exactly, or on a line.
TEST(ClosestTest, OfPolygonsInSpace) {
  Seen seen;
  for (std::uint64_t index = 0; index < 400 * shape_cases::more; ++index) {
    SCOPED_TRACE(testing::Message() << "start 32 index " << index);
    Entropy entropy(32, index);
    std::array<double, 9> m{};
    for (double& x : m) x = static_cast<double>(entropy.within(4));
    const auto number = [&] { return static_cast<double>(entropy.within(4)); };
    const auto point = [&] {
      const double s = number(), t = number();
      return Point2{s, t};
    };
    const auto lifted = [&](const Point2& q) {
      return Point3{m[0] + m[1] * q.x + m[2] * q.y, m[3] + m[4] * q.x + m[5] * q.y, m[6] + m[7] * q.x + m[8] * q.y};
    };
    HoledPolygon3 polygon;
    std::vector<Corners> flat, chains;
    const auto draw = [&](Polygon3& to) {
      flat.emplace_back();
      chains.emplace_back();
      for (std::size_t n = 4 + entropy.below(4); n-- > 0;) {
        const Point2 q = point();
        to.vertices.push_back(lifted(q));
        flat.back().push_back(exact(q));
        chains.back().push_back(exact(to.vertices.back()));
      }
    };
    draw(polygon.outer);
    polygon.holes.resize(entropy.below(3));
    for (Polygon3& hole : polygon.holes) draw(hole);
    const double x = number(), y = number(), z = number();
    const Point3 p = entropy.below(3) == 0 ? lifted(point()) : Point3{x * 2, y * 2, z * 2};
    const auto expected_of = [&](const std::vector<Corners>& flats, const std::vector<Corners>& spatial) {
      const Nearest on_chain = nearest_of(outline(spatial), exact(p));
      const Vector o = exact(lifted({0, 0})), u = exact(lifted({1, 0})) - o, v = exact(lifted({0, 1})) - o,
                   w = exact(p) - o;
      const auto place =
          rationals::only_solution({{dot(u, u), dot(u, v), dot(u, w)}, {dot(u, v), dot(v, v), dot(v, w)}});
      if (!place || !is_odd(flats, *place)) return on_chain;
      const Vector foot = o + (*place)[0] * u + (*place)[1] * v;
      const mpq_class square = square_of(foot - exact(p));
      return square < on_chain.square ? Nearest{foot, square, face(0)} : on_chain;
    };
    seen.add(expected_of(flat, chains).feature);
    expect_nearest(polygon, p, expected_of(flat, chains));
    const std::vector<Corners> outer{chains[0]}, outer_flat{flat[0]};
    expect_nearest(polygon.outer, p, expected_of(outer_flat, outer));
    const auto& v = polygon.outer.vertices;
    const std::vector<Corners> four{Corners(chains[0].begin(), chains[0].begin() + 4)},
        four_flat{Corners(flat[0].begin(), flat[0].begin() + 4)};
    expect_nearest(Quadrilateral3{v[0], v[1], v[2], v[3]}, p, expected_of(four_flat, four));
  }
  EXPECT_GT(seen.kind[0], 40);
  EXPECT_GT(seen.kind[1], 50);
  EXPECT_GT(seen.kind[2], 30);
}

Triangle3 moved(const Triangle3& t, const auto& by) { return {by(t.a), by(t.b), by(t.c)}; }

TEST(ClosestTest, PermutationsScalesAndTranslations) {
  for (std::uint64_t index = 0; index < 300; ++index) {
    SCOPED_TRACE(testing::Message() << "start 33 index " << index);
    Entropy entropy(33, index);
    const auto point = [&] {
      const auto x = static_cast<double>(entropy.within(9)), y = static_cast<double>(entropy.within(9)),
                 z = static_cast<double>(entropy.within(9));
      return Point3{x, y, z};
    };
    const Triangle3 t{point(), point(), point()};
    const Point3 p = point();
    const Closest c = closest_points(p, t);
    for (const Triangle3& other : {Triangle3{t.b, t.c, t.a}, Triangle3{t.c, t.b, t.a}}) {
      const Closest d = closest_points(p, other);
      EXPECT_EQ(d.on_b, c.on_b);
      EXPECT_EQ(d.distance, c.distance);
    }
    if (t.a != t.b && t.b != t.c && t.c != t.a && c.feature_b.kind == FeatureKind::vertex) {
      EXPECT_EQ(closest_points(p, Triangle3{t.b, t.c, t.a}).feature_b, vertex((c.feature_b.index + 2) % 3));
    }
    const int power = static_cast<int>(entropy.within(1000));
    const auto scale = [&](const Point3& q) {
      return Point3{std::ldexp(q.x, power), std::ldexp(q.y, power), std::ldexp(q.z, power)};
    };
    const Closest scaled = closest_points(scale(p), moved(t, scale));
    EXPECT_EQ(scaled.on_b, scale(c.on_b));
    EXPECT_EQ(scaled.distance, std::ldexp(c.distance, power));
    EXPECT_EQ(scaled.feature_b, c.feature_b);
    const auto turn = [](const Point3& q) { return Point3{-q.y, q.z, -q.x}; };
    const Closest turned = closest_points(turn(p), moved(t, turn));
    EXPECT_EQ(turned.distance, c.distance);
    EXPECT_EQ(turned.feature_b, c.feature_b);
    const auto shift = [](const Point3& q) { return Point3{q.x + 0x1p40, q.y - 0x1p40, q.z + 0x1p30}; };
    const Closest shifted = closest_points(shift(p), moved(t, shift));
    EXPECT_EQ(shifted.distance, c.distance);
    EXPECT_EQ(shifted.feature_b, c.feature_b);
    EXPECT_EQ(squared_distance_exact(shift(p), moved(t, shift)), squared_distance_exact(p, t));
  }
}

/// The sign of sqrt(s) - r - sqrt(t) + u by roots between bounds; zero where thousands of digits tell no difference.
Sign told_by_digits(const mpq_class& s, const mpq_class& r, const mpq_class& t, const mpq_class& u) {
  const auto bounds = [](const mpq_class& square, const mpq_class& less, unsigned digits) {
    const mpz_class root = sqrt(mpz_class((square.get_num() * square.get_den()) << 2 * digits));
    mpq_class low(root, square.get_den() << digits), high(root + 1, square.get_den() << digits);
    low.canonicalize(), high.canonicalize();
    low -= less, high -= less;
    return std::pair{low < 0 ? mpq_class(0) : low, high < 0 ? mpq_class(0) : high};
  };
  for (const unsigned digits : {200u, 6000u}) {
    const auto a = bounds(s, r, digits), b = bounds(t, u, digits);
    if (a.first > b.second) return Sign::positive;
    if (a.second < b.first) return Sign::negative;
  }
  return Sign::zero;
}

template <class Shape>
std::pair<mpq_class, mpq_class> parts(const Point3& p, const Shape& s) {
  const ExactDistance d = exact_distance(p, s);
  return {d.square.value().value, d.inset.value().value};
}

TEST(ClosestTest, DistancesCompareExactly) {
  std::array<int, 3> told{};
  on_shapes(34, 500, [&](Material& m) {
    const auto triangle = m.shape<Triangle3>();
    const auto sphere = m.shape<Sphere3>();
    const auto capsule = m.shape<Capsule3>();
    const Point3 p = m.probe3(), q = m.probe3();
    SCOPED_TRACE(m.about(triangle, sphere, capsule, p, q));
    const auto expect = [&](const auto& first, const auto& second, const auto& a, const auto& b) {
      const Sign s = compare_distance(p, first, q, second);
      EXPECT_EQ(s, told_by_digits(a.first, a.second, b.first, b.second));
      EXPECT_EQ(compare_distance(second, q, first, p), -s);
      ++told[static_cast<std::size_t>(static_cast<int>(s) + 1)];
    };
    const auto a = parts(p, triangle), b = parts(q, sphere), c = parts(q, capsule), d = parts(p, sphere);
    expect(triangle, sphere, a, b);
    expect(triangle, capsule, a, c);
    expect(sphere, capsule, d, c);
    expect(sphere, sphere, d, b);
    const double than = distance(p, sphere);
    if (std::isfinite(than)) {
      EXPECT_EQ(compare_distance(p, sphere, than), told_by_digits(d.first, d.second, mpq_class(than) * than, 0));
    }
    EXPECT_EQ(compare_distance(sphere, p, -1.0), Sign::positive);
  });
  for (const int n : told) EXPECT_GT(n, 100);
}

TEST(ClosestTest, DistancesThatRoundAlikeStillCompare) {
  const Point3 far{0x1p60, 1, 0}, farther{0x1p60, 2, 0};
  const Segment3 unit{{-1, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(distance(far, unit), distance(farther, unit));
  EXPECT_EQ(compare_distance(far, unit, farther, unit), Sign::negative);
  EXPECT_EQ(compare_distance(far, unit, 0x1p60), Sign::positive);
  const Sphere3 at_four{{0, 0, 0}, 2};  // 3-4-5: five less two against three
  EXPECT_EQ(compare_distance(Point3{3, 4, 0}, at_four, Point3{0, 0, 3}, Point3{0, 0, 0}), Sign::zero);
  EXPECT_EQ(compare_distance(Point3{3, 4, 0}, at_four, 3.0), Sign::zero);
  EXPECT_EQ(compare_distance(Point3{3, 4, 0x1p-600}, at_four, 3.0), Sign::positive);
  EXPECT_EQ(distance(Point3{3, 4, 0x1p-600}, at_four), 3);
  const double most = std::numeric_limits<double>::max();
  const Sphere3 small{{-most, 0, 0}, 1};
  EXPECT_EQ(distance(Point3{most, 0, 0}, small), Interval::infinity);
  EXPECT_EQ(compare_distance(Point3{most, 0, 0}, small, Point3{most, 0, 0}, Point3{-most, 0, 0}), Sign::negative);
}

using enum FeatureKind;

// Their squares are at the end of the doubles, where products lose digits.
TEST(ClosestTest, TinyDistances) {
  const Segment3 s{{-1, 1, 1}, {0, 0, 0}};
  const Triangle3 t{{-1, 1, 1}, {0, 0, 0}, {-1, -1, 1}};
  for (int power = -540; power < -400; power += 3) {
    const double x = std::ldexp(0x1.23456789abcdfp0, power), y = std::ldexp(0x1.fedcba987654dp-1, power);
    const Point3 p{x, y, -x};
    EXPECT_EQ(distance(p, s), rounded_root(Rounding::nearest, squared_distance_exact(p, s))) << power;
    EXPECT_EQ(distance(p, t), rounded_root(Rounding::nearest, squared_distance_exact(p, t))) << power;
  }
}

// Figure 5.1: a plane through P with normal n, and a point below it.
TEST(ClosestTest, PlaneAndPoint) {
  const Closest c = closest_points(Point3{5, 1, -2}, Plane3{{0, 0, 3}, 3});
  EXPECT_EQ(c, (Closest{{5, 1, -2}, {5, 1, 1}, 3, {vertex, 0}, {face, 0}}));
  const Point3 oblique = closest_point(ThreePointPlane3{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0});
  EXPECT_EQ(oblique, (Point3{1.0 / 3, 1.0 / 3, 1.0 / 3}));
  EXPECT_EQ(squared_distance_exact(Point3{0, 0, 0}, ThreePointPlane3{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).text(), "1/3");
}

// Figure 5.2: beyond A, beside the segment, beyond B; and on the planes between.
TEST(ClosestTest, ThreeRegionsOfASegment) {
  const Segment2 s{{0, 0}, {4, 2}};
  const auto feature = [&](const Point2& p) { return closest_points(p, s).feature_b; };
  EXPECT_EQ(feature({-3, 1}), (Feature{vertex, 0}));
  EXPECT_EQ(feature({1, 4}), (Feature{edge, 0}));
  EXPECT_EQ(feature({9, 0}), (Feature{vertex, 1}));
  EXPECT_EQ(feature({-1, 2}), (Feature{vertex, 0}));
  EXPECT_EQ(feature({-1, std::nextafter(2.0, 3.0)}), (Feature{edge, 0}));
  EXPECT_EQ(closest_parameter(s, {1, 4}), 0.6);
  EXPECT_EQ(closest_parameter(s, {99, 4}), 1);
}

// Figure 5.3: an edge and a vertex of an axis-aligned box.
TEST(ClosestTest, AlignedBoxAndPoint) {
  const Aabb2 box{{0, 0}, {4, 2}};
  EXPECT_EQ(closest_points(Point2{2, 5}, box), (Closest2{{2, 5}, {2, 2}, 3, {vertex, 0}, {edge, 1}}));
  EXPECT_EQ(closest_points(Point2{7, 6}, box), (Closest2{{7, 6}, {4, 2}, 5, {vertex, 0}, {vertex, 3}}));
  EXPECT_EQ(closest_points(Point2{1, 1}, box), (Closest2{{1, 1}, {1, 1}, 0, {vertex, 0}, {face, 0}}));
}

// Figure 5.4: an oriented box; and the parallelepiped whose axes are not perpendicular, of which clamping along the
// axes finds another point.
TEST(ClosestTest, OrientedBoxAndPoint) {
  const Obb3 box{{1, 1, 0}, {{{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}}, {1, 0.5, 2}};
  EXPECT_EQ(closest_points(Point3{10, 13, 1}, box), (Closest{{10, 13, 1}, {4, 5, 1}, 10, {vertex, 0}, {face, 1}}));
  EXPECT_EQ(closest_points(Point3{10, 13, 7}, box).feature_b, (Feature{edge, 4 * 1 + 3}));
  const Obb2 sheared{{0, 0}, {{{1, 0}, {1, 1}}}, {1, 1}};  // corners (-2, -1), (0, -1), (0, 1), (2, 1)
  const Closest2 c = closest_points(Point2{3, -1}, sheared);
  EXPECT_EQ(squared_distance_exact(Point2{3, -1}, sheared).text(), "9/2");
  EXPECT_EQ(c.on_b, (Point2{1.5, 0.5}));
}

// Figures 5.5 and 5.6: a point beyond the line AB with its projection outside of AB, yet nearest to CA.
TEST(ClosestTest, TriangleWithAnObtuseCorner) {
  const Triangle2 t{{0, 0}, {4, 0}, {-8, 1}};
  const Closest2 c = closest_points(Point2{-3, -2}, t);
  EXPECT_EQ(c.feature_b, (Feature{edge, 2}));
  EXPECT_EQ(c.on_b, (Point2{-8 * 22.0 / 65, 22.0 / 65}));
  EXPECT_EQ(squared_distance_exact(Point2{-3, -2}, t).text(), "361/65");
}

// Figure 5.7: beside a face of a tetrahedron, beyond an edge; and inside.
TEST(ClosestTest, TetrahedronAndPoint) {
  const Tetrahedron3 t{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
  EXPECT_EQ(closest_points(Point3{4, 4, 4}, t), (Closest{{4, 4, 4}, {2, 2, 2}, std::sqrt(12), {vertex, 0}, {face, 0}}));
  EXPECT_EQ(closest_points(Point3{-3, 2, -4}, t), (Closest{{-3, 2, -4}, {0, 2, 0}, 5, {vertex, 0}, {edge, 1}}));
  EXPECT_EQ(closest_points(Point3{1, 1, 1}, t), (Closest{{1, 1, 1}, {1, 1, 1}, 0, {vertex, 0}, {interior, 0}}));
}

TEST(ClosestTest, ShapesThatAreLess) {
  EXPECT_EQ(closest_points(Point3{0, 3, 4}, Line3{{0, 0, 0}, {0, 0, 0}}).feature_b, (Feature{vertex, 0}));
  EXPECT_EQ(distance(Point3{0, 3, 4}, Triangle3{}), 5);
  const Rectangle3 rod{{0, 0, 0}, {{{1, 0, 0}, {2, 0, 0}}}, {1, -1}};  // of length six
  EXPECT_EQ(closest_point(rod, {9, 1, 0}), (Point3{3, 0, 0}));
  EXPECT_EQ(closest_point(rod, {2.5, 1, 0}), (Point3{2.5, 0, 0}));
  EXPECT_EQ(closest_points(Point3{1, 2, 3}, Plane3{{0, 0, 0}, 0}).feature_b, (Feature{interior, 0}));
  EXPECT_EQ(closest_point(Sphere3{{1, 1, 1}, 0}, {2, 1, 1}), (Point3{1, 1, 1}));
  const Point3 none = closest_point(Segment3{{-0.0, -0.0, -0.0}, {-0.0, 1, -0.0}}, {-0.0, -1, -0.0});
  EXPECT_FALSE(std::signbit(none.x) || std::signbit(none.y) || std::signbit(none.z));
}

// Of equally near features the lowest: the center of a square hole, and corners that are one place.
TEST(ClosestTest, TiesAreTheLowestFeatures) {
  const HoledPolygon2 frame{{{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}}, {{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}}};
  EXPECT_EQ(closest_points(Point2{0, 0}, frame).feature_b, (Feature{edge, 4}));
  EXPECT_EQ(closest_points(Point2{0, 3}, frame).feature_b, (Feature{face, 0}));
  EXPECT_EQ(closest_points(Point2{0, 0.5}, frame).on_b, (Point2{0, 1}));
  const Polygon2 bow{{{0, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 3}, {0, 3}}};
  EXPECT_EQ(closest_points(Point2{-1, -1}, bow).feature_b, (Feature{vertex, 0}));
}

TEST(ClosestTest, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(text_of<NonFinite>([&] {
                closest_points(Point3{0, nan, 0}, Segment3{});
              }),
              HasSubstr("closest_points: point.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                distance(Triangle3{{}, {}, {0, 0, inf}}, Point3{});
              }),
              HasSubstr("distance: triangle.c.z is inf"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                closest_point(Sphere3{{}, -1}, {1, 1, 1});
              }),
              HasSubstr("closest_point: sphere.radius is negative"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                squared_distance_exact(Point3{}, Aabb3{{0, 1, 0}, {1, 0, 1}});
              }),
              HasSubstr("squared_distance_exact: the box is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                distance(Point3{}, Polygon3{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}});
              }),
              HasSubstr("its vertex 3 is off the plane of the vertices 0, 1 and 2"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                distance(Point2{}, Polygon2{{{0, 0}, {1, 0}}});
              }),
              HasSubstr("polygon.vertices has 2 vertices"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                distance(Point3{}, Halfspace3{{0, 0, 0}, -1});
              }),
              HasSubstr("normal is zero"));
  EXPECT_THAT(text_of<InvalidShape>([&] { distance(Point3{}, ConvexPolyhedron3{}); }), HasSubstr("no faces"));
  EXPECT_THAT(text_of<NonFinite>([&] { compare_distance(Point3{}, Sphere3{}, nan); }), HasSubstr("compare_distance"));
}

// What doubles guess may be any corners, a direction alone among them, which has no weight to be a point by.
TEST(DifferenceSearch, EndsAtTheNearestPointFromAnyGuess) {
  using Guess = std::vector<arith::DifferenceCorner>;
  const arith::Difference<mpz_class> sets{{{{{3, 4, 0}, {9, 4, 0}}, {{0, 0, 0}}}}, {{-1, 0, 0}}};
  for (const Guess& guess : {Guess{{true, 0, 0}}, Guess{{true, 1, 0}}, Guess{{false, 0, 0}}, Guess{},
                             Guess{{true, 0, 0}, {true, 1, 0}, {false, 0, 0}}}) {
    arith::DifferenceSearch<mpz_class> search(sets, guess);
    while (search.step()) {
    }
    ASSERT_NE(search.whole(), 0);
    EXPECT_EQ(mpq_class(search.square(), search.whole() * search.whole()), 16);  // of (0, 4, 0)
  }
}

}  // namespace
}  // namespace plumb

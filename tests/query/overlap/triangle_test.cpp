// Triangles, tetrahedra and what is straight in space against a linear program in rationals.
#include <cmath>

#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/flat_lattices.hpp"
#include "query/overlap/wide_points.hpp"

namespace plumb {
namespace {

template <class Pair>
struct OverlapTriangle : testing::Test {};
template <class A, class B>
struct Of {
  using First = A;
  using Second = B;
};
using Pairs = testing::Types<Of<Line3, Triangle3>, Of<Ray3, Triangle3>, Of<Segment3, Triangle3>,
                             Of<Triangle3, Triangle3>, Of<Line3, Line3>, Of<Line3, Ray3>, Of<Line3, Segment3>,
                             Of<Ray3, Ray3>, Of<Ray3, Segment3>, Of<Segment3, Segment3>, Of<Segment3, Tetrahedron3>,
                             Of<Triangle3, Tetrahedron3>, Of<Tetrahedron3, Tetrahedron3>>;
TYPED_TEST_SUITE(OverlapTriangle, Pairs);

TYPED_TEST(OverlapTriangle, AgreesWithTheOracle) {
  expect_as_oracle<typename TypeParam::First, typename TypeParam::Second>(52, 1000);
}

TEST(OverlapTriangleCases, LatticesOfEveryWidth) {
  expect_as_oracle_on_lattices<Triangle3, Triangle3, 3>(61, 2000);
  expect_as_oracle_on_lattices<Segment3, Triangle3, 3>(62, 2000);
}

/// Points of a line or plane through the origin, or one unit from it, whose exponents lie up to so much apart; from the
/// fourth on they may be of one line alone.
template <std::size_t N>
std::array<double, 3 * N> far_exponents(Entropy& entropy, bool is_line, int apart, int scale) {
  std::array<std::array<std::int64_t, 3>, 2> along{};
  for (auto& vector : along) {
    for (auto& x : vector) x = entropy.within((std::int64_t{1} << 40) - 1);
  }
  if (const std::size_t axis = entropy.below(6); axis < 3) along[0][axis] = along[1][axis] = 0;  // of a plane across it
  const std::size_t straight_from = is_line ? 0 : entropy.below(3) == 0 ? 3 : N;
  std::array<double, 3 * N> all{};
  const std::size_t moved = entropy.below(3) == 0 ? entropy.below(3 * N) : 3 * N;
  for (std::size_t i = 0; i < N; ++i) {
    const std::int64_t u = entropy.within(7), v = i >= straight_from ? 0 : entropy.within(7);
    const int exponent = scale + static_cast<int>(entropy.below(static_cast<std::uint64_t>(apart) + 1));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t x = u * along[0][k] + v * along[1][k] + (3 * i + k == moved ? 1 : 0);
      all[3 * i + k] = std::ldexp(static_cast<double>(x), exponent);
    }
  }
  return all;
}

// Around the 61 bits of words and the 125 of wide lattices, with subnormal numbers and with large ones.
TEST(OverlapTriangleCases, ExponentsFarApart) {
  struct Triangles {
    Triangle3 a, b;
  };
  struct SegmentAndTriangle {
    Triangle3 t;
    Segment3 s;
  };
  Counts counts;
  int wide = 0, straight = 0, beyond = 0;
  constexpr std::array apart{17, 19, 60, 79, 81, 83, 85, 120};
  constexpr std::array scales{0, -1074, 850};
  const std::uint64_t cases = 1500 * shape_cases::more;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(67, i);
    const bool is_line = entropy.below(3) == 0;
    const int far = apart[entropy.below(apart.size())], scale = scales[entropy.below(scales.size())];
    const auto numbers = far_exponents<6>(entropy, is_line, far, scale);
    if (!query::LatticePoints<6, 3>(numbers).is_lattice()) {
      const query::WidePoints<6> points(numbers);
      const auto on_line = [&](std::size_t axis) { return query::is_straight(points, axis, (axis + 1) % 3); };
      wide += points.is_lattice() ? 1 : 0, beyond += points.is_lattice() ? 0 : 1;
      straight += points.is_lattice() && on_line(0) && on_line(1) && on_line(2) ? 1 : 0;
    }
    const auto [a, b] = std::bit_cast<Triangles>(numbers);
    const Relation expected = oracle::rational_relation(a, b);
    counts.add(expected);
    ASSERT_EQ(relate(a, b), expected) << "Entropy(67, " << i << ")";
    ASSERT_EQ(relate(b, a), expected) << "Entropy(67, " << i << ")";
    const auto [t, s] = std::bit_cast<SegmentAndTriangle>(far_exponents<5>(entropy, is_line, far, scale));
    const Relation of_segment = oracle::rational_relation(s, t);
    counts.add(of_segment);
    ASSERT_EQ(relate(s, t), of_segment) << "Entropy(67, " << i << ")";
  }
  std::printf("wide %d, straight %d, beyond %d; %d, %d, %d\n", wide, straight, beyond, counts.of[0], counts.of[1],
              counts.of[2]);
  EXPECT_GE(static_cast<std::uint64_t>(wide) * 4, cases);
  EXPECT_GE(static_cast<std::uint64_t>(straight) * 20, cases);
  EXPECT_GE(static_cast<std::uint64_t>(beyond) * 20, cases);
  expect_all_answers(counts, 2 * cases);
}

Triangle3 turned(const Triangle3& t) { return {t.c, t.a, t.b}; }
Triangle3 flipped(const Triangle3& t) { return {t.a, t.c, t.b}; }

void expect_in_any_order(const Triangle3& a, const Triangle3& b, Relation expected) {
  for (const Triangle3& p : {a, turned(a), turned(turned(a)), flipped(a)}) {
    for (const Triangle3& q : {b, turned(b), turned(turned(b)), flipped(b)}) {
      EXPECT_EQ(relate(p, q), expected);
      EXPECT_EQ(relate(q, p), expected);
    }
  }
}

// At any scale, and at one for each axis: subnormal, huge, far apart; where that rounds nothing.
void expect_relation(const Triangle3& a, const Triangle3& b, Relation expected) {
  expect_in_any_order(a, b, expected);
  for (const auto& scale : {std::array{0x1p-1074, 0x1p-1074, 0x1p-1074}, std::array{0x1p1018, 0x1p1018, 0x1p1018},
                            std::array{0x1p-370, 0x1p-350, 0x1p-340}, std::array{0x1p340, 0x1p350, 0x1p330},
                            std::array{0x1p-1074, 1.0, 0x1p1018}, std::array{0x1p1018, 0x1p-1000, 0x1p-1074}}) {
    const double x = scale[0], y = scale[1], z = scale[2];
    bool exact = true;
    const auto scaled = [&](const Point3& p) {
      const Point3 q{p.x * x, p.y * y, p.z * z};
      exact = exact && Point3{q.x / x, q.y / y, q.z / z} == p;
      return q;
    };
    const Triangle3 p{scaled(a.a), scaled(a.b), scaled(a.c)}, q{scaled(b.a), scaled(b.b), scaled(b.c)};
    if (exact) expect_in_any_order(p, q, expected);
  }
}

// RTCD figure 5.19: two edges of one triangle pierce the other, or one of each does; and what is between these.
TEST(OverlapTriangleCases, WaysOfTwoTrianglesToCross) {
  const Triangle3 floor{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  expect_relation(floor, {{1, 1, -1}, {2, 2, -1}, {2, 1, 3}}, Relation::overlapping);    // two edges of the second
  expect_relation(floor, {{1, 1, -1}, {9, 9, -1}, {1, 1, 3}}, Relation::overlapping);    // one of each
  expect_relation(floor, {{-9, 1, -1}, {20, 1, -1}, {1, 1, 9}}, Relation::overlapping);  // two edges of the first
  expect_relation(floor, {{1, 1, 0}, {2, 2, 3}, {2, 1, 3}}, Relation::touching);         // a corner in the inside
  expect_relation(floor, {{1, 1, 0}, {2, 2, 0}, {2, 1, 3}}, Relation::touching);         // an edge in the inside
  expect_relation(floor, {{4, 4, -1}, {4, 4, 1}, {9, 9, 0}}, Relation::touching);        // edge through edge
  expect_relation(floor, {{0, 0, 0}, {0, 0, 1}, {-1, -1, 0}}, Relation::touching);       // corner on corner
  expect_relation(floor, {{9, 0, 0}, {9, 1, 5}, {9, 2, -5}}, Relation::disjoint);        // crosses the plane, beside
  expect_relation(floor, {{5, 5, 0}, {5, 5, 1}, {6, 6, 0}}, Relation::disjoint);
  expect_relation(floor, {{1, 1, 1}, {2, 2, 1}, {2, 1, 3}}, Relation::disjoint);
}

TEST(OverlapTriangleCases, TrianglesOfOnePlane) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 8}, {0, 8, 8}};
  expect_relation(t, {{1, 1, 2}, {2, 1, 3}, {1, 2, 3}}, Relation::overlapping);    // within
  expect_relation(t, {{-1, 3, 2}, {9, 3, 12}, {4, 4, 8}}, Relation::overlapping);  // across
  expect_relation(t, {{4, 4, 8}, {9, 9, 18}, {9, 8, 17}}, Relation::touching);     // a corner on an edge
  expect_relation(t, {{0, 0, 0}, {-1, 0, -1}, {0, -1, -1}}, Relation::touching);
  expect_relation(t, {{8, 0, 8}, {0, 8, 8}, {8, 8, 16}}, Relation::touching);  // an edge for both
  expect_relation(t, {{5, 5, 10}, {9, 9, 18}, {9, 8, 17}}, Relation::disjoint);
  expect_relation(t, {{1, 1, 3}, {2, 1, 4}, {1, 2, 4}}, Relation::disjoint);  // parallel
  expect_relation(t, {{1, 1, 0x1.0000000000001p1}, {2, 1, 4}, {1, 2, 4}}, Relation::disjoint);
  expect_relation(t, {{1, 1, 2}, {2, 1, 4}, {1, 2, 4}}, Relation::touching);
}

TEST(OverlapTriangleCases, TheSameTriangleInAnyOrder) {
  // Short and long mantissas, far apart exponents, in planes of an axis; 0 as either zero.
  for (const auto& [a, b, c] :
       {Triangle3{{0, 0, 0}, {8, 0, 8}, {0, 8, 8}}, Triangle3{{0.1, 0.2, 0.3}, {1.7, 0.25, 0.1}, {0.3, 1.9, 0.7}},
        Triangle3{{0x1p-1074, 0, 1e300}, {1, 1e-300, 0}, {0, 0x1p600, 0}},
        Triangle3{{0.1, 3, 7}, {0.1, 5, 2}, {0.1, 4, 9}}, Triangle3{{0, 0, 0}, {0x1p-1074, 0, 0}, {0, 0, 0x1p1023}}}) {
    const Triangle3 orders[] = {{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}};
    for (const Triangle3& t : orders) expect_relation({a, b, c}, t, Relation::overlapping);
    expect_relation({a, b, c}, {a, b, a}, Relation::touching);  // an edge of it
    expect_relation({a, b, c}, {c, c, c}, Relation::touching);
  }
  expect_relation({{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, {{-0.0, 1, 1}, {1, 1, -0.0}, {1, -0.0, 1}}, Relation::overlapping);
}

TEST(OverlapTriangleCases, TrianglesThatShareACorner) {
  const Triangle3 a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto at_a = [](const Point3& p, const Point3& q) { return Triangle3{{0, 0, 0}, p, q}; };
  expect_relation(a, at_a({1, 1, 1}, {1, 2, 3}), Relation::touching);      // on one side
  expect_relation(a, at_a({1, 1, 1}, {1, 1, -1}), Relation::overlapping);  // across, forward
  expect_relation(a, at_a({-1, -1, 1}, {-1, -1, -1}), Relation::touching);
  expect_relation(a, at_a({-1, 2, 1}, {-1, 2, -1}), Relation::touching);  // a is on one side
  expect_relation(a, at_a({1, 1, 0}, {0, 0, 1}), Relation::touching);     // an edge across the inside
  expect_relation(a, at_a({1, 0, 1}, {1, 0, -1}), Relation::touching);    // across, along an edge
  expect_relation(a, at_a({1, 0, 0}, {0, 0, 1}), Relation::touching);
  expect_relation(a, at_a({-1, -1, 0}, {-1, 1, 0}), Relation::touching);  // in one plane
  expect_relation(a, at_a({-1, 2, 0}, {2, 2, 0}), Relation::overlapping);
  expect_relation(a, at_a({1, 1, 0}, {-1, -1, 0}), Relation::overlapping);  // a segment through the corner
  expect_relation(a, at_a({1, 1, 0}, {1, 1, 0}), Relation::overlapping);
}

TEST(OverlapTriangleCases, TrianglesThatShareAnEdge) {
  const Triangle3 a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  expect_relation(a, {{0, 0, 0}, {4, 0, 0}, {1, 1, 1}}, Relation::touching);
  expect_relation(a, {{0, 0, 0}, {4, 0, 0}, {1, -1, 0}}, Relation::touching);
  expect_relation(a, {{0, 0, 0}, {4, 0, 0}, {9, 1, 0}}, Relation::overlapping);  // folded onto one another
  expect_relation(a, {{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}, Relation::touching);     // a segment
  expect_relation(a, {{0, 0, 0}, {4, 0, 0}, {4, 0, 0}}, Relation::touching);
}

// Corners drawn from five points: of the materials, and of one plane but for a unit.
TEST(OverlapTriangleCases, CornersOfAFewPoints) {
  Counts counts;
  const auto check = [&](const std::array<Point3, 5>& points, const auto& below, const std::string& about) {
    const auto any = [&] { return points[static_cast<std::size_t>(below(5))]; };
    const Triangle3 a{any(), any(), any()}, b{any(), any(), any()};
    const Relation expected = oracle::rational_relation(a, b);
    counts.add(expected);
    EXPECT_EQ(relate(a, b), expected) << about;
    EXPECT_EQ(relate(b, a), expected) << about;
    EXPECT_EQ(relate(turned(a), flipped(b)), expected) << about;
  };
  shape_cases::on_shapes(64, 1500, [&](shape_cases::Material& m) {
    const std::array points{m.point3(), m.point3(), m.point3(), m.point3(), m.point3()};
    check(
        points, [&](int n) { return m.below(static_cast<std::size_t>(n)); }, m.about());
  });
  for (std::uint64_t i = 0; i < 1500 * shape_cases::more; ++i) {
    Entropy entropy(65, i);
    const auto points = std::bit_cast<std::array<Point3, 5>>(flat_lattice<5, 3>(66, i));
    check(
        points, [&](int n) { return entropy.below(static_cast<std::uint64_t>(n)); }, "66 index " + std::to_string(i));
  }
  expect_all_answers(counts, 3000 * shape_cases::more);
}

TEST(OverlapTriangleCases, TrianglesThatAreSegmentsOrPoints) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  expect_relation(t, {{1, 1, -1}, {1, 1, 0}, {1, 1, 1}}, Relation::overlapping);
  expect_relation(t, {{1, 1, 1}, {1, 1, 0}, {1, 1, 0}}, Relation::touching);
  expect_relation(t, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, Relation::overlapping);
  expect_relation(t, {{0, 0, 0}, {-0.0, 0, 0}, {0, 0, 0}}, Relation::touching);
  expect_relation({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 0, 2}, {1, 1, 1}, {2, 2, 0}}, Relation::overlapping);
  expect_relation({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{1, 1, 1}, {1, 1, 1}, {2, 2, 0}}, Relation::touching);
}

// RTCD figure 5.24: the line passes all edges on one side, or runs through an edge or a corner.
TEST(OverlapTriangleCases, LineRayAndSegmentThroughATriangle) {
  const Triangle3 t{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}};
  EXPECT_EQ(relate(Line3{{1, 1, 9}, {0, 0, 1}}, t), Relation::overlapping);
  EXPECT_EQ(relate(Line3{{3, 3, 9}, {0, 0, -1}}, t), Relation::touching);
  EXPECT_EQ(relate(Line3{{0, 0, 9}, {1, -1, 3}}, t), Relation::disjoint);
  EXPECT_EQ(relate(Ray3{{1, 1, 9}, {0, 0, 1}}, t), Relation::disjoint);
  EXPECT_EQ(relate(Ray3{{1, 1, 0}, {0, 0, 1}}, t), Relation::touching);
  EXPECT_EQ(relate(Ray3{{1, 1, 0}, {1, 0, 0}}, t), Relation::overlapping);  // in the plane
  EXPECT_EQ(relate(Ray3{{-1, 0, 0}, {1, 0, 0}}, t), Relation::touching);    // along an edge
  EXPECT_EQ(relate(Ray3{{1, 1, 0}, {0, 0, 0}}, t), Relation::overlapping);  // the point it is
  EXPECT_EQ(relate(Segment3{{1, 1, -1}, {1, 1, -0x1p-1074}}, t), Relation::disjoint);
  EXPECT_EQ(relate(Segment3{{1, 1, -1}, {1, 1, 0x1p-1074}}, t), Relation::overlapping);
  EXPECT_EQ(relate(Segment3{{1, 1, -1}, {1, 1, -0.0}}, t), Relation::touching);
}

TEST(OverlapTriangleCases, NamesWhatIsNoNumber) {
  const double nan = std::nan("");
  const Triangle3 far{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}};
  for (const Triangle3& a :
       {Triangle3{{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, Triangle3{{0, 0, 0}, {1, INFINITY, 0}, {0, 1, 0}}}) {
    EXPECT_THROW(relate(a, a), NonFinite);
    try {
      relate(far, a);
      FAIL();
    } catch (const NonFinite& e) {
      EXPECT_EQ(std::string(e.what()).rfind("relate: b.b.y is ", 0), 0u) << e.what();
    }
    EXPECT_THROW(relate(a, far), NonFinite);
    EXPECT_THROW(relate(Segment3{{0, 0, 5}, {1, 1, 6}}, a), NonFinite);
    EXPECT_THROW(relate(a, Tetrahedron3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), NonFinite);
  }
}

}  // namespace
}  // namespace plumb

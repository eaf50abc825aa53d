// Closest points of lines, rays, segments and triangles against brute force in rationals, and under their laws.
#include "plumb/query/closest/pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "figure/basic/thrown.hpp"
#include "oracle/straight.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/closest/straight_cases.hpp"
#include "query/closest/straight_oracle.hpp"

namespace plumb {
namespace {

using straight_oracle::Pair;

bool nearest(double x, const mpq_class& q) {
  return std::isinf(x) ? straight_oracle::overflows(q) : straight_oracle::is_nearest(x + 0.0, q);
}
template <class Point>
bool nearest_point(const Point& p, const straight_oracle::Vector& q) {
  const auto x = coordinates(p);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!nearest(x[i], q[i])) return false;
  }
  return true;
}
bool nearest_root(double d, const mpq_class& square) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::isinf(d) ? square > mpq_class(largest) * largest : straight_oracle::is_nearest_root(d, square);
}

std::string text(const Feature& f) {
  return std::string(1, "vefi"[static_cast<int>(f.kind)]).append(std::to_string(f.index));
}

constexpr Feature vertex_of(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge_of(std::uint32_t i) { return {FeatureKind::edge, i}; }

template <class A, class B>
void expect_closest(const A& a, const B& b, Tally& tally) {
  const Pair truth = straight_oracle::closest(a, b);
  const auto c = closest_points(a, b);
  const std::string features = text(truth.a).append("-").append(text(truth.b));
  EXPECT_EQ(text(c.feature_a).append("-").append(text(c.feature_b)), features);
  EXPECT_TRUE(nearest_point(c.on_a, truth.on_a));
  EXPECT_TRUE(nearest_point(c.on_b, truth.on_b));
  EXPECT_TRUE(nearest_root(c.distance, truth.square)) << c.distance;
  EXPECT_EQ(distance(a, b), c.distance);
  EXPECT_TRUE(squared_distance_exact(a, b) == Rational(BigRational{truth.square}));
  if constexpr (LinearPair<A, B>) {
    const auto [s, t] = closest_parameters(a, b);
    EXPECT_TRUE(!truth.s || nearest(s, *truth.s)) << s;
    EXPECT_TRUE(!truth.t || nearest(t, *truth.t)) << t;
  }
  tally.add(std::string(1, features[0]).append(1, features[3]));
  tally.add(truth.square == 0 ? "meet" : "apart");
}

/// Every way to name the corners of a shape.
template <class S>
std::vector<S> renamed(const S& s) {
  if constexpr (requires { s.c; }) {
    return {{s.b, s.c, s.a}, {s.c, s.b, s.a}, {s.a, s.c, s.b}};
  } else if constexpr (requires { s.a; }) {
    return {{s.b, s.a}};
  } else {
    return {s};
  }
}
template <class A, class B>
void expect_same_however_named(const A& a, const B& b) {
  const auto c = closest_points(a, b);
  EXPECT_EQ(swapped(closest_points(b, a)), c);
  for (const A& p : renamed(a)) {
    for (const B& q : renamed(b)) {
      const auto d = closest_points(p, q);
      EXPECT_EQ(d.on_a, c.on_a);
      EXPECT_EQ(d.on_b, c.on_b);
      EXPECT_EQ(d.distance, c.distance);
      EXPECT_EQ(d.feature_a.kind, c.feature_a.kind);
      EXPECT_EQ(d.feature_b.kind, c.feature_b.kind);
    }
  }
}

/// The comparison with the rounded distance and its neighbors is that of the exact square.
template <class A, class B>
void expect_compared(const A& a, const B& b) {
  const Rational square = squared_distance_exact(a, b);
  const double d = distance(a, b);
  if (std::isinf(d)) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double than : {std::nextafter(d, 0.0), d, std::nextafter(d, infinity), d / 2, d * 2, 0.0, 1.0}) {
    if (!std::isfinite(than)) continue;
    EXPECT_EQ(compare_distance(a, b, than), (square - Rational(than) * Rational(than)).sign());
  }
  EXPECT_EQ(compare_distance(a, b, -1.0), Sign::positive);
}

/// CGAL's answer, where it has the pair and the shapes are none of those it refuses.
template <class A, class B>
void expect_as_cgal(const A& a, const B& b) {
  if constexpr (requires { oracle::squared_distance(a, b); }) {
    if (straight_oracle::is_flat(a) || straight_oracle::is_flat(b)) return;
    // CGAL 5.5 answers 0 for a segment on the line of a ray, behind it and pointing away: Entropy(11, 4644).
    if constexpr (std::is_same_v<A, Ray3> && std::is_same_v<B, Segment3>) {
      if (straight_oracle::are_parallel(straight_oracle::way_of(a), straight_oracle::way_of(b))) return;
    }
    EXPECT_TRUE(squared_distance_exact(a, b) == oracle::squared_distance(a, b));
  }
}

template <class A, class B>
void run_pair(std::uint64_t start, std::initializer_list<const char*> must_be_seen) {
  Tally tally;
  for (std::uint64_t i = 0; i < straight_case_count; ++i) {
    Entropy entropy(start, i);
    const auto [a, b] = straight_case<A, B>(entropy);
    expect_closest(a, b, tally);
    if (i % 4 == 0) {
      expect_same_however_named(a, b);
      expect_compared(a, b);
      expect_as_cgal(a, b);
    }
    if (testing::Test::HasFailure()) {
      FAIL() << "replay: Entropy(" << start << ", " << i << ")\n" << shape_text(a) << "\n" << shape_text(b);
    }
  }
  for (const char* answer : must_be_seen) EXPECT_GT(tally.count(answer), 0) << answer << " is not represented";
}

TEST(ClosestPairs, LinesInThePlane) { run_pair<Line2, Line2>(1, {"ee", "vv", "ev", "meet", "apart"}); }
TEST(ClosestPairs, LineAndRayInThePlane) { run_pair<Line2, Ray2>(2, {"ee", "ev", "meet", "apart"}); }
TEST(ClosestPairs, LineAndSegmentInThePlane) { run_pair<Line2, Segment2>(3, {"ee", "ev", "meet", "apart"}); }
TEST(ClosestPairs, RaysInThePlane) { run_pair<Ray2, Ray2>(4, {"ee", "ev", "ve", "vv", "meet", "apart"}); }
TEST(ClosestPairs, RayAndSegmentInThePlane) { run_pair<Ray2, Segment2>(5, {"ee", "ev", "ve", "vv", "meet", "apart"}); }
TEST(ClosestPairs, SegmentsInThePlane) { run_pair<Segment2, Segment2>(6, {"ee", "ev", "ve", "vv", "meet", "apart"}); }
TEST(ClosestPairs, Lines) { run_pair<Line3, Line3>(7, {"ee", "vv", "ev", "meet", "apart"}); }
TEST(ClosestPairs, LineAndRay) { run_pair<Line3, Ray3>(8, {"ee", "ev", "meet", "apart"}); }
TEST(ClosestPairs, LineAndSegment) { run_pair<Line3, Segment3>(9, {"ee", "ev", "meet", "apart"}); }
TEST(ClosestPairs, Rays) { run_pair<Ray3, Ray3>(10, {"ee", "ev", "ve", "vv", "meet", "apart"}); }
TEST(ClosestPairs, RayAndSegment) { run_pair<Ray3, Segment3>(11, {"ee", "ev", "ve", "vv", "meet", "apart"}); }
TEST(ClosestPairs, Segments) { run_pair<Segment3, Segment3>(12, {"ee", "ev", "ve", "vv", "meet", "apart"}); }

constexpr auto with_triangle = {"ev", "ve", "vv", "vf", "ef", "ee", "meet", "apart"};
TEST(ClosestPairs, LineAndTriangle) { run_pair<Line3, Triangle3>(13, {"ev", "ee", "ef", "meet", "apart"}); }
TEST(ClosestPairs, RayAndTriangle) { run_pair<Ray3, Triangle3>(14, with_triangle); }
TEST(ClosestPairs, SegmentAndTriangle) { run_pair<Segment3, Triangle3>(15, with_triangle); }
TEST(ClosestPairs, Triangles) { run_pair<Triangle3, Triangle3>(16, with_triangle); }
TEST(ClosestPairs, LineAndTriangleInThePlane) { run_pair<Line2, Triangle2>(17, {"ev", "ee", "meet", "apart"}); }
TEST(ClosestPairs, RayAndTriangleInThePlane) { run_pair<Ray2, Triangle2>(18, {"ve", "vf", "ev", "ee", "vv"}); }
TEST(ClosestPairs, SegmentAndTriangleInThePlane) { run_pair<Segment2, Triangle2>(19, {"ve", "vf", "ev", "ee", "vv"}); }
TEST(ClosestPairs, TrianglesInThePlane) { run_pair<Triangle2, Triangle2>(20, {"ve", "vf", "ev", "ee", "vv", "fv"}); }

/// Nothing special, but for how far they are from the origin and from being parallel or near: pairs of doubles tell
/// nearly all.
TEST(ClosestPairs, OfUniformShapes) {
  Tally segments, lines, triangles;
  for (std::uint64_t i = 0; i < straight_case_count; ++i) {
    Entropy e(41, i);
    const double far = e.coin() ? 0 : std::ldexp(1.0, static_cast<int>(e.below(40)));
    const auto point = [&](double size) {
      const double x = signed_unit_coordinate(e), y = signed_unit_coordinate(e), z = signed_unit_coordinate(e);
      return Point3{far + size * x, size * y, far + size * z};
    };
    const auto near = [&](const Point3& p, const Point3& from, const Point3& to) {
      const double size = std::ldexp(1.0, -static_cast<int>(e.below(60)));
      const double x = signed_unit_coordinate(e), y = signed_unit_coordinate(e), z = signed_unit_coordinate(e);
      return Point3{p.x + (to.x - from.x) + size * x, p.y + (to.y - from.y) + size * y,
                    p.z + (to.z - from.z) + size * z};
    };
    const Point3 a = point(1), b = point(1), d = point(1);
    const Point3 c = e.coin() ? point(1) : near(a, a, b), f = e.coin() ? point(4) : near(c, a, b);
    const auto line = [](const Point3& p, const Point3& q) { return Line3{p, {q.x - p.x, q.y - p.y, q.z - p.z}}; };
    expect_closest(Segment3{a, b}, Segment3{c, f}, segments);
    expect_closest(line(a, b), line(c, f), lines);
    if (i % 4 == 0) expect_closest(Triangle3{a, b, d}, Triangle3{c, f, point(2)}, triangles);
    if (testing::Test::HasFailure()) FAIL() << "replay: Entropy(41, " << i << ")";
  }
  for (const char* answer : {"ee", "ev", "ve", "vv"}) {
    EXPECT_GT(segments.count(answer), 0) << answer;
    EXPECT_GT(triangles.count(answer), 0) << answer;
  }
  EXPECT_GT(lines.count("ee"), 0);
}

/// Multiplied by a power of two, and moved by integers.
template <class S>
S moved(const S& s, double factor, double x, double y) {
  const auto point = [&](const Point3& p) { return Point3{factor * p.x + x, factor * p.y + y, factor * p.z - x}; };
  if constexpr (requires { s.c; }) {
    return {point(s.a), point(s.b), point(s.c)};
  } else {
    return {point(s.a), point(s.b)};
  }
}

template <class A, class B>
void run_moves(std::uint64_t start) {
  for (std::uint64_t i = 0; i < straight_case_count / 4; ++i) {
    Entropy entropy(start, i);
    const auto integer = [&] { return static_cast<double>(entropy.within(9)); };
    const auto point = [&] { return Point3{integer(), integer(), integer()}; };
    const auto shape = [&]<class S>(const S*) {
      if constexpr (requires(S s) { s.c; }) {
        return S{point(), point(), point()};
      } else {
        return S{point(), point()};
      }
    };
    const A a = shape(static_cast<const A*>(nullptr));
    const B b = shape(static_cast<const B*>(nullptr));
    const Closest c = closest_points(a, b);
    const double factor = std::ldexp(1.0, static_cast<int>(entropy.within(400)));
    const Closest d = closest_points(moved(a, factor, 0, 0), moved(b, factor, 0, 0));
    EXPECT_EQ(d.on_a, (Point3{factor * c.on_a.x, factor * c.on_a.y, factor * c.on_a.z}));
    EXPECT_EQ(d.distance, factor * c.distance);
    EXPECT_EQ(d.feature_a, c.feature_a);
    EXPECT_EQ(d.feature_b, c.feature_b);
    const Closest e = closest_points(moved(a, 1, 5, -7), moved(b, 1, 5, -7));
    EXPECT_EQ(e.distance, c.distance);
    EXPECT_EQ(e.feature_a, c.feature_a);
    EXPECT_EQ(e.feature_b, c.feature_b);
    if (testing::Test::HasFailure()) FAIL() << "replay: Entropy(" << start << ", " << i << ")";
  }
}
TEST(ClosestPairs, PowersOfTwoAndTranslationsChangeNothing) {
  run_moves<Segment3, Segment3>(31);
  run_moves<Segment3, Triangle3>(32);
  run_moves<Triangle3, Triangle3>(33);
}

template <class A, class B>
std::string features(const A& a, const B& b) {
  const auto c = closest_points(a, b);
  return text(c.feature_a).append("-").append(text(c.feature_b));
}

// Figure 5.8: the vector between the closest points is perpendicular to both lines.
TEST(ClosestPairs, LinesHaveACommonNormal) {
  const Line3 p{{0, 0, 0}, {2, 0, 0}}, q{{5, 1, 3}, {0, -4, 0}};
  const Closest c = closest_points(p, q);
  EXPECT_EQ(c.on_a, (Point3{5, 0, 0}));
  EXPECT_EQ(c.on_b, (Point3{5, 0, 3}));
  EXPECT_EQ(c.distance, 3);
  EXPECT_EQ(closest_parameters(p, q), (std::array{2.5, 0.25}));
  const Line3 parallel{{7, 3, 4}, {-6, 0, 0}};  // of the given points 0 comes before 7
  EXPECT_EQ(closest_points(p, parallel), (Closest{{0, 0, 0}, {0, 3, 4}, 5, edge_of(0), edge_of(0)}));
  EXPECT_EQ(closest_points(parallel, p), swapped(closest_points(p, parallel)));
}

// Figure 5.9: inside both, inside one, at two ends.
TEST(ClosestPairs, EndsAndInsidesOfSegments) {
  const Segment3 p{{0, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(features(p, Segment3{{2, -1, 1}, {2, 1, 1}}), "e0-e0");
  EXPECT_EQ(features(p, Segment3{{2, 1, 1}, {2, 5, 1}}), "e0-v0");
  EXPECT_EQ(features(p, Segment3{{6, -1, 1}, {6, 1, 1}}), "v1-e0");
  EXPECT_EQ(features(p, Segment3{{-1, 7, 1}, {-1, 2, 1}}), "v0-v1");
}

// Figure 5.10: the lines meet outside of AB; or outside of CD.  Clamping one parameter moves the other.
TEST(ClosestPairs, LinesThatMeetBeyondASegment) {
  const Segment2 ab{{0, 0}, {4, 0}};
  EXPECT_EQ(features(ab, Segment2{{5, -1}, {5, 1}}), "v1-e0");
  EXPECT_EQ(features(ab, Segment2{{2, 1}, {2, 3}}), "e0-v0");
  // Their lines meet at (7, 0), beyond b, and before that c is the nearest: not the point that b projects to.
  const Segment2 cd{{6, 1}, {5, 2}};
  EXPECT_EQ(closest_points(ab, cd), (Closest2{{4, 0}, {5.5, 1.5}, std::sqrt(4.5), vertex_of(1), edge_of(0)}));
  const Segment2 near{{3, 1}, {2, 9}};  // the lines meet inside of ab, below c
  EXPECT_EQ(closest_points(ab, near), (Closest2{{3, 0}, {3, 1}, 1, edge_of(0), vertex_of(0)}));
  const Segment2 crossing{{1, -1}, {4, 2}};
  EXPECT_EQ(closest_points(ab, crossing), (Closest2{{2, 0}, {2, 0}, 0, edge_of(0), edge_of(0)}));
}

// Figure 5.11: an end over the inside, or the segment and an edge.
TEST(ClosestPairs, SegmentAndTriangleByEndOrEdge) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  EXPECT_EQ(features(Segment3{{2, 2, 3}, {2, 3, 9}}, t), "v0-f0");
  EXPECT_EQ(features(Segment3{{2, -1, -5}, {3, -1, 5}}, t), "e0-e0");
  EXPECT_EQ(features(Segment3{{2, 2, 3}, {2, 3, -9}}, t), "e0-f0");
}

// Figure 5.12: the closest points of two triangles lie on two edges, or one is a corner.
TEST(ClosestPairs, TrianglesByEdgesOrCorner) {
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  EXPECT_EQ(features(t, Triangle3{{1, 1, 2}, {1, 5, 9}, {5, 1, 9}}), "f0-v0");
  EXPECT_EQ(features(t, Triangle3{{3, -1, -4}, {4, -1, 5}, {3, -6, 0}}), "e0-e0");
  EXPECT_EQ(features(t, Triangle3{{-3, -1, 4}, {-3, -5, 5}, {-3, -6, 0}}), "v0-e2");
}

TEST(ClosestPairs, OfParallelSegmentsTheFirstPair) {
  const Segment3 p{{0, 0, 0}, {9, 0, 0}}, q{{12, 0, 2}, {4, 0, 2}};
  EXPECT_EQ(closest_points(p, q), (Closest{{4, 0, 0}, {4, 0, 2}, 2, edge_of(0), vertex_of(1)}));
  const Segment3 on_p{{2, 0, 0}, {5, 0, 0}};  // they overlap: the first of the points that they share
  EXPECT_EQ(closest_points(p, on_p), (Closest{{2, 0, 0}, {2, 0, 0}, 0, edge_of(0), vertex_of(0)}));
}

TEST(ClosestPairs, NoAnswerHasANegativeZero) {
  for (const double k : {1.0, 0x1p-1030}) {
    const Segment3 s{{-0.0, 0, 0}, {-k, 0, k / 4}};
    const Segment3 other{{k, 0, 0}, {2 * k, k, 0}};
    const Triangle3 t{{k, 0, 0}, {2 * k, k, 0}, {3 * k, 0, k}};
    EXPECT_FALSE(std::signbit(closest_points(s, other).on_a.x)) << k;
    EXPECT_FALSE(std::signbit(closest_points(s, t).on_a.x)) << k;
    EXPECT_FALSE(std::signbit(closest_points(t, s).on_b.x)) << k;
  }
}

TEST(ClosestPairs, DegenerateShapesAreTheSetsTheyAre) {
  EXPECT_EQ(features(Line3{{1, 1, 1}, {0, 0, 0}}, Segment3{{0, 0, 0}, {4, 0, 0}}), "v0-e0");
  EXPECT_EQ(features(Segment3{{1, 1, 1}, {1, 1, 1}}, Segment3{{0, 0, 0}, {4, 0, 0}}), "v0-e0");
  const Triangle3 flat{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(features(Segment3{{5, 1, 0}, {5, 2, 0}}, flat), "v0-e0");  // edges ab and bc hold the point
  EXPECT_EQ(features(Segment3{{4, 1, 0}, {4, 2, 0}}, flat), "v0-v2");
}

TEST(ClosestPairs, WhatIsNoNumberIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle3 t{{0, 0, 0}, {8, 0, 0}, {0, nan, 0}};
  const Segment3 s{{0, 0, 1}, {1, 1, 1}};
  EXPECT_EQ(text_of<NonFinite>([&] { closest_points(s, t); }).find("closest_points: triangle.c.y is nan"), 0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              distance(Ray3{{0, 0, nan}, {1, 0, 0}}, s);
            }).find("distance: ray.origin.z is nan"),
            0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              distance(Line3{{0, 0, nan}, {0, 0, 0}}, Line3{{0, 0, 0}, {0, 0, 0}});
            }).find("distance: a.point.z is nan"),
            0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              squared_distance_exact(Segment2{{0, 0}, {1 / 0.0, 0}}, Segment2{});
            }).find("squared_distance_exact: a.b.x is inf"),
            0u);
}

}  // namespace
}  // namespace plumb

// Closest points of lines, rays, segments and triangles against brute force in rationals, and under their laws.
#include "plumb/query/closest_pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "plumb/arith/big.hpp"
#include "query/straight_cases.hpp"
#include "query/straight_oracle.hpp"

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

template <class A, class B>
void run_pair(std::uint64_t start, std::initializer_list<const char*> must_be_seen) {
  Tally tally;
  for (std::uint64_t i = 0; i < straight_case_count; ++i) {
    Entropy entropy(start, i);
    const auto [a, b] = straight_case<A, B>(entropy);
    expect_closest(a, b, tally);
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

}  // namespace
}  // namespace plumb

// Every mix of points as given, crossings, points on segments and posed points in orient2d; a sample of mixes in
// incircle.  Against rationals and CGAL, which construct the points.
#include "certify/implicit/cases.hpp"

namespace plumb::implicit_cases {
namespace {

constexpr auto ask_orient = [](const auto& a, const auto& b, const auto& c) { return orient2d(a, b, c); };
constexpr auto ask_circle = [](const auto& a, const auto& b, const auto& c, const auto& d) {
  return incircle(a, b, c, d);
};

#if defined(PLUMB_LONG_TESTS)
constexpr std::uint64_t cases = 200'000;
#else
const std::uint64_t cases = battery::fitting<std::uint64_t>(2'000);
#endif

template <class First, class Second>
void orient2d_with_any_third() {
  check_all<First, Second, LineLinePoint2>(Question::orient, ask_orient, cases);
  check_all<First, Second, SegmentPoint2>(Question::orient, ask_orient, cases);
  check_all<First, Second, Posed<Point2, Pose2>>(Question::orient, ask_orient, cases);
  check_all<First, Second, Point2>(Question::orient, ask_orient, cases);
}

template <class First>
void orient2d_with_any_others() {
  orient2d_with_any_third<First, Point2>();
  orient2d_with_any_third<First, LineLinePoint2>();
  orient2d_with_any_third<First, SegmentPoint2>();
  orient2d_with_any_third<First, Posed<Point2, Pose2>>();
}

TEST(ImplicitPlane, Orient2dOfAPointAsGivenAndAnyTwo) { orient2d_with_any_others<Point2>(); }
TEST(ImplicitPlane, Orient2dOfACrossingAndAnyTwo) { orient2d_with_any_others<LineLinePoint2>(); }
TEST(ImplicitPlane, Orient2dOfAPointOnASegmentAndAnyTwo) { orient2d_with_any_others<SegmentPoint2>(); }
TEST(ImplicitPlane, Orient2dOfAPosedPointAndAnyTwo) { orient2d_with_any_others<Posed<Point2, Pose2>>(); }

TEST(ImplicitPlane, InCircle) {
  using E = Point2;
  using L = LineLinePoint2;
  using S = SegmentPoint2;
  using P = Posed<Point2, Pose2>;
  check_all<L, E, E, E>(Question::in_sphere, ask_circle, cases);
  check_all<E, E, E, L>(Question::in_sphere, ask_circle, cases);
  check_all<E, S, L, E>(Question::in_sphere, ask_circle, cases);
  check_all<S, P, E, E>(Question::in_sphere, ask_circle, cases);
  check_all<L, S, P, L>(Question::in_sphere, ask_circle, cases);
  check_all<L, L, L, E>(Question::in_sphere, ask_circle, cases);
  check_all<L, L, L, L>(Question::in_sphere, ask_circle, cases);
  check_all<S, S, S, S>(Question::in_sphere, ask_circle, cases);
  check_all<P, P, P, P>(Question::in_sphere, ask_circle, cases);
}

}  // namespace
}  // namespace plumb::implicit_cases

// What has no point or is no number throws, naming the argument and why; nothing else does.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/arith/error.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

template <class Failure, class Ask>
std::string told(Ask ask) {
  try {
    ask();
  } catch (const Failure& e) {
    return e.what();
  }
  return "nothing";
}

constexpr Point2 o2{0, 0}, x2{1, 0}, y2{0, 1};
constexpr Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, xy{1, 1, 0};
TEST(DegeneratePointTest, SaysWhyLinesDoNotCross) {
  const auto ask = [](const LineLinePoint2& p) { return told<DegeneratePoint>([&] { orient2d(o2, p, x2); }); };
  EXPECT_EQ(ask({o2, o2, x2, y2}),
            "orient2d: argument b has no point: its line ab has no length; give different points");
  EXPECT_EQ(ask({o2, x2, y2, y2}),
            "orient2d: argument b has no point: its line cd has no length; give different points");
  EXPECT_EQ(ask({o2, x2, y2, {5, 1}}), "orient2d: argument b has no point: its lines ab and cd are parallel");
  EXPECT_EQ(ask({o2, x2, {2, 0}, {5, 0}}), "orient2d: argument b has no point: its lines ab and cd are the same line");
  // Parallel exactly, with slopes that doubles can but just hold; an ulp more and they cross.
  const double odd = 1 + 0x1p-51;
  EXPECT_EQ(ask({o2, {1, odd}, x2, {4, 3 * odd}}),
            "orient2d: argument b has no point: its lines ab and cd are parallel");
  EXPECT_EQ(ask({o2, {1, odd}, x2, {4, std::nextafter(3 * odd, 4)}}), "nothing");
}

TEST(DegeneratePointTest, SaysWhyLineAndPlaneDoNotMeet) {
  const auto ask = [](const LinePlanePoint3& p) { return told<DegeneratePoint>([&] { insphere(o, x, y, z, p); }); };
  EXPECT_EQ(ask({o, o, x, y, z}),
            "insphere: argument e has no point: its line pq has no length; give different points");
  EXPECT_EQ(ask({o, xy, x, x, z}),
            "insphere: argument e has no point: its points a, b, c are collinear and span no plane");
  EXPECT_EQ(ask({z, {3, 7, 1}, x, y, o}),
            "insphere: argument e has no point: its line pq is parallel to the plane abc");
  EXPECT_EQ(ask({o, xy, x, y, {5, 5, 0}}), "insphere: argument e has no point: its line pq lies in the plane abc");
  EXPECT_EQ(ask({o, xy, x, y, z}), "nothing");
}

TEST(DegeneratePointTest, SaysWhyPlanesDoNotMeet) {
  const auto ask = [](const ThreePlanePoint3& p) { return told<DegeneratePoint>([&] { orient3d(p, x, y, z); }); };
  const std::array<Point3, 3> floor{o, x, y}, front{o, x, z}, side{o, y, z}, line{o, xy, Point3{3, 3, 0}};
  const std::array<Point3, 3> slope{x, Point3{2, 0, 0}, Point3{0, 1, 1}};
  EXPECT_EQ(ask({floor, front, side}), "nothing");
  EXPECT_EQ(ask({line, front, side}), "orient3d: argument a has no point: the points of its first plane are collinear");
  EXPECT_EQ(ask({floor, line, side}),
            "orient3d: argument a has no point: the points of its second plane are collinear");
  EXPECT_EQ(ask({floor, front, line}),
            "orient3d: argument a has no point: the points of its third plane are collinear");
  EXPECT_EQ(ask({floor, front, slope}),
            "orient3d: argument a has no point: its three planes are all parallel to one line");
  EXPECT_EQ(ask({floor, front, floor}),
            "orient3d: argument a has no point: its three planes are all parallel to one line");
}

TEST(DegeneratePointTest, IsToldByOrderAndApproximation) {
  const LineLinePoint2 none{o2, x2, y2, {5, 1}};
  EXPECT_EQ(told<DegeneratePoint>([&] { compare_xy(o2, none); }),
            "compare: argument b has no point: its lines ab and cd are parallel");
  EXPECT_EQ(told<DegeneratePoint>([&] { approximate(none); }),
            "approximate: argument a has no point: its lines ab and cd are parallel");
  // A polynomial that has a sign all the same: the weight is looked at first.
  EXPECT_EQ(told<DegeneratePoint>([&] { orient2d(none, o2, y2); }),
            "orient2d: argument a has no point: its lines ab and cd are parallel");
}

TEST(NonFiniteTest, IsNamedInEveryKind) {
  const auto told2 = [](const auto& p) { return told<NonFinite>([&] { incircle(o2, x2, p, y2); }); };
  const auto told3 = [](const auto& p) { return told<NonFinite>([&] { orient3d(p, x, y, z); }); };
  const std::string rest = ", not a real number; give a finite double";
  EXPECT_EQ(told2(LineLinePoint2{o2, x2, {0, nan}, y2}), "incircle: c.c.y is nan" + rest);
  EXPECT_EQ(told2(SegmentPoint2{o2, {1, -infinity}, 0}), "incircle: c.b.y is -inf" + rest);
  EXPECT_EQ(told2(SegmentPoint2{o2, x2, infinity}), "incircle: c.t is inf" + rest);
  EXPECT_EQ(told2(Posed{Point2{nan, 0}, Pose2{{{{1, 0}, {0, 1}}}, {0, 0}}}), "incircle: c.shape.x is nan" + rest);
  EXPECT_EQ(told2(Posed{o2, Pose2{{{{1, 0}, {nan, 1}}}, {0, 0}}}), "incircle: c.pose.columns[1].x is nan" + rest);
  EXPECT_EQ(told3(LinePlanePoint3{o, {0, 0, infinity}, x, y, z}), "orient3d: a.q.z is inf" + rest);
  EXPECT_EQ(told3(ThreePlanePoint3{{o, x, y}, {o, x, {nan, 1, 1}}, {o, y, z}}),
            "orient3d: a.second[2].x is nan" + rest);
  EXPECT_EQ(told3(SegmentPoint3{o, x, nan}), "orient3d: a.t is nan" + rest);
  EXPECT_EQ(told3(Posed{o, Pose{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, nan, 0}}}),
            "orient3d: a.pose.translation.y is nan" + rest);
  EXPECT_EQ(told<NonFinite>([&] {
              orient2d(Point2{0, nan}, o2, LineLinePoint2{x2, o2, y2, x2});
            }),
            "orient2d: a.y is nan" + rest);
}

}  // namespace
}  // namespace plumb

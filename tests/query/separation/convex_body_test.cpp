// Bodies: their corners against what the figures say in rationals, as they stand and under poses; what is no body, by name.
#include "query/separation/convex_body.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "plumb/query/separation/separation.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

using Exact = arith::Vec<mpq_class>;

template <class Shape>
Body body(const Shape& s) {
  return body_of("asked", "it", body_view(s));
}

constexpr Pose skew{{{{2, 1, 0}, {0, 3, 0.5}, {-1, 0, 0.1}}}, {10, -20, 0.3}};

Exact posed_exactly(const Exact& p) {
  const auto& [c, t] = skew;
  return arith::vec<mpq_class>(c[0]) * p.x + arith::vec<mpq_class>(c[1]) * p.y + arith::vec<mpq_class>(c[2]) * p.z +
         arith::vec<mpq_class>(t);
}

template <class Shape>
void expect_posed(const Shape& s, std::size_t corners) {
  const Posed<Shape> posed{s, skew};  // bodies refer to it
  const Body standing = body(s), moved = body(posed);
  ASSERT_EQ(standing.corners.size(), corners);
  ASSERT_EQ(moved.corners.size(), corners);
  for (std::size_t i = 0; i < corners; ++i) {
    const Exact wanted = posed_exactly(standing.corners.at<mpq_class>(i)), is = moved.corners.at<mpq_class>(i);
    EXPECT_EQ(wanted.x, is.x) << i;
    EXPECT_EQ(wanted.y, is.y) << i;
    EXPECT_EQ(wanted.z, is.z) << i;
  }
}

TEST(ConvexBodies, PosesMoveCornersExactly) {
  const std::vector<Point3> points{{0.1, 0.2, 0.3}, {1, 2, 3}, {1, 2, 3}, {-4, 0, 1e-300}, {5, 5, 5}};
  expect_posed(Point3{0.1, 0.2, 0.3}, 1);
  expect_posed(Segment3{{0.1, 0.2, 0.3}, {4, 5, 6}}, 2);
  expect_posed(Triangle3{{0.1, 0.2, 0.3}, {4, 5, 6}, {7, 8, -9}}, 3);
  expect_posed(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 4);
  expect_posed(Polygon3{{{0, 0, 1}, {1, 0, 1}, {1.5, 1, 1}, {1, 2, 1}, {0, 2, 1}}}, 5);
  expect_posed(Tetrahedron3{{0.1, 0.2, 0.3}, {4, 5, 6}, {7, 8, -9}, {0, 0, 1}}, 4);
  expect_posed(Aabb3{{0.1, 0.2, 0.3}, {4, 5, 6}}, 8);
  expect_posed(Obb3{{0.1, 0.2, 0.3}, {{{1, 2, 0}, {0, 0.1, 1}, {0, 0, 1}}}, {1, 2, 3}}, 8);
  expect_posed(Rectangle3{{0.1, 0.2, 0.3}, {{{1, 2, 0}, {0, 0.1, 1}}}, {1, 2}}, 4);
  expect_posed(VertexHull3{points}, 5);
}

TEST(ConvexBodies, TheSearchTakesHullsAndPoses) {
  const std::vector<Point3> left{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}},
      right{{3, 0, 0}, {4, 1, 0}, {4, -1, 0}, {4, 0, 1}, {4, 0, 0}};
  const Pose turned{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}};
  for (const Pose* pose : {static_cast<const Pose*>(nullptr), &turned}) {
    const BodyView a{.vertices = left, .pose = pose}, b{.vertices = right, .pose = pose};
    const auto bodies = bodies_of("asked", a, b);
    const auto proved = proved_nearest(bodies[0].corners, bodies[1].corners);
    ASSERT_TRUE(proved);
    EXPECT_FALSE(proved->meets);
    EXPECT_TRUE(proved->is_alone);
    ASSERT_EQ(proved->corners.size, 1U);
    EXPECT_EQ(proved->corners.ends[0], (DifferenceCorners::Ends{1, 0}));
  }
}

TEST(ConvexBodies, PointsAndSegmentsThatMeetAreSaidTo) {
  const auto proved = [](const auto& a, const auto& b) {
    const auto bodies = bodies_of("asked", body_view(a), body_view(b));
    return proved_nearest(bodies[0].corners, bodies[1].corners);
  };
  const Point3 middle{0.5, 1, 1.5}, beside{0.5, 1, std::nextafter(1.5, 2)};
  const Segment3 segment{{0, 0, 0}, {1, 2, 3}}, other{{1, 1, 1.5}, {0, 1, 1.5}};
  EXPECT_TRUE(proved(middle, middle)->meets);
  EXPECT_TRUE(proved(middle, segment)->meets);
  EXPECT_TRUE(proved(segment, middle)->meets);
  EXPECT_TRUE(proved(segment, other)->meets);
  EXPECT_FALSE(proved(middle, beside)->meets);
  EXPECT_FALSE(proved(beside, segment)->meets);
}

TEST(ConvexBodies, RoundOnesKeepTheirRadius) {
  const Pose twice{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {1, 2, 3}};
  EXPECT_EQ(body(Sphere3{{1, 2, 3}, 0.75}).radius, mpq_class(3, 4));
  EXPECT_EQ(body(Posed{Sphere3{{1, 2, 3}, 0.75}, twice}).radius, mpq_class(3, 2));
  EXPECT_EQ(body(Posed{Capsule3{{1, 2, 3}, {0, 0, 0}, 0}, skew}).radius, 0);
  EXPECT_THROW(static_cast<void>(body(Posed{Sphere3{{1, 2, 3}, 1}, skew})), UnevenPose);
}

TEST(ConvexBodies, WhatIsNoneIsNamed) {
  const std::vector<Point3> bad{{0, 0, 0}, {1, 2, NAN}}, none;
  EXPECT_THAT([&] { (void)body(VertexHull3{bad}); }, ThrowsMessage<NonFinite>(HasSubstr("asked: it.vertices[1].z")));
  EXPECT_THAT([&] { (void)body(VertexHull3{none}); }, ThrowsMessage<InvalidShape>(HasSubstr("asked: it is empty")));
  EXPECT_THAT([&] { (void)body(Aabb3{{1, 0, 0}, {0, 1, 1}}); }, ThrowsMessage<InvalidShape>(HasSubstr("is empty")));
  EXPECT_THAT([&] { (void)body(Sphere3{{0, 0, 0}, -1}); }, ThrowsMessage<InvalidShape>(HasSubstr("it.radius")));
  EXPECT_THROW(static_cast<void>(body(Polygon3{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}})), InvalidShape);
  EXPECT_THROW(static_cast<void>(body(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}})), InvalidShape);
  Pose broken = skew;
  broken.columns[1].y = INFINITY;
  EXPECT_THAT(
      [&] {
        (void)body(Posed{Point3{}, broken});
      },
      ThrowsMessage<NonFinite>(HasSubstr("it.pose.columns[1].y")));
  EXPECT_THAT(
      [&] {
        (void)bodies_of("asked", body_view(Point3{NAN, 0, 0}), body_view(Point3{}));
      },
      ThrowsMessage<NonFinite>(HasSubstr("asked: a")));
}

}  // namespace
}  // namespace plumb::query

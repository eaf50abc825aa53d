// May generic code ask whether a question has an answer?  Yes and no, for every question, both ways round.
#include <gtest/gtest.h>

#include <string>

#include "plumb/figure.hpp"
#include "plumb/query.hpp"

namespace plumb {
namespace {

struct Foreign {};

/// What code of users would be, in a namespace of theirs.
template <class A, class B>
std::string how(const A& a, const B& b) {
  if constexpr (Relatable<A, B>) {
    return relate(a, b) == Relation::disjoint ? "apart" : "together";
  } else {
    return "not asked";
  }
}

TEST(Answered, AGenericFunctionAsksOnlyWhatIsAnswered) {
  const Sphere3 ball{{0, 0, 0}, 1};
  EXPECT_EQ(how(ball, Aabb3{{1, 0, 0}, {2, 1, 1}}), "together");
  EXPECT_EQ(how(ball, Aabb3{{2, 0, 0}, {3, 1, 1}}), "apart");
  EXPECT_EQ(how(ball, Aabb2{{1, 0}, {2, 1}}), "not asked");
  EXPECT_EQ(how(ball, TriangleMesh{}), "not asked");
  EXPECT_EQ(how(Foreign{}, 1), "not asked");
}

TEST(Answered, EachQuestionHasItsConcept) {
  EXPECT_TRUE((Relatable<Point2, Polygon2>)&&(Relatable<Polygon2, Point2>));
  EXPECT_FALSE((Relatable<Point2, Point3>) || (Relatable<int, int>) || (Relatable<TriangleMesh, Point3>));
  EXPECT_TRUE((Containing<Sphere3, Point3>)&&(Containing<Aabb2, Aabb2>));
  EXPECT_FALSE((Containing<Sphere3, Point2>) || (Containing<Aabb3, Plane3>));
  EXPECT_TRUE((Intersectable<Segment3, Triangle3>)&&(Intersectable<Triangle3, Segment3>)&&(
      Intersectable<Aabb2, Polygon2>)&&(Intersectable<Polygon2, Aabb2>));
  EXPECT_FALSE((Intersectable<Sphere3, Sphere3>) || (Intersectable<Segment2, Segment3>));
  EXPECT_TRUE((Hittable<Ray3, Triangle3>)&&(Hittable<Segment2, Aabb2>)&&(Hittable<Ray3, TriangleMesh>));
  EXPECT_FALSE((Hittable<Ray3, Ray3>) || (Hittable<Ray2, Sphere3>) || (Hittable<Triangle3, Ray3>));
  EXPECT_TRUE((Measurable<Point3, Obb3>)&&(Measurable<Obb3, Point3>)&&(Measurable<Line2, Ray2>)&&(
      Measurable<Sphere3, Sphere3>)&&(Measurable<Capsule3, Aabb3>)&&(Measurable<Polygon2, Circle2>));
  EXPECT_FALSE((Measurable<Sphere3, Cylinder3>) || (Measurable<Point2, Obb3>) || (Measurable<TriangleMesh, Point3>));
  EXPECT_TRUE(
      (Collidable<Translating<Sphere3>, Translating<Sphere3>>)&&(Collidable<Moving<Point3>, Moving<Triangle3>>));
  EXPECT_FALSE((Collidable<Sphere3, Sphere3>) || (Collidable<Moving<Point3>, Foreign>));
}

}  // namespace
}  // namespace plumb

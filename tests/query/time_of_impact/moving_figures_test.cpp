// The book's figures of moving shapes (RTCD 5.32 to 5.38), with numbers in which they are exact.
#include <gtest/gtest.h>

#include <cmath>

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {
namespace {

constexpr Feature face0{FeatureKind::face, 0};
constexpr Feature vertex(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge(std::uint32_t i) { return {FeatureKind::edge, i}; }
double before(double x) { return std::nextafter(x, -INFINITY); }
double beyond(double x) { return std::nextafter(x, INFINITY); }

// Figure 5.32: between a start and an end that are both clear, and between all of eight samples, there is a wall.
TEST(MovingFigures, NothingTunnels532) {
  const Aabb3 wall{{5.5, -9, -9}, {5.5625, 9, 9}};
  const Translating<Sphere3> ball{{{0, 0, 0}, 0.25}, {10, 0, 0}};
  for (int k = 0; k <= 8; ++k) EXPECT_FALSE(intersects(Sphere3{{10.0 * k / 8, 0, 0}, 0.25}, wall)) << k;
  EXPECT_TRUE(intersects(ball, wall));
  EXPECT_TRUE(*first_contact_time(ball, wall) == Rational(21) / Rational(40));
  EXPECT_LE(first_contact(ball, wall)->time, 0.525);
}

// Figure 5.34: a ball against a plane is its center against the plane moved by the radius, toward the side it is on.
TEST(MovingFigures, BallAgainstPlane534) {
  const Plane3 plane{{3, 4, 0}, 50};  // 10 from the origin
  const auto as_segment = [](const Translating<Sphere3>& ball, const Plane3& displaced) {
    const Point3& c = ball.shape.center;
    return first_hit_parameter(Segment3{c, {c.x + ball.by.x, c.y + ball.by.y, c.z + ball.by.z}}, displaced);
  };
  const Translating<Sphere3> below{{{0, 0, 1}, 2}, {9, 7, -3}}, above{{{16, 8, 1}, 3}, {-9, -7, 5}};
  EXPECT_TRUE(*first_contact_time(below, plane) == as_segment(below, {{3, 4, 0}, 40})->base);
  EXPECT_TRUE(*first_contact_time(above, plane) == as_segment(above, {{3, 4, 0}, 65})->base);
  const Translating<Sphere3> along{{{0, 0, 1}, 2}, {4, -3, 0}};
  EXPECT_FALSE(intersects(along, plane));
  EXPECT_FALSE(as_segment(along, {{3, 4, 0}, 40}));
  const Translating<Sphere3> on_it{{{0, 0, 1}, 10}, {4, -3, 0}};  // touching all the time
  EXPECT_EQ(*first_contact(on_it, plane), (Contact{0, face0, face0}));
  EXPECT_FALSE(intersects(Translating<Sphere3>{{{0, 0, 1}, before(10)}, {4, -3, 0}}, plane));
}

// Figure 5.35: two moving balls, one of them at rest, a ray against a larger ball.
TEST(MovingFigures, BallsAsARay535) {
  const Translating<Sphere3> a{{{0, 0, 0}, 2}, {12, 3, 0}}, b{{{10, 3, 0}, 3}, {-8, 3, 0}};
  const Translating<Sphere3> alone{a.shape, {20, 0, 0}};
  const auto ray = first_hit_parameter(Segment3{{0, 0, 0}, {20, 0, 0}}, Sphere3{b.shape.center, 5});
  ASSERT_TRUE(ray);  // the centers are 5 apart when a's is at (6, 0, 0)
  EXPECT_EQ(ray->rounded(), 0.3);
  for (const auto& time : {first_contact_time(a, b), first_contact_time(b, a), first_contact_time(alone, b.shape)}) {
    ASSERT_TRUE(time);
    EXPECT_TRUE(*time == Rational(3) / Rational(10));
  }
  const Translating<Sphere3> over{{{0, -2, 0}, 2}, {20, 0, 0}};  // 5 apart when side by side
  EXPECT_TRUE(*first_contact_time(over, b.shape) == Rational(1) / Rational(2));
  EXPECT_FALSE(intersects(over, Sphere3{b.shape.center, before(3)}));
}

// Figure 5.36: a ball reaches a triangle at its inside, an edge, or a corner.
TEST(MovingFigures, BallAgainstTriangle536) {
  const Triangle3 floor{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}};
  const auto falling = [](const Point3& from, double radius) {
    return Translating<Sphere3>{{from, radius}, {0, 0, -8}};
  };
  EXPECT_EQ(*first_contact(falling({4, 4, 9}, 5), floor), (Contact{0.5, face0, face0}));
  EXPECT_EQ(*first_contact(falling({8, -3, 8}, 5), floor), (Contact{0.5, face0, edge(0)}));     // 3 and 4 off
  EXPECT_EQ(*first_contact(falling({-1, -2, 6}, 3), floor), (Contact{0.5, face0, vertex(0)}));  // 1, 2 and 2 off
  EXPECT_FALSE(first_contact(falling({11, 11, 4}, 3), floor));
  EXPECT_EQ(*first_contact(falling({8, -5, 4}, 5), floor), (Contact{0.5, face0, edge(0)}));  // beside it at last
  EXPECT_FALSE(intersects(falling({8, -5, 4}, before(5)), floor));
  const Translating<Sphere3> rolling{{{-8, 4, 5}, 5}, {32, 0, 0}};  // on the floor, from beside it
  EXPECT_EQ(*first_contact(rolling, floor), (Contact{0.25, face0, edge(2)}));
}

// Figure 5.37: a ball against a box is a segment against the box with rounded edges and corners.
TEST(MovingFigures, BallAgainstBox537) {
  const Aabb3 box{{0, 0, 0}, {10, 10, 10}};
  const auto past_corner = [](double radius) {  // through (12, 13, 16), across the way from the corner: 2, 3 and 6 off
    return Translating<Sphere3>{{{0, 21, 16}, radius}, {24, -16, 0}};
  };
  EXPECT_EQ(*first_contact(past_corner(7), box), (Contact{0.5, face0, vertex(7)}));
  EXPECT_FALSE(intersects(past_corner(before(7)), box));
  // Within the box that is larger by the radius, and past its rounded edge.
  const Segment3 path{{16, 11.5, 5}, {11.5, 16, 5}};
  EXPECT_TRUE(intersects(path, Aabb3{{-5, -5, -5}, {15, 15, 15}}));
  EXPECT_FALSE(intersects(Translating<Sphere3>{{path.a, 5}, {-4.5, 4.5, 0}}, box));
  EXPECT_TRUE(intersects(Translating<Sphere3>{{path.a, 5.5}, {-4.5, 4.5, 0}}, box));
  // Against a face, and along an edge 3 and 4 off.
  EXPECT_EQ(*first_contact(Translating<Sphere3>{{{4, 5, 19}, 5}, {0, 0, -8}}, box),
            (Contact{0.5, face0, {FeatureKind::face, 5}}));
  EXPECT_EQ(first_contact(Translating<Sphere3>{{{5, -8, 13}, 5}, {0, 8, 0}}, box)->time, 0.5);
}

// Figure 5.38: per axis a first and a last contact; the boxes meet from the last first one on, if no last one is
// before.
TEST(MovingFigures, BoxAgainstBox538) {
  const Aabb3 rest{{0, 0, 0}, {4, 4, 4}};
  const auto moving = [](double low, double by) {  // along x from 1/4 to 5/8
    return Translating<Aabb3>{{{-6, low, 1}, {-4, low + 2, 2}}, {16, by, 0}};
  };
  EXPECT_EQ(first_contact(moving(10, -12), rest)->time, 0.5);   // y from 1/2 to 1
  EXPECT_EQ(first_contact(moving(10, -32), rest)->time, 0.25);  // y from 3/16 to 3/8: x tells
  EXPECT_FALSE(first_contact(moving(10, -8), rest));            // y from 3/4
  EXPECT_FALSE(first_contact(moving(10, -64), rest));           // y until 3/16
  EXPECT_EQ(first_contact(moving(9, -8), rest)->time, 0.625);   // edge to edge, when x ends
  EXPECT_FALSE(intersects(moving(beyond(9), -8), rest));
  EXPECT_TRUE(*first_contact_time(moving(8, -9), rest) == Rational(4) / Rational(9));
}

}  // namespace
}  // namespace plumb

// Do bounds under rigid poses and chains hold the exact images, and are they as small as they are said to be?  Against
// images in rational numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "figure/basic/rigid_poses.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure.hpp"

namespace plumb {
namespace {

using rationals::dot, rationals::exact, rationals::operator-, rationals::operator+, rationals::operator*;
using Numbers = rationals::Vector;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

bool is_rounded_up(double x, const mpq_class& wanted) {
  return mpq_class(x) >= wanted && mpq_class(std::nextafter(x, -infinite)) < wanted;
}
bool is_rounded_down(double x, const mpq_class& wanted) { return is_rounded_up(-x, mpq_class(-wanted)); }

double coordinate(Entropy& entropy) {
  return entropy.coin() ? static_cast<double>(entropy.within(9))
                        : static_cast<double>(entropy.within(1LL << 50)) * std::ldexp(1.0, -46);
}
Point3 point(Entropy& entropy) {
  const double x = coordinate(entropy), y = coordinate(entropy), z = coordinate(entropy);
  return {x, y, z};
}
Vector3 way(Entropy& entropy) {
  const Point3 p = point(entropy);
  return {p.x, p.y, p.z};
}

/// f(pose, about) of rigid poses and chains of space, as many as that.
template <class F>
void for_each_pose(std::uint64_t start, std::uint64_t count, F f) {
  for (std::uint64_t index = 0; index < count; ++index) {
    Entropy entropy(start, index);
    const std::string about = "start " + std::to_string(start) + " index " + std::to_string(index);
    if (index % 4 == 3) {
      f(rigid_poses::chain(entropy), entropy, about);
    } else {
      f(rigid_poses::pose(entropy), entropy, about);
    }
  }
}
template <class F>
void for_each_pose_of_plane(std::uint64_t start, std::uint64_t count, F f) {
  for (std::uint64_t index = 0; index < count; ++index) {
    Entropy entropy(start, index);
    const std::string about = "start " + std::to_string(start) + " index " + std::to_string(index);
    if (index % 4 == 3) {
      f(rigid_poses::chain2(entropy), entropy, about);
    } else {
      f(rigid_poses::pose2(entropy), entropy, about);
    }
  }
}

struct Extent {
  mpq_class min, max;
};
/// How far the images of the points reach along a direction.
template <class By, class Point>
Extent extent(const By& pose, const std::vector<Point>& points, const Numbers& along) {
  Extent e;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const mpq_class far = dot(along, rigid_poses::image(pose, exact(points[i])));
    if (i == 0 || far < e.min) e.min = far;
    if (i == 0 || far > e.max) e.max = far;
  }
  return e;
}

template <class By>
void expect_least_box(const Aabb3& box, const By& pose, const std::vector<Point3>& points, const std::string& about) {
  const std::array min{box.min.x, box.min.y, box.min.z}, max{box.max.x, box.max.y, box.max.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Numbers along(3);
    along[axis] = 1;
    const Extent e = extent(pose, points, along);
    EXPECT_TRUE(is_rounded_down(min[axis], e.min) && is_rounded_up(max[axis], e.max)) << about << " axis " << axis;
  }
}

std::vector<Point3> corners_of(const Aabb3& box) {
  std::vector<Point3> all;
  for (const double x : {box.min.x, box.max.x}) {
    for (const double y : {box.min.y, box.max.y}) {
      for (const double z : {box.min.z, box.max.z}) all.push_back({x, y, z});
    }
  }
  return all;
}

TEST(RigidBounds, BoxesAreTheLeastOfDoubles) {
  for_each_pose(861, 600, [](const auto& pose, Entropy& entropy, const std::string& about) {
    std::vector<Point3> points;
    for (std::uint64_t n = 1 + entropy.below(6); n > 0; --n) points.push_back(point(entropy));
    expect_least_box(fit_aabb(points, pose), pose, points, about);
    const Aabb3 box = fit_aabb(points);
    expect_least_box(transform(box, pose), pose, corners_of(box), about);
  });
  const Aabb3 empty{{1, 1, 1}, {-1, -1, -1}};
  EXPECT_EQ(transform(empty, RigidPose{{1, 0, 0, 1}}), empty);
}

/// Of points and a ball, whose image is one of the same radius.
template <class By>
void expect_least_box(const Aabb3& box, const By& pose, const std::vector<Numbers>& points, double radius,
                      const std::string& about) {
  const std::array min{box.min.x, box.min.y, box.min.z}, max{box.max.x, box.max.y, box.max.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Extent e;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const mpq_class far = rigid_poses::image(pose, points[i])[axis];
      if (i == 0 || far < e.min) e.min = far;
      if (i == 0 || far > e.max) e.max = far;
    }
    EXPECT_TRUE(is_rounded_down(min[axis], e.min - radius)) << about << " axis " << axis;
    EXPECT_TRUE(is_rounded_up(max[axis], e.max + radius)) << about << " axis " << axis;
  }
}

TEST(RigidBounds, BoxesOfPosedShapesAreTheLeastOfDoubles) {
  for_each_pose(872, 300, [](const auto& pose, Entropy& entropy, const std::string& about) {
    const double radius = std::fabs(coordinate(entropy));
    const Point3 a = point(entropy), b = point(entropy), c = point(entropy);
    const Vector3 u = way(entropy), v = way(entropy), w = way(entropy);
    const auto check = [&](const auto& shape, const std::vector<Numbers>& points, double r) {
      expect_least_box(fit_aabb(Posed{shape, pose}), pose, points, r, about);
    };
    check(a, {exact(a)}, 0);
    check(Segment3{a, b}, {exact(a), exact(b)}, 0);
    check(Triangle3{a, b, c}, {exact(a), exact(b), exact(c)}, 0);
    check(Polygon3{{a, b, c}}, {exact(a), exact(b), exact(c)}, 0);
    check(HoledPolygon3{{{a, b, c}}, {{{c, a, b}}}}, {exact(a), exact(b), exact(c)}, 0);
    const Aabb3 upright = fit_aabb(Triangle3{a, b, c});
    expect_least_box(fit_aabb(Posed{upright, pose}), pose, corners_of(upright), about);
    check(Sphere3{a, radius}, {exact(a)}, radius);
    check(Capsule3{a, b, radius}, {exact(a), exact(b)}, radius);
    const Numbers p = exact(a), e = exact(u), f = exact(v), g = exact(w);
    check(Lozenge3{a, {u, v}, radius}, {p, p + e, p + f, p + e + f}, radius);
    std::vector<Numbers> corners, flat;
    const Obb3 box{a, {u, v, w}, {0.5, -3, 2}};
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto sign = [&](std::size_t k) { return mpq_class((corner >> k & 1) != 0 ? 1 : -1); };
      const Numbers at = p + mpq_class(sign(0) / 2) * e + mpq_class(sign(1) * 3) * f;
      corners.push_back(at + mpq_class(sign(2) * 2) * g);
      flat.push_back(at);
    }
    check(box, corners, 0);
    check(Rectangle3{a, {u, v}, {0.5, 3}}, flat, 0);
  });
  for_each_pose_of_plane(873, 200, [](const auto& pose, Entropy& entropy, const std::string& about) {
    const double radius = std::fabs(coordinate(entropy));
    const Point2 a{coordinate(entropy), coordinate(entropy)}, b{coordinate(entropy), coordinate(entropy)};
    const Aabb2 made = fit_aabb(Posed{Capsule2{a, b, radius}, pose});
    const Extent x = extent(pose, std::vector<Point2>{a, b}, {1, 0}),
                 y = extent(pose, std::vector<Point2>{a, b}, {0, 1});
    EXPECT_TRUE(is_rounded_down(made.min.x, x.min - radius) && is_rounded_up(made.max.x, x.max + radius)) << about;
    EXPECT_TRUE(is_rounded_down(made.min.y, y.min - radius) && is_rounded_up(made.max.y, y.max + radius)) << about;
  });
}

TEST(RigidBounds, BoxesOfBallsUnderMatricesAreTheLeastOfDoubles) {
  for (std::uint64_t index = 0; index < 300; ++index) {
    Entropy entropy(874, index);
    const std::string about = "start 874 index " + std::to_string(index);
    Pose pose{{{way(entropy), way(entropy), way(entropy)}}, way(entropy)};
    if (entropy.below(4) == 0) pose.columns[1] = pose.columns[2] = {0, 0, 0};  // row lengths that are doubles
    const Sphere3 ball{point(entropy), std::fabs(coordinate(entropy))};
    const Aabb3 box = fit_aabb(Posed{ball, pose});
    const auto check = [&](double min, double max, double Vector3::*row, double center) {
      const auto& [u, v, w] = pose.columns;
      const Numbers r{u.*row, v.*row, w.*row};
      const mpq_class middle = dot(r, exact(ball.center)) + center;
      const mpq_class reach2 = dot(r, r) * mpq_class(ball.radius) * mpq_class(ball.radius);
      const auto reaches = [&](const mpq_class& far) { return far >= 0 && far * far >= reach2; };
      EXPECT_TRUE(reaches(mpq_class(max) - middle) && !reaches(mpq_class(std::nextafter(max, -infinite)) - middle))
          << about;
      EXPECT_TRUE(reaches(middle - mpq_class(min)) && !reaches(middle - mpq_class(std::nextafter(min, infinite))))
          << about;
    };
    check(box.min.x, box.max.x, &Vector3::x, pose.translation.x);
    check(box.min.y, box.max.y, &Vector3::y, pose.translation.y);
    check(box.min.z, box.max.z, &Vector3::z, pose.translation.z);
  }
}

TEST(RigidBounds, BoxesOfThePlaneAreTheLeastOfDoubles) {
  for_each_pose_of_plane(862, 300, [](const auto& pose, Entropy& entropy, const std::string& about) {
    const Point3 p = point(entropy), q = point(entropy);
    const Aabb2 box = fit_aabb(std::vector<Point2>{{p.x, p.y}, {q.x, q.y}}), made = transform(box, pose);
    const std::vector<Point2> corners{box.min, box.max, {box.min.x, box.max.y}, {box.max.x, box.min.y}};
    const Extent x = extent(pose, corners, {1, 0}), y = extent(pose, corners, {0, 1});
    EXPECT_TRUE(is_rounded_down(made.min.x, x.min) && is_rounded_up(made.max.x, x.max)) << about;
    EXPECT_TRUE(is_rounded_down(made.min.y, y.min) && is_rounded_up(made.max.y, y.max)) << about;
  });
}

TEST(RigidBounds, ClimbingFindsTheSameBox) {
  std::vector<Point3> points;
  Entropy entropy(863);
  for (int i = 0; i < 40; ++i) points.push_back(point(entropy));
  const ConvexPolyhedron3 polyhedron = convex_polyhedron(convex_hull(points), points);
  ClimbingAabb climbing(polyhedron);
  for_each_pose(864, 150, [&](const auto& pose, Entropy&, const std::string& about) {
    EXPECT_EQ(climbing(pose), fit_aabb(polyhedron.mesh.vertices, pose)) << about;
  });
}

TEST(RigidBounds, KDopsAreTheLeastOfDoubles) {
  for_each_pose(865, 150, [](const auto& pose, Entropy& entropy, const std::string& about) {
    std::vector<Point3> points;
    for (std::uint64_t n = 1 + entropy.below(5); n > 0; --n) points.push_back(point(entropy));
    const KDop3 made = fit_k_dop(points, k_dop_directions(14), pose);
    const auto expect_least = [&](const KDop3& k_dop, const std::vector<Point3>& of) {
      for (std::size_t i = 0; i < k_dop.min.size(); ++i) {
        const Extent e = extent(pose, of, exact(k_dop.directions.all()[i]));
        EXPECT_TRUE(is_rounded_down(k_dop.min[i], e.min) && is_rounded_up(k_dop.max[i], e.max))
            << about << " slab " << i;
      }
    };
    expect_least(made, points);
    const KDop3 box = fit_k_dop(points, 6);
    expect_least(transform(box, pose),
                 corners_of({{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}}));
  });
  for_each_pose_of_plane(866, 60, [](const auto& pose, Entropy& entropy, const std::string& about) {
    const Point3 p = point(entropy), q = point(entropy);
    const std::vector<Point2> points{{p.x, p.y}, {q.x, q.y}};
    const KDop2 box = fit_k_dop(points, k_dop_directions2(4)), made = transform(box, pose);
    const std::vector<Point2> corners{
        {box.min[0], box.min[1]}, {box.min[0], box.max[1]}, {box.max[0], box.min[1]}, {box.max[0], box.max[1]}};
    for (std::size_t i = 0; i < 2; ++i) {
      const Extent e = extent(pose, corners, exact(box.directions.all()[i]));
      EXPECT_TRUE(is_rounded_down(made.min[i], e.min) && is_rounded_up(made.max[i], e.max)) << about;
    }
  });
}

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TEST(RigidBounds, OrientedBoxesHoldTheImage) {
  for_each_pose(867, 300, [](const auto& pose, Entropy& entropy, const std::string& about) {
    Obb3 box{point(entropy), {way(entropy), way(entropy), way(entropy)}, {1, 2, 0.5}};
    if (entropy.below(4) == 0) box.axes[2] = {0, 0, 0};
    const Obb3 made = transform(box, pose);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto sign = [&](std::size_t k) { return mpq_class((corner >> k & 1) != 0 ? 1 : -1); };
      const Numbers p = exact(box.center) + mpq_class(sign(0) * box.half.x) * exact(box.axes[0]) +
                        mpq_class(sign(1) * box.half.y) * exact(box.axes[1]) +
                        mpq_class(sign(2) * box.half.z) * exact(box.axes[2]);
      const Numbers from = rigid_poses::image(pose, p) - exact(made.center);
      const std::array half{made.half.x, made.half.y, made.half.z};
      for (std::size_t i = 0; i < 3; ++i) {
        const Numbers normal = cross(exact(made.axes[(i + 1) % 3]), exact(made.axes[(i + 2) % 3]));
        const mpq_class reach = abs(dot(normal, from)), size = abs(dot(normal, exact(made.axes[i])));
        EXPECT_LE(reach, mpq_class(half[i] * size)) << about;
      }
    }
  });
  const Obb2 flat = transform(Obb2{{1, 2}, {Vector2{1, 0}, {0, 1}}, {3, 1}}, RigidPose2{{1, 1}, {10, 0}});
  EXPECT_EQ(flat, (Obb2{{8, 1}, {Vector2{0, 1}, {-1, 0}}, {3, 1}}));
}

/// Is the square root of x at most r?
bool root_is_at_most(const mpq_class& x, const mpq_class& r) { return r >= 0 && x <= r * r; }

TEST(RigidBounds, BallsStayBalls) {
  int kept = 0;
  for_each_pose(868, 600, [&](const auto& pose, Entropy& entropy, const std::string& about) {
    const Sphere3 ball{point(entropy), std::fabs(coordinate(entropy))};
    const Sphere3 made = transform(ball, pose);
    const Numbers there = rigid_poses::image(pose, exact(ball.center));
    const Numbers off = there - exact(made.center);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(rationals::is_nearest(std::array{made.center.x, made.center.y, made.center.z}[i], there[i])) << about;
    }
    const mpq_class more = mpq_class(made.radius) - mpq_class(ball.radius), off2 = dot(off, off);
    EXPECT_TRUE(root_is_at_most(off2, more)) << about;
    if (off2 == 0) {
      ++kept;
      EXPECT_EQ(made.radius, ball.radius) << about;
    } else {
      double ulps = 0;  // by half of which a coordinate is off at most
      for (const double x : {made.center.x, made.center.y, made.center.z})
        ulps += std::nextafter(std::fabs(x), infinite) - std::fabs(x);
      EXPECT_LE(made.radius, (ball.radius + ulps) * (1 + 0x1p-50)) << about;
    }
    EXPECT_EQ(largest_stretch(pose), 1) << about;
  });
  // Of every size: no product with the stretch, which is 1, is rounded.
  for (const double radius : {0x1p-1074, 0x1.8p-1000, 0x1p1023}) {
    EXPECT_EQ(transform(Sphere3{{1, 2, 3}, radius}, RigidPose{{1, 0, 0, 1}}).radius, radius);
    EXPECT_EQ(transform(Capsule3{{1, 2, 3}, {1, 2, 5}, radius}, RigidPose{{1, 0, 0, 1}}).radius, radius);
  }
  EXPECT_GT(kept, 20);
  for_each_pose_of_plane(869, 200, [&](const auto& pose, Entropy& entropy, const std::string& about) {
    const Circle2 ball{{coordinate(entropy), coordinate(entropy)}, std::fabs(coordinate(entropy))};
    const Circle2 made = transform(ball, pose);
    const Numbers off = rigid_poses::image(pose, exact(ball.center)) - exact(made.center);
    EXPECT_TRUE(root_is_at_most(dot(off, off), mpq_class(made.radius) - mpq_class(ball.radius))) << about;
    EXPECT_EQ(largest_stretch(pose), 1) << about;
  });
}

mpq_class squared_distance(const Numbers& p, const Numbers& a, const Numbers& along) {
  const Numbers from = p - a;
  const mpq_class square = dot(along, along);
  mpq_class t = square == 0 ? mpq_class(0) : mpq_class(dot(from, along) / square);
  t = t < 0 ? mpq_class(0) : t > 1 ? mpq_class(1) : t;
  const Numbers off = from - t * along;
  return dot(off, off);
}

TEST(RigidBounds, CapsulesAndLozengesKeepTheirRadiusButForWhatEndsAreOff) {
  int kept = 0;
  for_each_pose(870, 400, [&](const auto& pose, Entropy& entropy, const std::string& about) {
    const double radius = std::fabs(coordinate(entropy));
    const Capsule3 capsule{point(entropy), point(entropy), radius};
    const Capsule3 made = transform(capsule, pose);
    const mpq_class more = mpq_class(made.radius) - mpq_class(radius);
    mpq_class most;
    for (const Point3& end : {capsule.a, capsule.b}) {
      const mpq_class off2 =
          squared_distance(rigid_poses::image(pose, exact(end)), exact(made.a), exact(made.b) - exact(made.a));
      EXPECT_TRUE(root_is_at_most(off2, more)) << about;
      if (off2 > most) most = off2;
    }
    if (most == 0) {
      ++kept;
      EXPECT_EQ(made.radius, radius) << about;
    } else {
      EXPECT_LE(made.radius, (radius + 2 * std::sqrt(most.get_d())) * (1 + 0x1p-50)) << about;
    }
    const Lozenge3 lozenge{point(entropy), {way(entropy), way(entropy)}, radius};
    const Lozenge3 image = transform(lozenge, pose);
    const Numbers normal = cross(exact(image.edges[0]), exact(image.edges[1]));
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const mpq_class s((corner & 1) != 0 ? 1 : 0), t((corner & 2) != 0 ? 1 : 0);
      const Numbers p =
          rigid_poses::image(pose, exact(lozenge.corner) + s * exact(lozenge.edges[0]) + t * exact(lozenge.edges[1]));
      const Numbers c = exact(image.corner), e = exact(image.edges[0]), f = exact(image.edges[1]);
      mpq_class least = squared_distance(p, c, e);
      for (const mpq_class& other :
           {squared_distance(p, c, f), squared_distance(p, c + e, f), squared_distance(p, c + f, e)}) {
        if (other < least) least = other;
      }
      const mpq_class square = dot(normal, normal), u = dot(cross(p - c, f), normal), v = dot(cross(e, p - c), normal);
      if (square > 0 && u >= 0 && u <= square && v >= 0 && v <= square) {
        const mpq_class gap = dot(p - c, normal);
        if (gap * gap < least * square) least = gap * gap / square;
      }
      EXPECT_TRUE(root_is_at_most(least, mpq_class(image.radius) - mpq_class(radius))) << about;
    }
  });
  EXPECT_GT(kept, 5);
  // Exactly, in the plane: by a quarter.
  EXPECT_EQ(transform(Capsule2{{1, 0}, {3, 0}, 0.1}, RigidPose2{{1, 1}, {0, 5}}), (Capsule2{{0, 6}, {0, 8}, 0.1}));
}

TEST(RigidBounds, CylindersHoldTheImage) {
  for_each_pose(871, 200, [](const auto& pose, Entropy& entropy, const std::string& about) {
    // Upright, of radius 5, whose rims have points of integers.
    const Point3 a{static_cast<double>(entropy.within(9)), static_cast<double>(entropy.within(9)), 1};
    const Cylinder3 cylinder{a, {a.x, a.y, 3}, 5};
    const Cylinder3 made = transform(cylinder, pose);
    const Numbers from = exact(made.a), along = exact(made.b) - from;
    const mpq_class square = dot(along, along);
    for (const auto& [x, y] : {std::pair(5, 0), {3, 4}, {-4, 3}, {-3, -4}, {0, -5}}) {
      for (const double z : {1.0, 3.0}) {
        const Numbers p = rigid_poses::image(pose, {a.x + x, a.y + y, z});
        const mpq_class t = dot(p - from, along);
        EXPECT_TRUE(t >= 0 && t <= square) << about;
        const Numbers beside = cross(p - from, along);
        EXPECT_LE(dot(beside, beside), mpq_class(made.radius) * mpq_class(made.radius) * square) << about;
      }
    }
  });
}

TEST(RigidBounds, NameWhatIsNone) {
  const auto text = [](auto call) { return text_of<Error>(call); };
  const RigidPose none{{0, 0, 0, 0}}, bad{{1, nan, 0, 0}};
  EXPECT_THAT(text([&] {
                (void)transform(Sphere3{{0, 0, 0}, 1}, none);
              }),
              testing::StartsWith("transform: pose.turn is zero"));
  EXPECT_THAT(text([&] {
                (void)transform(Aabb3{{0, 0, 0}, {1, 1, 1}}, bad);
              }),
              testing::StartsWith("transform: pose.turn.x is nan"));
  EXPECT_THAT(text([&] {
                (void)transform(Capsule3{{0, 0, 0}, {1, 1, 1}, 1}, RigidChain{{{}, bad}});
              }),
              testing::StartsWith("transform: pose.links[1].turn.x is nan"));
  EXPECT_THAT(text([&] {
                (void)fit_aabb(std::vector<Point3>{{0, 0, 0}}, none);
              }),
              testing::StartsWith("fit_aabb: pose.turn is zero"));
  EXPECT_THAT(text([&] {
                (void)transform(Circle2{{0, 0}, 1}, RigidPose2{{0, 0}});
              }),
              testing::StartsWith("transform: pose.turn is zero"));
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_THAT(text([&] {
                (void)transform(Sphere3{{most, most, 0}, 1}, RigidPose{{1, 0, 0, 0.5}});
              }),
              testing::StartsWith("transform: center is beyond all doubles"));
}

}  // namespace
}  // namespace plumb

// Points, segments and triangles whose corners move from the image under one pose to that under another: as the images
// where doubles hold them; a common rigid pose changes nothing; an AnyFigure answers as its kind.
#include "plumb/query/time_of_impact/posed_corners.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/body/rigid_cases.hpp"

namespace plumb {
namespace {

/// Whole multiples of `unit`, small enough to meet often.
class Drawn {
 public:
  Drawn(std::uint64_t start, std::uint64_t index, double unit) : entropy(start, index), unit_(unit) {}
  double number() { return static_cast<double>(entropy.within(3)) * unit_; }
  Point3 point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  template <class Shape>
  Shape shape() {
    if constexpr (std::is_same_v<Shape, Point3>) {
      return point();
    } else if constexpr (std::is_same_v<Shape, Segment3>) {
      return {point(), point()};
    } else {
      return {point(), point(), point()};
    }
  }
  Entropy entropy;

 private:
  double unit_;
};

template <class By>
std::optional<Point3> image_of(const By& pose, const Point3& p) {
  return exact_image(pose, p);
}
template <class By>
std::optional<Segment3> image_of(const By& pose, const Segment3& s) {
  const auto a = exact_image(pose, s.a), b = exact_image(pose, s.b);
  return a && b ? std::optional(Segment3{*a, *b}) : std::nullopt;
}
template <class By>
std::optional<Triangle3> image_of(const By& pose, const Triangle3& t) {
  const auto a = exact_image(pose, t.a), b = exact_image(pose, t.b), c = exact_image(pose, t.c);
  return a && b && c ? std::optional(Triangle3{*a, *b, *c}) : std::nullopt;
}

struct Met {
  int cases = 0, contacts = 0, at_start = 0;
};
template <class A, class B, class C, class D>
void expect_same(const Moving<A>& a, const Moving<B>& b, const Moving<C>& c, const Moving<D>& d,
                 const ContactOptions& options, Met& met, const std::string& about) {
  const auto plain = first_contact(c, d, options);
  ++met.cases, met.contacts += plain.has_value(), met.at_start += plain && plain->time == 0;
  EXPECT_EQ(first_contact(a, b, options), plain) << about;
  EXPECT_EQ(first_contact(b, a, options), first_contact(d, c, options)) << about;
  EXPECT_EQ(intersects(a, b, options), plain.has_value()) << about;
  const auto time = first_contact_time(a, b, options), plain_time = first_contact_time(c, d, options);
  ASSERT_EQ(time.has_value(), plain_time.has_value()) << about;
  EXPECT_TRUE(!time || *time == *plain_time) << about;
}
/// As types, and as figures of any kind.
template <class A, class B, class C, class D>
void expect_told(const Moving<A>& a, const Moving<B>& b, const Moving<C>& c, const Moving<D>& d,
                 const ContactOptions& options, Met& met, const std::string& about) {
  expect_same(a, b, c, d, options, met, about);
  const Moving<AnyFigure> x{a.from, a.to}, y{b.from, b.to};
  expect_same(x, y, c, d, options, met, about);
  expect_same(x, b, c, d, options, met, about);
  expect_same(a, y, c, d, options, met, about);
}

Pose whole_pose(Entropy& e) {
  const auto n = [&] { return static_cast<double>(e.within(2)); };
  const auto v = [&] { return Vector3{n(), n(), n()}; };
  return {{{v(), v(), v()}}, v()};
}
/// Of weight 1, 2, 4 or 5.
RigidPose short_turn(Entropy& e) {
  const auto n = [&] { return static_cast<double>(e.within(1)); };
  Rotation turn{1, 0, 0, 0};
  double& part = e.below(3) == 0 ? turn.x : e.below(2) == 0 ? turn.y : turn.z;
  part = static_cast<double>(e.within(2));
  return {turn, {5 * n(), 5 * n(), 5 * n()}};
}

template <class A, class B, class PoseOf>
void expect_images(std::uint64_t start, double unit, const PoseOf& pose_of, Met& met) {
  for (std::uint64_t index = 0; index < (battery::sanitized ? 60 : 400); ++index) {
    Drawn m(start, index, unit);
    const ContactOptions options{m.entropy.below(3) == 0 ? unit / 2 : 0};
    const auto now = pose_of(m.entropy), next = m.entropy.coin() ? pose_of(m.entropy) : now;
    const Moving<A> a{m.shape<A>(), m.shape<A>()};
    const Moving<B> b{m.shape<B>(), m.shape<B>()};
    const auto a0 = image_of(now, a.from), a1 = image_of(next, a.to);
    const auto b0 = image_of(now, b.from), b1 = image_of(next, b.to);
    ASSERT_TRUE(a0 && a1 && b0 && b1) << index;
    const std::string about = "replay: " + std::to_string(start) + " " + std::to_string(index);
    const auto posed = [](const auto& shape, const auto& by) { return Posed{shape, by}; };
    const Moving moved_a{posed(a.from, now), posed(a.to, next)};
    const Moving moved_b{posed(b.from, now), posed(b.to, next)};
    const Moving<A> image_a{*a0, *a1};
    const Moving<B> image_b{*b0, *b1};
    expect_told(moved_a, moved_b, image_a, image_b, options, met, about);
    expect_told(moved_a, b, image_a, b, options, met, about);
    expect_told(a, moved_b, a, image_b, options, met, about);
  }
}

void expect_often(const Met& met) {
  std::printf("%d cases, %d contacts, %d of them at the start\n", met.cases, met.contacts, met.at_start);
  EXPECT_GT(met.contacts - met.at_start, met.cases / 20);
  EXPECT_GT(met.at_start, met.cases / 60);
}

TEST(PosedCorners, AreAskedAsTheirImages) {
  Met met;
  expect_images<Point3, Triangle3>(8101, 1, whole_pose, met);
  expect_images<Segment3, Segment3>(8102, 1, whole_pose, met);
  expect_images<Point3, Triangle3>(8103, 5, short_turn, met);
  expect_images<Segment3, Segment3>(8104, 5, short_turn, met);
  expect_often(met);
}

TEST(PosedCorners, ACommonRigidPoseChangesNothing) {
  Met met;
  const auto expect = [&]<class A, class B>(std::uint64_t start, const A*, const B*) {
    shape_cases::on_shapes(start, battery::sanitized ? 50 : 300, [&](pair_cases::Material& m) {
      Drawn drawn(start, m.below(1U << 30), 1);
      const ContactOptions options{m.below(3) == 0 ? 0.5 : 0};
      const pair_cases::RigidCase by = pair_cases::rigid_case(m);
      const Moving<A> a{drawn.shape<A>(), drawn.shape<A>()};
      const Moving<B> b{drawn.shape<B>(), drawn.shape<B>()};
      std::visit(
          [&](const auto& pose) {
            const Moving moved_a{Posed{a.from, pose}, Posed{a.to, pose}};
            const Moving moved_b{Posed{b.from, pose}, Posed{b.to, pose}};
            expect_told(moved_a, moved_b, a, b, options, met, m.about());
          },
          by.space);
    });
  };
  expect(8201, static_cast<const Point3*>(nullptr), static_cast<const Triangle3*>(nullptr));
  expect(8202, static_cast<const Segment3*>(nullptr), static_cast<const Segment3*>(nullptr));
  expect_often(met);
}

TEST(PosedCorners, ANeedleTurnsIntoTheFloor) {
  const RigidPose now{{1, 0, 0, 0}, {0, 0, 3}}, next{{1, 0, 1, 0}, {0, 0, 3}};  // a quarter about y
  const Triangle3 floor{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const Moving<Posed<Point3, RigidPose>> tip{{{4, 0, 0}, now}, {{4, 0, 0}, next}};
  EXPECT_EQ(first_contact(tip, Moving<Triangle3>{floor, floor})->time, 0.75);  // from 3 above to 1 below
}

TEST(PosedCorners, WhatIsNoneIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle3 t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Moving<Triangle3> still{t, t};
  const auto said = [&](const RigidPose& pose, double separation) {
    const Posed p{Point3{0, 0, 0}, pose};
    return text_of<Error>([&] { first_contact(Moving{p, p}, still, {separation}); });
  };
  EXPECT_EQ(said({{0, 0, 0, 0}, {0, 0, 0}}, 0),
            "first_contact: a.from.pose.turn is zero, which is no turn; give Rotation{1, 0, 0, 0} for none");
  EXPECT_EQ(said({}, -1),
            "first_contact: options.separation is negative; give a distance, zero for figures that are to touch");
  EXPECT_TRUE(said({}, nan).starts_with("first_contact: options.separation is nan"));
  const Moving<AnyFigure> changed{Point3{0, 0, 0}, t};
  EXPECT_THROW(first_contact(changed, still), Unsupported);
  const Moving<AnyFigure> balls{Sphere3{{0, 0, 0}, 1}, Sphere3{{0, 0, 0}, 1}};
  EXPECT_THROW(intersects(balls, still), Unsupported);
}

}  // namespace
}  // namespace plumb

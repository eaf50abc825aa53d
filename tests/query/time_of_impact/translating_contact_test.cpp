// Straight motions against two witnesses: of small integers, at times k / 64 every shape is again one of doubles, of
// which relate is asked; of any numbers, an oracle in rationals has the first time and the features that meet then.
#include "plumb/query/time_of_impact/translating_contact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/case_line.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/figure.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/time_of_impact/translating_cases.hpp"
#include "query/time_of_impact/translating_truth.hpp"

namespace plumb {
namespace {

using namespace translating_cases;

template <class A, class B>
Relation relation(const A& a, const B& b) {
  return relate(a, b);
}
Relation relation(const Point3& a, const Point3& b) { return a == b ? Relation::overlapping : Relation::disjoint; }

/// The relation at time k / 64.
template <class A, class B>
Relation at(int k, const Translating<A>& a, const Translating<B>& b) {
  const auto part = [&](const Vector3& v) {
    const double t = static_cast<double>(k) / steps;
    return Vector3{t * v.x, t * v.y, t * v.z};
  };
  return relation(moved(a.shape, part(a.by)), moved(b.shape, part(b.by)));
}

struct Counts {
  int never = 0, at_start = 0, later = 0;
};

template <class A, class B>
void check(const std::string& about, const Translating<A>& a, const Translating<B>& b, Entropy& entropy,
           Counts& counts) {
  const std::optional<Root> time = first_contact_time(a, b);
  const std::optional<Contact> contact = first_contact(a, b);
  ASSERT_EQ(time.has_value(), contact.has_value()) << about;
  ASSERT_EQ(time.has_value(), intersects(a, b)) << about;
  const std::optional<Root> other = first_contact_time(b, a);
  ASSERT_EQ(time.has_value(), other.has_value()) << about;
  if (!time) {
    ++counts.never;
    for (const int k : {0, static_cast<int>(entropy.below(steps)), static_cast<int>(entropy.below(steps)), steps})
      ASSERT_EQ(at(k, a, b), Relation::disjoint) << about << " at " << k;
    return;
  }
  ASSERT_TRUE(*time == *other) << about;
  ASSERT_EQ(contact->time, time->rounded(Rounding::down)) << about;
  const auto at_step = [&](int k) { return *time <=> Rational(k) / Rational(steps); };
  ++(at_step(0) == 0 ? counts.at_start : counts.later);
  const int near = static_cast<int>(std::floor(contact->time * steps));
  for (const int k : {0, near - 1, near, near + 1, static_cast<int>(entropy.below(steps))}) {
    if (k < 0 || k > steps) continue;
    if (at_step(k) > 0) {
      ASSERT_EQ(at(k, a, b), Relation::disjoint) << about << " at " << k;
    } else if (at_step(k) == 0) {
      const Relation r = at(k, a, b);
      ASSERT_NE(r, Relation::disjoint) << about << " at " << k;
      if (k == 0) {
        const Feature inside{FeatureKind::interior, 0};
        ASSERT_EQ(r == Relation::overlapping, contact->feature_a == inside) << about;
        ASSERT_EQ(contact->feature_a == inside, contact->feature_b == inside) << about;
      }
    }
  }
}

template <class... Shapes>
struct List {};

template <class A, class B>
void check_pair(std::uint64_t start, int cases, Counts& counts) {
  for (int i = 0; i < cases; ++i) {
    Entropy entropy(start, static_cast<std::uint64_t>(i));
    Draw draw(entropy);
    Translating<A> a{};
    Translating<B> b{};
    draw.fill(a.shape), draw.fill(b.shape);
    a.by = draw.motion();
    if (entropy.coin()) b.by = draw.motion();
    check("start " + std::to_string(start) + " index " + std::to_string(i), a, b, entropy, counts);
    if (testing::Test::HasFatalFailure()) return;
  }
}

#if defined(PLUMB_LONG_TESTS)
constexpr int cases = 20'000;
#else
const int cases = battery::sanitized ? 150 : 500;
#endif

template <class A, class... B>
void check_with(std::uint64_t start, List<B...>) {
  Counts counts;
  (check_pair<A, B>(start++, cases, counts), ...);
  const int few = 9 * cases / 100;
  EXPECT_GT(counts.never, few) << start;
  EXPECT_GT(counts.later, few) << start;
  EXPECT_GT(counts.at_start, few / 4) << start;
}

using All = List<Point3, Segment3, Triangle3, Aabb3, Obb3, ConvexPolyhedron3, Sphere3, Capsule3, Plane3>;

TEST(TranslatingContact, Points) { check_with<Point3>(100, All{}); }
TEST(TranslatingContact, Segments) { check_with<Segment3>(200, All{}); }
TEST(TranslatingContact, Triangles) { check_with<Triangle3>(300, All{}); }
TEST(TranslatingContact, Boxes) { check_with<Aabb3>(400, All{}); }
TEST(TranslatingContact, OrientedBoxes) { check_with<Obb3>(500, All{}); }
TEST(TranslatingContact, Polyhedra) { check_with<ConvexPolyhedron3>(600, All{}); }
TEST(TranslatingContact, Spheres) { check_with<Sphere3>(700, All{}); }
TEST(TranslatingContact, Capsules) { check_with<Capsule3>(800, All{}); }

namespace oracle = translating_oracle;
using oracle::Told;

template <class A, class B>
void check_truth(const std::string& about, const Translating<A>& a, const Translating<B>& b, Told& told) {
  oracle::check_truth(
      about, {oracle::body(a.shape), oracle::vector(a.by)}, {oracle::body(b.shape), oracle::vector(b.by)},
      {first_contact_time(a, b), first_contact(a, b), first_contact(b, a), intersects(a, b), intersects(b, a)}, told);
}

#if defined(PLUMB_LONG_TESTS)
constexpr int true_cases = 1000;
#else
const int true_cases = battery::sanitized ? 15 : 50;
#endif

template <class A, class B>
void check_pair_truth(std::uint64_t start, Told& told) {
  for (int i = 0; i < true_cases; ++i) {
    Entropy entropy(start, static_cast<std::uint64_t>(i));
    const auto numbers = static_cast<Numbers>(i % 5);
    Draw draw(entropy, numbers);
    Translating<A> a{};
    Translating<B> b{};
    draw.fill(a.shape), draw.fill(b.shape);
    a.by = draw.motion();
    if (entropy.coin()) b.by = draw.motion();
    check_truth("start " + std::to_string(start) + " index " + std::to_string(i), a, b, told);
    if (testing::Test::HasFatalFailure()) return;
  }
}

template <class... A>
void check_truths(List<A...>) {
  Told told;
  std::uint64_t start = 1000;
  const auto with_all = [&]<class First, class... B>(List<First>, List<B...>) {
    (check_pair_truth<First, B>(start++, told), ...);
  };
  (with_all(List<A>{}, All{}), ...);
  const int few = true_cases * 72 / 20;
  EXPECT_GT(told.never, few);
  EXPECT_GT(told.at_start, few);
  EXPECT_GT(told.later, few);
  EXPECT_GT(told.irrational, few / 4);
}

TEST(TranslatingContact, IsTrueOfAnyNumbers) {
  check_truths(List<Point3, Segment3, Triangle3, Aabb3, Obb3, ConvexPolyhedron3, Sphere3, Capsule3>{});
}

/// With half extents of the other signs, which say the same box.
template <class A>
A with_other_signs(const A& a) {
  if constexpr (std::same_as<A, Obb3>) {
    return {a.center, a.axes, {-a.half.x, a.half.y, -a.half.z}};
  } else {
    return a;
  }
}

template <class A, class B>
void check_laws(std::uint64_t start) {
  for (int i = 0; i < true_cases; ++i) {
    Entropy entropy(start, static_cast<std::uint64_t>(i));
    Draw draw(entropy);
    Translating<A> a{};
    Translating<B> b{};
    draw.fill(a.shape), draw.fill(b.shape);
    a.by = draw.motion(), b.by = draw.motion();
    const std::string about = "start " + std::to_string(start) + " index " + std::to_string(i);
    const std::optional<Contact> contact = first_contact(a, b);
    if constexpr (std::same_as<A, Obb3> || std::same_as<B, Obb3>) {
      const Translating<A> c{with_other_signs(a.shape), a.by};
      const Translating<B> d{with_other_signs(b.shape), b.by};
      ASSERT_EQ(contact, first_contact(c, d)) << about << " of half extents of other signs";
    }
    const double f = std::ldexp(1, static_cast<int>(entropy.within(1000)));
    ASSERT_EQ(contact, first_contact(Translating<A>{scaled(a.shape, f), scaled(a.by, f)},
                                     Translating<B>{scaled(b.shape, f), scaled(b.by, f)}))
        << about << " scaled by " << f;
    const Vector3 way = draw.motion(), also = draw.motion();
    const auto with = [](const Vector3& v, const Vector3& w) { return Vector3{v.x + w.x, v.y + w.y, v.z + w.z}; };
    ASSERT_EQ(contact, first_contact(Translating<A>{moved(a.shape, way), with(a.by, also)},
                                     Translating<B>{moved(b.shape, way), with(b.by, also)}))
        << about << " from elsewhere and both moving";
    const auto of_renamed =
        first_contact(Translating<A>{renamed(a.shape), a.by}, Translating<B>{renamed(b.shape), b.by});
    ASSERT_EQ(contact.has_value(), of_renamed.has_value()) << about;
    ASSERT_TRUE(!contact || contact->time == of_renamed->time) << about;
  }
}

template <class... A>
void check_all_laws(List<A...>) {
  std::uint64_t start = 2000;
  const auto with_all = [&]<class First, class... B>(List<First>, List<B...>) { (check_laws<First, B>(start++), ...); };
  (with_all(List<A>{}, All{}), ...);
}

TEST(TranslatingContact, IsTheSameOfWhatIsScaledMovedAndRenamed) {
  check_all_laws(List<Point3, Segment3, Triangle3, Aabb3, Obb3, ConvexPolyhedron3, Sphere3, Capsule3>{});
}

constexpr Feature face0{FeatureKind::face, 0};

TEST(TranslatingContact, SphereAgainstPlane) {
  const Plane3 wall{{3, 4, 0}, 50};  // 10 from the origin
  const auto hit = first_contact(Translating<Sphere3>{{{0, 0, 0}, 2}, {6, 8, 0}}, wall);
  ASSERT_TRUE(hit);
  EXPECT_EQ(*hit, (Contact{std::nextafter(0.8, 0.0), face0, face0}));
  EXPECT_TRUE(*first_contact_time(Translating<Sphere3>{{{0, 0, 0}, 2}, {6, 8, 0}}, wall) == Rational(4) / Rational(5));
  EXPECT_FALSE(first_contact(Translating<Sphere3>{{{0, 0, 0}, 2}, {4, 5, 0}}, wall));
  EXPECT_EQ(first_contact(Translating<Sphere3>{{{0, 0, 0}, 10}, {-1, 0, 0}}, wall)->time, 0);
  EXPECT_EQ(first_contact(wall, Translating<Sphere3>{{{0, 0, 0}, 2}, {6, 8, 0}}), hit);  // by the face of either
  EXPECT_TRUE(intersects(wall, Translating<Sphere3>{{{0, 0, 0}, 2}, {6, 8, 0}}));
  EXPECT_TRUE(*first_contact_time(wall, Translating<Sphere3>{{{0, 0, 0}, 2}, {6, 8, 0}}) == Rational(4) / Rational(5));
}

TEST(TranslatingContact, SpheresThatOnlyTouchInPassing) {
  // The nearest that the centers come is exactly the sum of the radii; an ulp more, and they miss.
  const Translating<Sphere3> a{{{-5, 3, 0}, 1}, {10, 0, 0}};
  const auto hit = first_contact(a, Sphere3{{0, 0, 0}, 2});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, 0.5);
  EXPECT_FALSE(intersects(a, Sphere3{{0, 0, 0}, std::nextafter(2.0, 0.0)}));
  // One that comes sooner: the time is a root, rounded down.
  const auto sooner = first_contact_time(a, Sphere3{{0, 0, 0}, std::nextafter(2.0, 3.0)});
  ASSERT_TRUE(sooner);
  EXPECT_TRUE(*sooner < Root(Rational(0.5)));
}

TEST(TranslatingContact, FeaturesOfABoxThatFallsOnATriangle) {
  const Triangle3 floor{{-10, -10, 0}, {10, -10, 0}, {0, 10, 0}};
  const Translating<Aabb3> box{{{-1, -1, 3}, {1, 1, 5}}, {0, 0, -6}};
  const auto flat = first_contact(box, floor);  // with a whole face: told by its first vertex
  ASSERT_TRUE(flat);
  EXPECT_EQ(*flat, (Contact{0.5, {FeatureKind::vertex, 0}, face0}));
  const Translating<Obb3> on_edge{{{0, 0, 4}, {{{1, 0, 1}, {0, 1, 0}, {-1, 0, 1}}}, {1, 1, 1}}, {0, 0, -4}};
  const auto edge = first_contact(on_edge, Segment3{{-10, 0, 0}, {10, 0, 0}});  // lowest: the edge along y at z = 2
  ASSERT_TRUE(edge);
  EXPECT_EQ(*edge, (Contact{0.5, {FeatureKind::edge, 4}, {FeatureKind::edge, 0}}));
}

TEST(TranslatingContact, FromTheStart) {
  const Aabb3 room{{0, 0, 0}, {10, 10, 10}};
  const auto inside = first_contact(Translating<Sphere3>{{{5, 5, 5}, 1}, {1, 0, 0}}, room);
  ASSERT_TRUE(inside);
  EXPECT_EQ(*inside, (Contact{0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}));
  const auto touching = first_contact(Translating<Sphere3>{{{-1, 5, 5}, 1}, {-1, 0, 0}}, room);
  ASSERT_TRUE(touching);
  EXPECT_EQ(*touching, (Contact{0, face0, {FeatureKind::face, 0}}));
}

TEST(TranslatingContact, AlongAPlaneAndBesideIt) {
  // Coplanar motion: an edge slides against a vertex in the plane of both.
  const Triangle3 a{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, b{{5, -1, 0}, {5, 4, 0}, {9, 0, 0}};
  const auto hit = first_contact(Translating<Triangle3>{a, {6, 0, 0}}, b);
  ASSERT_TRUE(hit);
  EXPECT_EQ(*hit, (Contact{0.5, {FeatureKind::vertex, 1}, {FeatureKind::edge, 0}}));
  const double just = std::numeric_limits<double>::denorm_min();
  EXPECT_FALSE(intersects(Translating<Triangle3>{a, {6, 0, just}}, b));
}

TEST(TranslatingContact, AnySizeOfNumbers) {
  const double huge = 0x1p1020, tiny = 0x1p-1060;
  EXPECT_EQ(first_contact(Translating<Point3>{{0, 0, 0}, {huge, 0, 0}}, Sphere3{{huge, 0, 0}, huge / 2})->time, 0.5);
  EXPECT_EQ(first_contact(Translating<Point3>{{0, 0, 0}, {tiny, 0, 0}}, Sphere3{{tiny, 0, 0}, tiny / 2})->time, 0.5);
  EXPECT_EQ(first_contact(Translating<Segment3>{{{0, -huge, 0}, {0, huge, 0}}, {tiny, 0, 0}},
                          Segment3{{tiny / 4, 0, -huge}, {tiny / 4, 0, huge}})
                ->time,
            0.25);
}

// Sums of products overflow, and what is infinite bounds nothing.
TEST(TranslatingContact, SizesWhoseProductsOverflow) {
  for (const double s : {0x1p300, 0x1p340, 0x1p342, 0x1p400, 0x1p500, 0x1p511, 0x1p700}) {
    const Triangle3 floor{{-s, -s, 0}, {s, -s, 0}, {0, s, 0}};
    const Obb3 turned{{0, 0, 2 * s}, {{{s, s, 0}, {-s, s, 0}, {0, 0, s}}}, {0.25, 0.25, 0.5}};
    const Segment3 rod{{0, 0, s}, {s / 4, 0, 3 * s}};
    const Vector3 down{0, 0, -4 * s}, aside{8 * s, 0, -s / 2};
    EXPECT_EQ(first_contact(Translating<Obb3>{turned, down}, floor)->time, 0.375) << s;
    EXPECT_EQ(first_contact(Translating<Segment3>{rod, down}, floor)->time, 0.25) << s;
    EXPECT_EQ(first_contact(Translating<Triangle3>{floor, {0, 0, 4 * s}}, turned)->time, 0.375) << s;
    EXPECT_FALSE(intersects(Translating<Obb3>{turned, aside}, floor)) << s;
    EXPECT_FALSE(intersects(Translating<Segment3>{rod, aside}, floor)) << s;
  }
}

TEST(TranslatingContact, ATimeThatVanishesIsNotTheStart) {
  const Translating<Aabb3> a{{{-1, 0, 0}, {0, 1, 1}},
                             {4, 1, 0}};  // leaves b along y as it starts, and then enters along x
  const Translating<Aabb3> b{{{0x1p-1074, -1, 0}, {1, 0, 1}}, {0, 0, 0}};
  EXPECT_FALSE(intersects(a, b));
  EXPECT_FALSE(intersects(b, a));
  EXPECT_FALSE(first_contact(a, b));
}

TEST(TranslatingContact, WhatIsNoShape) {
  const Translating<Sphere3> ball{{{0, 0, 0}, -1}, {1, 0, 0}};
  EXPECT_EQ(text_of<InvalidShape>([&] {
              intersects(ball, Point3{0, 0, 0});
            }),
            "intersects: a.shape.radius is negative; give zero or more");
  EXPECT_EQ(text_of<InvalidShape>([&] {
              intersects(Point3{0, 0, 0}, Translating<ConvexPolyhedron3>{{}, {1, 0, 0}});
            }),
            "intersects: b.shape has no faces; make it by convex_polyhedron");
  const double nan = std::nan("");
  EXPECT_THAT(text_of<NonFinite>([&] {
                first_contact(Translating<Point3>{{0, nan, 0}, {1, 0, 0}}, Point3{0, 0, 0});
              }),
              testing::HasSubstr("first_contact: a.shape.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                intersects(Translating<Point3>{{0, 0, 0}, {nan, 0, 0}}, Point3{0, 0, 0});
              }),
              testing::HasSubstr("intersects: a.by.x is nan"));
  for (const double none : {nan, HUGE_VAL, -HUGE_VAL}) {  // balls are looked at by what tells whether they meet
    EXPECT_THROW(intersects(Translating<Sphere3>{{{0, none, 0}, 1}, {1, 0, 0}}, Sphere3{{3, 0, 0}, 1}), NonFinite);
    EXPECT_THROW(intersects(Translating<Sphere3>{{{0, 0, 0}, 1}, {1, 0, none}}, Sphere3{{3, 0, 0}, 1}), NonFinite);
    EXPECT_THROW(first_contact(Translating<Sphere3>{{{0, 0, 0}, 1}, {none, 0, 0}}, Point3{0, 0, 0}), NonFinite);
  }
  EXPECT_THROW(intersects(Translating<Sphere3>{{{0, 0, 0}, HUGE_VAL}, {1, 0, 0}}, Sphere3{{3, 0, 0}, 1}), NonFinite);
  EXPECT_THROW(intersects(Sphere3{{3, 0, 0}, nan}, Translating<Sphere3>{{{0, 0, 0}, 1}, {1, 0, 0}}), NonFinite);
}

TEST(TranslatingContact, ProductsThatOverflowTellNothing) {
  for (const int e : {0, 86, 100, 160}) {
    const auto scaled = [e](double x) { return std::ldexp(x, e); };
    const double s = scaled(1);
    const Translating<Capsule3> falling{{{-s, 0, 3 * s}, {s, s / 2, 4 * s}, s}, {0, 0, scaled(-2.4)}};
    const Segment3 rod{{-s, s, 0}, {2 * s, -s, 0}};
    const auto hit = first_contact(falling, rod);
    ASSERT_TRUE(hit) << e;
    EXPECT_NEAR(hit->time, 0.97906, 1e-5) << e;
  }
  const auto balls =
      first_contact(Translating<Sphere3>{{{0, 0, 0}, 0.25e78}, {0.55e78, 0, 0}}, Sphere3{{1e78, 0, 0}, 0.25e78});
  ASSERT_TRUE(balls);
  EXPECT_NEAR(balls->time, 0.5 / 0.55, 1e-15);
  const double far = 0x1.9a7f381c2ccc2p+250;  // the square of far times fast is beyond doubles, that of neither is
  const Translating<Sphere3> past{{{0, 0, 0}, far * 0x1p-31}, {0x1.3f4d0082593ep+261, 0, 0}};
  EXPECT_FALSE(intersects(past, Sphere3{{far, far * 0x1p-30, 0}, 0}));
  const double l = 1e103;
  EXPECT_TRUE(intersects(Translating<Triangle3>{{{0, 0, 0}, {l, l, 0}, {0, 0, l}}, {0, 0, 0}},
                         Segment3{{2e100, 1e100, 1e102}, {5e102, 6e102, 3e102}}));
}

}  // namespace
}  // namespace plumb

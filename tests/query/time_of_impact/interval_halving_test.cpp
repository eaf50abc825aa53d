#include "plumb/query/time_of_impact/interval_halving.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure/basic/thrown.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/query/time_of_impact/continuous_contact.hpp"
#include "plumb/query/time_of_impact/moving_distance.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {
namespace {

double below(double x) { return x > 0 ? std::nextafter(x, 0.0) : 0; }
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

/// A ball that moves straight, and another that rests; the bounds are a few ulps wide.
struct Balls {
  Translating<Sphere3> a;
  Sphere3 b;

  [[nodiscard]] double distance_at(double t) const {
    const auto apart = [&](double from, double by, double to) { return from + t * by - to; };
    const double d =
        std::hypot(apart(a.shape.center.x, a.by.x, b.center.x), apart(a.shape.center.y, a.by.y, b.center.y),
                   apart(a.shape.center.z, a.by.z, b.center.z));
    return std::fmax(0, d * (1 - 0x1p-45) - 0x1p-45 - (a.shape.radius + b.radius));
  }
  [[nodiscard]] double speed_between(double, double) const { return above(above(std::hypot(a.by.x, a.by.y, a.by.z))); }
};

TEST(IntervalHalving, FindsTheContactsOfBalls) {
  int meet = 0, miss = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy entropy(31, i);
    const auto number = [&] { return static_cast<double>(entropy.within(40)) / 4; };
    const auto point = [&] {
      const double x = number(), y = number(), z = number();
      return Point3{x, y, z};
    };
    const Point3 from = point(), to = point();
    const Translating<Sphere3> a{{from, std::fabs(number()) / 8}, {-2 * from.x, -2 * from.y, 1 - from.z}};
    const Sphere3 b{{to.x / 4, to.y / 4, to.z / 4}, std::fabs(number()) / 8};
    const std::optional<Root> time = first_contact_time(a, b);
    const std::optional<TimeSpan> span = first_contact_span(Balls{a, b});
    if (!span) {
      EXPECT_FALSE(time) << i;
      ++miss;
    } else if (time) {
      EXPECT_TRUE(*time <=> Rational(span->from) >= 0) << i;
      EXPECT_LE(span->to - span->from, 0x1p-20);
      EXPECT_LE(std::fabs(time->rounded() - span->from), 0x1p-10) << i;
      ++meet;
    }
  }
  EXPECT_GT(meet, 100);
  EXPECT_GT(miss, 100);
}

/// A rod of length 2 about the origin turns by a right angle, by rational points of the circle; a post stands at p.
struct Rod {
  Point2 p;

  [[nodiscard]] static Vector2 direction(double t) {
    const double square = 1 + t * t;
    return {(1 - t * t) / square, 2 * t / square};
  }
  [[nodiscard]] double distance_at(double t) const {
    const Vector2 u = direction(t);
    const double along = std::fmax(0, std::fmin(2, p.x * u.x + p.y * u.y));
    return std::fmax(0, below(std::hypot(p.x - along * u.x, p.y - along * u.y) - 0x1p-48));
  }
  [[nodiscard]] double speed_between(double, double) const { return 4; }  // 2 at the rod's end, times 2
};

TEST(IntervalHalving, ARodThatTurns) {
  // The direction (3, 4) / 5 is reached at t = 1 / 2.
  const auto met = first_contact_span(Rod{{0.6, 0.8}});
  ASSERT_TRUE(met);
  EXPECT_LE(met->from, 0.5);
  EXPECT_GE(met->to, 0.5 - 0x1p-20);
  EXPECT_GT(met->from, 0.5 - 0x1p-15);
  EXPECT_FALSE(first_contact_span(Rod{{1.5, 2}}));     // beyond its end
  EXPECT_FALSE(first_contact_span(Rod{{-0.5, 0.0}}));  // behind it
  // Beside the start, by little: more than the resolution can be, or told by a finer one.
  EXPECT_TRUE(first_contact_span(Rod{{0.5, -0x1p-30}}));
  EXPECT_FALSE(first_contact_span(Rod{{0.5, -0x1p-30}}, {.resolution = 0x1p-40}));
}

TEST(IntervalHalving, HistoryAndResolution) {
  std::vector<TimeSpan> history;
  const auto span = first_contact_span(Rod{{0.6, 0.8}}, {.resolution = 0.25, .history = &history});
  ASSERT_TRUE(span);
  EXPECT_EQ(*span, (TimeSpan{0.25, 0.5}));
  ASSERT_FALSE(history.empty());
  EXPECT_EQ(history.front(), (TimeSpan{0, 1}));
  EXPECT_EQ(history.back(), *span);
  EXPECT_EQ(text_of<Error>([] {
              first_contact_span(Rod{{0.6, 0.8}}, {.resolution = 0});
            }),
            "first_contact_span: the resolution must be above zero");
}

struct Silent {
  [[nodiscard]] static double distance_at(double) { return std::nan(""); }
  [[nodiscard]] static double speed_between(double, double) { return 1; }
};

TEST(IntervalHalving, WhatSaysNothingMayMeetAtOnce) {
  const auto span = first_contact_span(Silent{});
  ASSERT_TRUE(span);
  EXPECT_EQ(span->from, 0);
}

// RTCD figure 5.33: a moving ball, here its center against all within its radius, and the spans that are looked at: a
// half that is surely clear is left, the other is halved again.
TEST(IntervalHalving, StepsTowardTheContact533) {
  std::vector<TimeSpan> history;
  const Capsule3 grown{{20, -9, 0}, {20, 9, 0}, 3.5};  // touched when x is 16.5, at 33 / 64
  const auto span = first_contact_span(Translating<Point3>{{0, 0, 0}, {32, 0, 0}}, Translating<Capsule3>{grown, {}},
                                       {.resolution = 1.0 / 16, .history = &history});
  ASSERT_TRUE(span);
  EXPECT_EQ(*span, (TimeSpan{0.5, 0.5625}));
  EXPECT_THAT(history, testing::ElementsAre(TimeSpan{0, 1}, TimeSpan{0, 0.5}, TimeSpan{0.5, 1}, TimeSpan{0.5, 0.75},
                                            TimeSpan{0.5, 0.625}, TimeSpan{0.5, 0.5625}));
}

/// Of the exact answer, where there is one: the span begins no later, and nothing is right.
struct Held {
  int met = 0, missed = 0, near_misses = 0;

  template <class A, class B>
  void ask(const A& a, const B& b, const std::optional<Root>& time, std::uint64_t index) {
    const auto span = first_contact_span(a, b, {.resolution = 0x1p-12});
    const auto swapped = first_contact_span(b, a, {.resolution = 0x1p-12});
    EXPECT_EQ(span.has_value(), swapped.has_value()) << index;
    if (!span) {
      EXPECT_FALSE(time) << index;
      ++missed;
    } else if (time) {
      EXPECT_TRUE(*time >= Rational(span->from)) << index;
      EXPECT_LE(span->to - span->from, 0x1p-12) << index;
      ++met;
    } else {
      ++near_misses;
    }
  }
  ~Held() {
    std::printf("met %d, missed %d, nearly %d\n", met, missed, near_misses);
    EXPECT_GT(met, 25);
    EXPECT_GT(missed, 50);
    EXPECT_LT(near_misses, met);
  }
};

class Numbers {
 public:
  explicit Numbers(Entropy& entropy)
      : entropy_(entropy), scale_(std::ldexp(1 / 3.0, entropy.below(4) == 0 ? 300 : 0)) {}
  double operator()() { return static_cast<double>(entropy_.within(8)) * scale_; }
  Point3 point() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
  Triangle3 triangle() {
    const Point3 a = point(), b = point(), c = point();
    return {a, b, c};
  }
  Segment3 segment() {
    const Point3 a = point(), b = point();
    return {a, b};
  }
  Vector3 vector() {
    const Point3 p = point();
    return {p.x, p.y, p.z};
  }

 private:
  Entropy& entropy_;
  double scale_;
};

TEST(IntervalHalving, OfDistancesIsNeverLate) {
  Held straight, corners, edges, solids;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Entropy entropy(41, i);
    Numbers n(entropy);
    const Translating<Triangle3> a{n.triangle(), n.vector()}, b{n.triangle(), n.vector()};
    straight.ask(a, b, first_contact_time(a, b), i);
    const Translating<Point3> p{n.point(), n.vector()};
    const Translating<Capsule3> c{{n.point(), n.point(), std::fabs(n())}, n.vector()};
    straight.ask(p, c, first_contact_time(p, c), i);
    const Vector3 u = n.vector(), v = n.vector(), w = n.vector();
    const Translating<Obb3> rock{{n.point(), {u, v, w}, {0.5, 0.25, 0.5}}, n.vector()};
    const Translating<Sphere3> ball{{n.point(), std::fabs(n())}, n.vector()};
    const Point3 low = n.point(), high = n.point();
    const Translating<Aabb3> box{{{std::fmin(low.x, high.x), std::fmin(low.y, high.y), std::fmin(low.z, high.z)},
                                  {std::fmax(low.x, high.x), std::fmax(low.y, high.y), std::fmax(low.z, high.z)}},
                                 n.vector()};
    solids.ask(rock, box, first_contact_time(rock, box), i);
    solids.ask(ball, box, first_contact_time(ball, box), i);
    const Moving<Point3> corner{n.point(), n.point()};
    const Moving<Triangle3> face{n.triangle(), n.triangle()};
    corners.ask(corner, face, first_contact_time(corner, face), i);
    const Moving<Segment3> edge{n.segment(), n.segment()}, other{n.segment(), n.segment()};
    edges.ask(edge, other, first_contact_time(edge, other), i);
  }
}

TEST(IntervalHalving, OfDistancesThatHaveNoContactTime) {
  const Polygon3 frame{{{5, 0, 0}, {5, 4, 0}, {5, 4, 4}, {5, 2, 1}, {5, 0, 4}}};  // with a notch above (5, 2, 1)
  const Translating<Polygon3> wall{frame, {0, 0, 0}};
  const auto through = [&](double z) { return first_contact_span(Translating<Point3>{{0, 2, z}, {8, 0, 0}}, wall); };
  ASSERT_TRUE(through(0.5));
  EXPECT_LE(through(0.5)->from, 0.625);
  EXPECT_GE(through(0.5)->to, 0.625);
  EXPECT_FALSE(through(1.5));
  // Two triangles whose corners move: one folds over and meets the other by its edge.
  const Triangle3 rest{{-4, -4, 1}, {4, -4, 1}, {0, 4, 1}}, open{{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const Moving<Triangle3> still{rest, rest};
  const auto folded = first_contact_span(Moving<Triangle3>{open, {{-1, 0, 0}, {1, 0, 0}, {0, 0, 2}}}, still);
  ASSERT_TRUE(folded);
  EXPECT_LE(folded->from, 0.5);
  EXPECT_GE(folded->to, 0.5);
  EXPECT_FALSE(first_contact_span(Moving<Triangle3>{open, {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0.875}}}, still));
}

TEST(IntervalHalving, NamesWhatIsNoNumber) {
  const double nan = std::nan("");
  const auto text = [](auto ask) { return text_of<NonFinite>(ask); };
  EXPECT_THAT(text([&] {
                first_contact_span(Translating<Point3>{{0, nan, 0}, {}}, Translating<Point3>{{0, 0, 0}, {}});
              }),
              testing::HasSubstr("first_contact_span: a.shape.y is nan"));
  EXPECT_THAT(text([&] {
                first_contact_span(Translating<Point3>{{0, 0, 0}, {}}, Translating<Point3>{{1, 0, 0}, {0, 0, nan}});
              }),
              testing::HasSubstr("first_contact_span: b.by.z is nan"));
  EXPECT_THAT(
      text([&] {
        first_contact_span(Translating<Capsule3>{{{0, 0, 0}, {1, 0, 0}, 1}, {nan, 0, 0}}, Translating<Point3>{});
      }),
      testing::HasSubstr("first_contact_span: a.by.x is nan"));
  const Triangle3 t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, bad{{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}};
  EXPECT_THAT(text([&] {
                first_contact_span(Moving<Triangle3>{t, bad}, Moving<Triangle3>{t, t});
              }),
              testing::HasSubstr("first_contact_span: a.to.c.y is inf"));
}

}  // namespace
}  // namespace plumb

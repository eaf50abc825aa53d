#include "plumb/query/interval_halving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure/thrown.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/query/translating_contact.hpp"

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

}  // namespace
}  // namespace plumb

// Bodies that turn: does no contact come before the span that is told, or of a pair that is not told, however fast and
// thin they are?  At times where the poses are doubles, each two figures are asked exactly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb {
namespace {

using drawn_world::Drawn;

constexpr HalvingOptions coarse{.resolution = 0x1p-8};

struct Turned {
  Drawn drawn;
  std::optional<RigidPose> from, to;
  BodyHandle handle;

  /// Exactly: quaternions of integers, weighted by integers, are those of the time m / n.
  [[nodiscard]] Drawn at(int m, int n) const {
    if (!to) return from ? drawn.under(*from) : drawn;
    const RigidPose& p = *from;
    const RigidPose& q = *to;
    const auto mix = [&](double a, double b) { return (n - m) * a + m * b; };
    const RigidPose pose{
        {mix(p.turn.w, q.turn.w), mix(p.turn.x, q.turn.x), mix(p.turn.y, q.turn.y), mix(p.turn.z, q.turn.z)},
        {mix(p.translation.x, q.translation.x) / n, mix(p.translation.y, q.translation.y) / n,
         mix(p.translation.z, q.translation.z) / n}};
    if (pose.turn == Rotation{0, 0, 0, 0}) return drawn.under(p);  // no turn: nothing is known there
    return drawn.under(pose);
  }
};

bool are_met(const Drawn& a, const Drawn& b) {
  for (const auto& part_a : a.figures) {
    for (const AnyFigure& p : part_a) {
      for (const auto& part_b : b.figures) {
        for (const AnyFigure& q : part_b) {
          if (intersects(p, q)) return true;
        }
      }
    }
  }
  return false;
}

TEST(WorldTurns, NoContactComesBeforeItsSpan) {
  constexpr int n = 16;
  int told = 0, certain = 0, at_start = 0, never = 0, seen = 0;
  for (std::uint64_t run = 0; run < 40; ++run) {
    SCOPED_TRACE("replay: Entropy(4800, " + std::to_string(run) + ")");
    Entropy e(4800, run);
    CollisionWorld world;
    std::vector<Turned> all;
    std::vector<BodyTurn> turns;
    for (std::uint64_t id = 0; id < 5; ++id) {
      Turned t{drawn_world::body(e), drawn_world::pose(e), std::nullopt, {}};
      t.handle = world.add(t.drawn.body, {.user_id = id});
      world.move(t.handle, *t.from);
      if (e.below(3) != 0) {
        t.to = drawn_world::pose(e);
        turns.push_back({t.handle, *t.to});
      }
      all.push_back(t);
    }
    std::map<std::pair<std::size_t, std::size_t>, WorldContactSpan> spans;
    double last = 0;
    for (const WorldContactSpan& c : world.first_contact_spans(turns, coarse)) {
      EXPECT_LE(last, c.span.from);
      last = c.span.from;
      EXPECT_LE(c.span.to - c.span.from, coarse.resolution);
      EXPECT_TRUE(spans.insert({{c.id_a, c.id_b}, c}).second);
      ++told, certain += c.is_certain ? 1 : 0, at_start += c.span.to > 0 ? 0 : 1;
    }
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        const auto at = spans.find({a, b});
        if (!all[a].to && !all[b].to) {
          EXPECT_TRUE(at == spans.end());
          continue;
        }
        never += at == spans.end() ? 1 : 0;
        for (int m = 0; m <= n; ++m) {
          const double t = double(m) / n;
          if (at != spans.end() && t >= at->second.span.from) break;
          EXPECT_FALSE(are_met(all[a].at(m, n), all[b].at(m, n))) << a << " and " << b << " at " << t;
          ++seen;
        }
        if (at == spans.end()) continue;
        const TimeSpan& span = at->second.span;
        if (span.to == 0 || span.from == 0) {
          EXPECT_EQ(are_met(all[a].at(0, 1), all[b].at(0, 1)), span.to == 0) << a << " and " << b;
        }
        if (at->second.is_certain) {  // at one of its ends
          const int m = int(span.to * 4096);
          EXPECT_EQ(m, span.to * 4096);
          EXPECT_TRUE(are_met(all[a].at(m, 4096), all[b].at(m, 4096)));
        }
      }
    }
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("%d told, %d of them certain, %d at the start; %d never meet, %d times without contact\n", told, certain,
              at_start, never, seen);
  EXPECT_GT(told, 60);
  EXPECT_GT(certain, 30);
  EXPECT_GT(at_start, 10);
  EXPECT_GT(told - at_start, 10);
  EXPECT_GT(never, 20);
  EXPECT_GT(seen, 500);
}

/// A needle along x that turns by half a turn about z.
struct Needle {
  CollisionWorld world;
  BodyHandle needle = world.add(Segment3{{1, 0, 0}, {4, 0, 0}}, {.user_id = 1});
  std::vector<BodyTurn> turns{{needle, RigidPose{{0, 0, 0, 1}, {0, 0, 0}}}};
};

// Both ends of the motion are apart from the blade, as thin as a triangle, that the needle sweeps through; the needle
// points upward at half the time, for the quaternion is (1, 0, 0, 1) there.
TEST(WorldTurns, NothingTunnels) {
  Needle n;
  n.world.add(Triangle3{{0, 2, -1}, {0, 2, 1}, {0, 3, 0}}, {.user_id = 2});
  n.world.add(Triangle3{{0, -2, -1}, {0, -2, 1}, {0, -3, 0}}, {.user_id = 3});
  const auto told = n.world.first_contact_spans(n.turns);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].id_b, 2U);
  EXPECT_LE(told[0].span.from, 0.5);
  EXPECT_GE(told[0].span.to, 0.5);
  EXPECT_LE(told[0].span.to - told[0].span.from, 0x1p-12);
  EXPECT_TRUE(told[0].is_certain);
}

// The tip runs along a circle: a wall at its highest place is grazed, one a little farther is not reached, for certain.
TEST(WorldTurns, GrazesAreToldAndMissesAreNot) {
  for (const bool grazes : {true, false}) {
    Needle n;
    n.world.add(Aabb3{{-1, grazes ? 4 : 4.001, -1}, {1, 5, 1}}, {.user_id = 2});
    const auto told = n.world.first_contact_spans(n.turns, {.resolution = 0x1p-10});
    ASSERT_EQ(told.size(), grazes ? 1U : 0U);
    if (!grazes) continue;
    EXPECT_LE(told[0].span.from, 0.5);
    EXPECT_GE(told[0].span.to + 0x1p-5, 0.5);
  }
}

TEST(WorldTurns, WhatTouchesAtTheStartIsToldThere) {
  Needle n;
  const BodyHandle wall = n.world.add(Aabb3{{4, -1, -1}, {5, 1, 1}}, {.user_id = 2});
  auto told = n.world.first_contact_spans(n.turns);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0], (WorldContactSpan{1, 2, n.needle, wall, {0, 0}, true}));
  n.world.move(wall, RigidPose{{}, {0x1p-50, 0, 0}});  // and by the least that is apart
  told = n.world.first_contact_spans(n.turns);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].span.from, 0);
  EXPECT_FALSE(told[0].is_certain);
}

// What only moves straight is met at its exact time; what meets at the end is told there.
TEST(WorldTurns, StraightMotionsAreTurnsToo) {
  CollisionWorld world;
  const BodyHandle ball = world.add(Sphere3{{0, 0, 0}, 1}, {.user_id = 1});
  world.add(Sphere3{{6, 0, 0}, 1}, {.user_id = 2});
  for (const auto& [by, at] : {std::pair{8.0, 0.5}, std::pair{4.0, 1.0}}) {
    const std::vector<BodyTurn> turns{{ball, RigidPose{{-3, 0, 0, 0}, {by, 0, 0}}}};  // by a path through zero
    EXPECT_EQ(world.first_contact_spans(turns).size(), 1U);
    const std::vector<BodyTurn> plain{{ball, RigidPose{{3, 0, 0, 0}, {by, 0, 0}}}};
    const auto told = world.first_contact_spans(plain);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_LE(told[0].span.from, at);
    EXPECT_GE(told[0].span.to, at);
    EXPECT_TRUE(told[0].is_certain);
  }
  const std::vector<BodyTurn> stays{{ball, RigidPose{{5, 0, 0, 0}, {0, 0, 0}}}};
  EXPECT_TRUE(world.first_contact_spans(stays).empty());
}

TEST(WorldTurns, BadTurnsNameTheBodyAndFiltersHold) {
  Needle n;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BodyHandle wall = n.world.add(Aabb3{{-1, 3, -1}, {1, 5, 1}}, {.user_id = 2});
  const auto ask = [&](const BodyHandle& body, const RigidPose& to) {
    const std::vector<BodyTurn> turns{{body, to}};
    return n.world.first_contact_spans(turns);
  };
  EXPECT_EQ(n.world.first_contact_spans(n.turns).size(), 1U);
  EXPECT_THROW(static_cast<void>(ask(n.needle, RigidPose{{0, 0, 0, 0}, {0, 0, 0}})), InvalidShape);
  EXPECT_THROW(static_cast<void>(ask(n.needle, RigidPose{{nan, 0, 0, 0}, {0, 0, 0}})), NonFinite);
  EXPECT_THROW(static_cast<void>(ask(n.needle, RigidPose{{}, {0, nan, 0}})), NonFinite);
  const std::vector<BodyTurn> twice{n.turns[0], n.turns[0]};
  EXPECT_THROW(static_cast<void>(n.world.first_contact_spans(twice)), InvalidShape);
  EXPECT_THROW(static_cast<void>(n.world.first_contact_spans(n.turns, {.resolution = 0})), Error);
  const BodyHandle chained = n.world.add(AnyFigure(Point3{9, 9, 9}).under(RigidChain{{{}, {}}}), {.user_id = 7});
  try {
    static_cast<void>(ask(chained, {}));
    ADD_FAILURE() << "nothing thrown";
  } catch (const UnevenPose& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("first_contact_spans: body 7"));
  }
  n.world.allow_collision(n.needle, wall);
  EXPECT_TRUE(n.world.first_contact_spans(n.turns).empty());
  n.world.remove(n.needle);
  EXPECT_THROW(static_cast<void>(n.world.first_contact_spans(n.turns)), StaleHandle);
}

// A figure that turns through a world is told the spans that it has as a body of it.
TEST(WorldTurns, CastsOfFiguresAreThoseOfBodies) {
  int told = 0;
  for (std::uint64_t run = 0; run < 60; ++run) {
    SCOPED_TRACE("replay: Entropy(4801, " + std::to_string(run) + ")");
    Entropy e(4801, run);
    CollisionWorld with, without;
    const AnyFigure moving = drawn_world::figure(e).under(drawn_world::pose(e));
    const BodyHandle mover = with.add(moving, {.user_id = 99});
    for (std::uint64_t id = 0; id < 6; ++id) {
      const Drawn drawn = drawn_world::body(e).under(drawn_world::pose(e));
      const BodyOptions options{.group = 1U + std::uint32_t(e.below(2)), .user_id = id};
      with.add(drawn.body, options), without.add(drawn.body, options);
    }
    const RigidPose to = drawn_world::pose(e);
    const std::vector<BodyTurn> turns{{mover, to}};
    std::vector<WorldCastSpan> expected;
    for (const WorldContactSpan& c : with.first_contact_spans(turns, coarse)) {
      const bool is_b = c.id_a == 99;
      const BodyHandle other = is_b ? c.b : c.a;
      if ((with.options(other).group & 2) == 0) continue;
      expected.push_back({is_b ? c.id_b : c.id_a, {other.slot - 1, other.generation}, c.span, c.is_certain});
    }
    EXPECT_EQ(without.contact_spans_along(moving, to, 2, coarse.resolution), expected);
    told += int(expected.size());
  }
  std::printf("%d told\n", told);
  EXPECT_GT(told, 15);
  const Needle n;
  EXPECT_THROW(static_cast<void>(n.world.contact_spans_along(Sphere3{{0, 0, 0}, 1}, {}, every_group, 0)), Error);
  try {
    const AnyFigure chained = AnyFigure(Point3{9, 9, 9}).under(RigidChain{{{}, {}}});
    static_cast<void>(n.world.contact_spans_along(chained, {}));
    ADD_FAILURE() << "nothing thrown";
  } catch (const UnevenPose& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("contact_spans_along: figure"));
  }
}

}  // namespace
}  // namespace plumb

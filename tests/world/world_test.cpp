// Worlds: are the pairs that meet, and what begins, is kept and ends, those of asking each pair, whatever was added,
// moved, replaced, removed and filtered, and in whatever order?
#include "plumb/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb {
namespace {

using Ids = std::pair<std::uint64_t, std::uint64_t>;
using Meetings = std::map<Ids, Relation>;

struct Known {
  AnyFigure figure;
  BodyOptions options;
  BodyHandle handle;
};

/// What a world must say, by asking each pair.
struct ByEachPair {
  std::map<std::uint64_t, Known> bodies;
  std::map<Ids, bool> allowed;
  bool is_odd_left_out = false;

  [[nodiscard]] Meetings meetings() const {
    Meetings found;
    for (auto a = bodies.begin(); a != bodies.end(); ++a) {
      for (auto b = std::next(a); b != bodies.end(); ++b) {
        const BodyOptions &x = a->second.options, &y = b->second.options;
        if ((x.group & y.mask) == 0 || (y.group & x.mask) == 0) continue;
        if (allowed.contains({a->first, b->first})) continue;
        if (is_odd_left_out && (a->first + b->first) % 2 == 1) continue;
        const Relation r = relate(a->second.figure, b->second.figure);
        if (r != Relation::disjoint) found[{a->first, b->first}] = r;
      }
    }
    return found;
  }
};

/// Of pairs that ascend by ids, each once.
Meetings as_meetings(const std::vector<WorldPair>& pairs) {
  Meetings found;
  Ids last{0, 0};
  for (const WorldPair& p : pairs) {
    const Ids ids{p.id_a, p.id_b};
    EXPECT_LT(last, ids);
    last = ids;
    found[ids] = p.relation;
  }
  return found;
}

struct Counts {
  int begun = 0, kept = 0, ended = 0, touching = 0, overlapping = 0;
};

void expect_events(const WorldEvents& events, const Meetings& before, const Meetings& now, Counts& counts) {
  Meetings begun, kept, ended;
  for (const auto& [ids, r] : now) (before.contains(ids) ? kept : begun)[ids] = r;
  for (const auto& [ids, r] : before) {
    if (!now.contains(ids)) ended[ids] = r;
  }
  EXPECT_EQ(as_meetings(events.begun), begun);
  EXPECT_EQ(as_meetings(events.kept), kept);
  EXPECT_EQ(as_meetings(events.ended), ended);
  counts.begun += int(begun.size());
  counts.kept += int(kept.size());
  counts.ended += int(ended.size());
  for (const auto& [ids, r] : now) ++(r == Relation::touching ? counts.touching : counts.overlapping);
}

void add_body(CollisionWorld& world, ByEachPair& all, std::uint64_t id, Entropy& e) {
  const BodyOptions options{std::uint32_t(1 + e.below(3)), e.below(4) == 0 ? 1U : 0xffffffffU, id};
  AnyFigure figure = drawn_world::figure(e);
  if (e.coin()) figure = figure.under(drawn_world::pose(e));
  all.bodies.insert({id, Known{figure, options, world.add(figure, options)}});
}

/// One of those there are.
Known& drawn_body(ByEachPair& all, Entropy& e) {
  return std::next(all.bodies.begin(), std::ptrdiff_t(e.below(all.bodies.size())))->second;
}

void change(CollisionWorld& world, ByEachPair& all, std::uint64_t& next_id, std::vector<BodyHandle>& stale,
            Entropy& e) {
  const std::uint64_t what = e.below(8);
  if (all.bodies.size() < 5 || what == 0) return add_body(world, all, next_id++, e);
  Known& body = drawn_body(all, e);
  if (what == 1) {
    const std::uint64_t id = body.options.user_id;
    world.remove(body.handle);
    stale.push_back(body.handle);
    all.bodies.erase(id);
    std::erase_if(all.allowed, [&](const auto& row) { return row.first.first == id || row.first.second == id; });
  } else if (what == 2) {
    body.figure = drawn_world::figure(e);
    world.replace(body.handle, body.figure);
  } else if (what == 3) {
    const Known& other = drawn_body(all, e);
    const Ids ids = std::minmax(body.options.user_id, other.options.user_id);
    const bool is_allowed = e.coin();
    world.allow_collision(body.handle, other.handle, is_allowed);
    if (is_allowed) {
      all.allowed[ids] = true;
    } else {
      all.allowed.erase(ids);
    }
  } else {
    const RigidPose pose = drawn_world::pose(e);
    body.figure = body.figure.under(pose);
    world.move(body.handle, pose);
  }
}

void expect_overlaps(const CollisionWorld& world, const ByEachPair& all, const AnyFigure& region) {
  std::vector<BodyHandle> expected;
  for (const auto& [id, body] : all.bodies) {
    if ((body.options.group & 2) != 0 && intersects(body.figure, region)) expected.push_back(body.handle);
  }
  EXPECT_EQ(world.overlaps(region, 2), expected);
}

TEST(CollisionWorld, ReplaysAsAskingEachPair) {
  Counts counts;
  for (std::uint64_t run = 0; run < 20; ++run) {
    Entropy e(4100, run);
    CollisionWorld world;
    ByEachPair all;
    std::uint64_t next_id = 1;
    std::vector<BodyHandle> stale;
    Meetings before;
    for (int frame = 0; frame < 60; ++frame) {
      SCOPED_TRACE("replay: Entropy(4100, " + std::to_string(run) + "), frame " + std::to_string(frame));
      const std::uint64_t changes = frame == 0 ? 60 : e.below(8);
      for (std::uint64_t i = 0; i < changes; ++i) change(world, all, next_id, stale, e);
      if (e.below(10) == 0) {
        all.is_odd_left_out = !all.is_odd_left_out;
        const auto is_even = [&world](const BodyHandle& a, const BodyHandle& b) {
          return (world.options(a).user_id + world.options(b).user_id) % 2 == 0;
        };
        if (all.is_odd_left_out) {
          world.set_filter(is_even);
        } else {
          world.clear_filter();
        }
      }
      const Meetings now = all.meetings();
      expect_events(world.commit(), before, now, counts);
      EXPECT_EQ(as_meetings(world.pairs()), now);
      EXPECT_EQ(world.size(), all.bodies.size());
      expect_overlaps(world, all, drawn_world::figure(e));
      if (frame % 5 == 0) {
        EXPECT_EQ(world.check(), std::vector<std::string>());
      }
      for (const BodyHandle& handle : stale) EXPECT_THROW(static_cast<void>(world.figure(handle)), StaleHandle);
      if (::testing::Test::HasFailure()) return;
      before = now;
    }
  }
  std::printf("%d begun, %d kept, %d ended; %d touching, %d overlapping\n", counts.begun, counts.kept, counts.ended,
              counts.touching, counts.overlapping);
  for (const int seen : {counts.begun, counts.kept, counts.ended, counts.touching, counts.overlapping}) {
    EXPECT_GT(seen, 200);
  }
}

TEST(CollisionWorld, OrderOfInsertionChangesNothing) {
  for (std::uint64_t run = 0; run < 20; ++run) {
    SCOPED_TRACE("replay: Entropy(4200, " + std::to_string(run) + ")");
    Entropy e(4200, run);
    std::vector<std::pair<std::uint64_t, AnyFigure>> bodies;
    for (std::uint64_t id = 1; id <= 20; ++id) bodies.emplace_back(id, drawn_world::figure(e));
    const auto answers = [&bodies] {
      CollisionWorld world;
      for (const auto& [id, figure] : bodies) world.add(figure, {.user_id = id});
      return as_meetings(world.commit().begun);
    };
    const Meetings first = answers();
    EXPECT_FALSE(first.empty());
    for (std::size_t i = bodies.size() - 1; i > 0; --i) std::swap(bodies[i], bodies[e.below(i + 1)]);
    EXPECT_EQ(answers(), first);
  }
}

// Each box rests on the one below; a step away by the least double is apart.
TEST(CollisionWorld, RestingBoxesTouch) {
  CollisionWorld world;
  std::vector<BodyHandle> boxes;
  for (int level = 0; level < 10; ++level) {
    boxes.push_back(world.add(Aabb3{{0, 0, 0.1 * level}, {1, 1, 0.1 * (level + 1)}}, {.user_id = unsigned(level)}));
  }
  EXPECT_EQ(world.commit().begun.size(), 9U);
  for (const WorldPair& p : world.pairs()) EXPECT_EQ(p.relation, Relation::touching);
  EXPECT_TRUE(world.commit().begun.empty());
  EXPECT_EQ(world.commit().kept.size(), 9U);
  world.move(boxes[9], RigidPose{{}, {0, 0, 0x1p-50}});
  ASSERT_EQ(world.commit().ended.size(), 1U);
  EXPECT_EQ(world.commit().kept.size(), 8U);
}

// Of bodies that have an inside a contact tells how they meet; of all others it is asked.
TEST(CollisionWorld, WithContactsTellsThePairsThatItTellsWithout) {
  std::array<int, 2> touching{};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Entropy e(4710, seed);
    CollisionWorld with({.contacts = true}), without;
    for (std::uint64_t id = 0; id < 12; ++id) {
      AnyFigure figure = drawn_world::figure(e);
      if (id % 3 == 0) {  // a box with an inside, or a flat one by its axes
        const double up = e.below(4) == 0 ? 0 : 1;
        figure = Obb3{{0, 0, 0}, {{{1, 0, 0}, {0, up, 0}, {1, 0, 2}}}, {1, 0.5, 0.5}};
      }
      const AnyFigure there = e.coin() ? figure : figure.under(drawn_world::pose(e));
      const BodyOptions options{.user_id = id, .margin = id % 2 == 0 ? 0 : 0.25};
      with.add(there, options), without.add(there, options);
    }
    with.commit(), without.commit();
    ASSERT_EQ(with.pairs().size(), without.pairs().size()) << "replay: Entropy(4710, " << seed << ")";
    for (std::size_t i = 0; i < with.pairs().size(); ++i) {
      const WorldPair &p = with.pairs()[i], &q = without.pairs()[i];
      EXPECT_TRUE(p.id_a == q.id_a && p.id_b == q.id_b && p.relation == q.relation)
          << "replay: Entropy(4710, " << seed << "), bodies " << p.id_a << " and " << p.id_b;
      ++touching[p.relation == Relation::touching ? 1 : 0];
    }
  }
  std::printf("%d pairs overlap, %d touch\n", touching[0], touching[1]);
  EXPECT_GT(std::min(touching[0], touching[1]), 200);
}

// As a game does that sets each pose in each frame: nothing is asked again, and nothing begins or ends; a cube that
// turns by a little, or a zero that changes its sign, is moved.
TEST(CollisionWorld, MovingToWhereItIsChangesNothing) {
  CollisionWorld world({.contacts = true});
  std::vector<BodyHandle> cubes;
  std::vector<RigidPose> poses;
  for (int level = 0; level < 6; ++level) {
    poses.push_back({{1, 0, 0, 0.125 * level}, {0, 0, 1.0 * level}});
    cubes.push_back(
        world.add(Posed{Aabb3{{-0.5, -0.5, 0}, {0.5, 0.5, 1}}, poses.back()}, {.user_id = unsigned(level)}));
  }
  EXPECT_EQ(world.commit().begun.size(), 5U);
  const std::vector<WorldContact> before = world.contacts();
  const auto expect_same = [&] {
    const WorldEvents& events = world.commit();
    EXPECT_TRUE(events.begun.empty() && events.ended.empty());
    EXPECT_EQ(events.kept.size(), 5U);
    EXPECT_TRUE(world.contact_events().begun.empty() && world.contact_events().ended.empty());
    ASSERT_EQ(world.contacts().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(world.contacts()[i].manifold, before[i].manifold);
  };
  for (std::size_t i = 0; i < cubes.size(); ++i) world.move(cubes[i], poses[i]);
  expect_same();
  world.move(cubes[3], RigidPose{{}, {9, 9, 9}});
  world.move(cubes[3], poses[3]);
  expect_same();
  poses[0].translation.x = -0.0;
  world.move(cubes[0], poses[0]);
  EXPECT_TRUE(std::signbit(std::get<RigidPose>(world.body(cubes[0]).pose()).translation.x));
  expect_same();
  poses[5].turn.z += 0x1p-10;
  world.move(cubes[5], poses[5]);
  EXPECT_TRUE(world.commit().ended.empty());
  EXPECT_NE(world.contacts().back().manifold, before.back().manifold);
}

// A slot that is used again has another generation; the old pair has ended, and the new one begun.
TEST(CollisionWorld, SlotsThatAreUsedAgainAreOtherBodies) {
  CollisionWorld world;
  const BodyHandle a = world.add(Sphere3{{0, 0, 0}, 1}, {.user_id = 1});
  const BodyHandle b = world.add(Sphere3{{1, 0, 0}, 1}, {.user_id = 2});
  EXPECT_EQ(world.commit().begun.size(), 1U);
  world.remove(b);
  const std::vector<WorldPair> ended = world.commit().ended;
  const BodyHandle c = world.add(Sphere3{{1, 0, 0}, 1}, {.user_id = 2});
  EXPECT_EQ(c.slot, b.slot);
  EXPECT_NE(c.generation, b.generation);
  const std::vector<WorldPair> begun = world.commit().begun;
  ASSERT_EQ(ended.size(), 1U);
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(ended[0].b, b);
  EXPECT_EQ(begun[0].b, c);
  world.remove(c);
  const BodyHandle d = world.add(Sphere3{{1, 0, 0}, 1}, {.user_id = 2});
  EXPECT_EQ(world.commit().ended, begun);
  EXPECT_EQ(world.commit().kept.at(0).b, d);
  EXPECT_THROW(world.move(b, {}), StaleHandle);
  EXPECT_THROW(world.remove(b), StaleHandle);
  EXPECT_THROW(world.replace(b, Sphere3{{0, 0, 0}, 1}), StaleHandle);
  EXPECT_THROW(world.allow_collision(a, b), StaleHandle);
  EXPECT_THROW(world.remove(BodyHandle{}), StaleHandle);
  EXPECT_FALSE(world.contains(b));
  EXPECT_FALSE(world.contains(c));
  EXPECT_TRUE(world.contains(d));
}

template <class Refusal, class Call>
void expect_refused(const std::string& says, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "nothing thrown; expected: " << says;
  } catch (const Refusal& e) {
    EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
  }
}

TEST(CollisionWorld, BadInputNamesTheBodyAndChangesNothing) {
  CollisionWorld world;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BodyHandle a = world.add(Sphere3{{0, 0, 0}, 1}, {.user_id = 41});
  world.add(Sphere3{{1, 0, 0}, 1}, {.user_id = 42});
  world.commit();
  const std::vector<WorldPair> before = world.pairs();
  expect_refused<NonFinite>("CollisionWorld::move: body 41", [&] { world.move(a, RigidPose{{}, {nan, 0, 0}}); });
  expect_refused<NonFinite>("CollisionWorld::move: body 41", [&] {
    world.move(a, RigidPose{{nan, 0, 0, 0}, {0, 0, 0}});
  });
  expect_refused<InvalidShape>("CollisionWorld::move: body 41", [&] {
    world.move(a, RigidPose{{0, 0, 0, 0}, {0, 0, 0}});
  });
  expect_refused<NonFinite>("CollisionWorld::add: body 43", [&] {
    world.add(Sphere3{{nan, 0, 0}, 1}, {.user_id = 43});
  });
  expect_refused<InvalidShape>("CollisionWorld::replace: body 41", [&] { world.replace(a, Sphere3{{0, 0, 0}, -1}); });
  expect_refused<Unsupported>("CollisionWorld::add: body 44", [&] { world.add(Circle2{{0, 0}, 1}, {.user_id = 44}); });
  expect_refused<Unsupported>("CollisionWorld::add: body 45", [&] {
    world.add(Plane3{{0, 0, 1}, 0}, {.user_id = 45});
  });
  expect_refused<UnevenPose>("CollisionWorld::add: body 46", [&] {
    world.add(Posed{Sphere3{{0, 0, 0}, 1}, Pose{}}, {.user_id = 46});
  });
  EXPECT_EQ(world.size(), 2U);
  EXPECT_TRUE(world.commit().begun.empty());
  EXPECT_EQ(world.pairs(), before);
}

TEST(CollisionWorld, AFilterThatThrowsChangesNothing) {
  CollisionWorld world;
  const BodyHandle floor = world.add(Aabb3{{-1, -1, -1}, {1, 1, 0}}, {.user_id = 1});
  const BodyHandle crate = world.add(Aabb3{{0, 0, 0}, {1, 1, 1}}, {.user_id = 2});
  ASSERT_EQ(world.commit().begun.size(), 1U);
  world.add(Sphere3{{0, 0, 2}, 1}, {.user_id = 3});
  world.move(crate, RigidPose{{}, {0, 0, 0x1p-40}});
  world.set_filter([](const BodyHandle&, const BodyHandle&) -> bool { throw Unsupported("not today"); });
  EXPECT_THROW(world.commit(), Unsupported);
  ASSERT_EQ(world.pairs().size(), 1U);
  EXPECT_EQ(world.pairs()[0].relation, Relation::touching);
  world.clear_filter();
  const WorldEvents& now = world.commit();
  ASSERT_EQ(now.ended.size(), 1U);
  EXPECT_EQ(now.ended[0].a, floor);
  ASSERT_EQ(now.begun.size(), 1U);
  EXPECT_EQ(now.begun[0].id_b, 3U);
  CollisionWorld moved = std::move(world);
  EXPECT_EQ(moved.size(), 3U);
  EXPECT_EQ(moved.commit().kept.size(), 1U);
}

}  // namespace
}  // namespace plumb

// Does a world that is spoiled say what does not hold, whatever is spoiled, and one that is not say nothing?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "world/drawn_body.hpp"
#include "world/state.hpp"

namespace plumb {

// What is instantiated by name may name what is private.
auto& kept_state(CollisionWorld& world);
template <auto member>
struct OpenedWorld {
  friend auto& kept_state(CollisionWorld& world) { return *(world.*member); }
};
template struct OpenedWorld<&CollisionWorld::state_>;

namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three in a row that touch, and one apart that is moved after the commit.
struct Row {
  CollisionWorld world{{.contacts = true, .execution = Execution::serial}};
  std::vector<BodyHandle> bodies;

  Row() {
    for (int i = 0; i < 3; ++i) {
      bodies.push_back(world.add(Aabb3{{double(i), 0, 0}, {double(i) + 1, 1, 1}}, {.user_id = unsigned(i) + 10}));
    }
    bodies.push_back(world.add(Sphere3{{9, 9, 9}, 1}, {.user_id = 13}));
    world.commit();
    world.move(bodies[0], {});
    world.commit();
    world.move(bodies[3], RigidPose{{}, {1, 0, 0}});
  }
};

void expect_complaint(const std::string& says,
                      const std::function<void(decltype(kept_state(std::declval<CollisionWorld&>())))>& spoil) {
  Row row;
  ASSERT_THAT(row.world.check(), IsEmpty());
  spoil(kept_state(row.world));
  EXPECT_THAT(row.world.check(), Contains(HasSubstr(says)));
}

TEST(WorldCheck, WhatIsSpoiledIsTold) {
  expect_complaint("listed and not marked", [](auto& s) { s.is_changed[3] = 0; });
  expect_complaint("listed twice as changed", [](auto& s) { s.changed.push_back(3); });
  expect_complaint("names no box of its own", [](auto& s) { ++s.bodies[1]->handle.generation; });
  expect_complaint("bodies are 3, boxes 4", [](auto& s) { s.bodies[1].reset(); });
  expect_complaint("a collision is allowed", [](auto& s) { s.allowed.insert(HandlePair{{7, 1}, {8, 1}}); });
  expect_complaint("stands elsewhere than its pose says", [](auto& s) {
    s.bodies[1]->pose = RigidPose{{}, {0x1p-50, 0, 0}};
  });
  expect_complaint("of which 0 stand somewhere", [](auto& s) { s.bodies[1]->placed.clear(); });
  // By the least that doubles tell.
  expect_complaint("body 11 is not within its box", [](auto& s) {
    s.boxes.move(s.bodies[1]->handle, {{1, 0, 0}, {2, 1, std::nextafter(1, 0)}});
  });
  expect_complaint("bodies 11 and 12 have boxes that overlap, and are not near", [](auto& s) { s.near.pop_back(); });
  expect_complaint("bodies 10 and 12 are near, and their boxes are apart", [](auto& s) {
    const WorldPair p{10, 12, s.bodies[0]->handle, s.bodies[2]->handle, Relation::disjoint};
    s.near.insert(s.near.begin() + 1, {p, true});
  });
  expect_complaint("pairs whose boxes overlap are not in order", [](auto& s) { std::swap(s.near[0], s.near[1]); });
  expect_complaint("pairs are not in order", [](auto& s) { s.pairs.push_back(s.pairs[0]); });
  expect_complaint("what has begun and is kept is not what meets", [](auto& s) { s.events.kept.pop_back(); });
  expect_complaint("a pair has begun and is kept", [](auto& s) { s.events.begun.push_back(s.events.kept[0]); });
  expect_complaint("have ended to meet, and meet", [](auto& s) { s.events.ended.push_back(s.events.kept[0]); });
  expect_complaint("bodies 10 and 11 meet and are not told", [](auto& s) { s.pairs.erase(s.pairs.begin()); });
  expect_complaint("bodies 10 and 11 are told and do not meet",
                   [](auto& s) { s.near[0].pair.relation = Relation::disjoint; });
  expect_complaint("otherwise than what is kept of them",
                   [](auto& s) { s.near[0].pair.relation = Relation::overlapping; });
  expect_complaint("told as a pair and apart", [](auto& s) { s.pairs[0].relation = Relation::disjoint; });
  expect_complaint("contacts are not in order", [](auto& s) { s.contacts.push_back(s.contacts[0]); });
  expect_complaint("contacts of bodies 11 and 12 are others", [](auto& s) { s.contacts.pop_back(); });
  expect_complaint("contacts of bodies 10 and 11 are others", [](auto& s) { s.contacts[0].manifold.distance = 1; });
  const auto corner_of = [](const WorldContact& c, bool is_real) {
    ContactId id = c.manifold.corners[0].id;
    return WorldCorner{c.id_a, c.id_b, c.a, c.b, c.part_a, {c.part_b.part, is_real ? 0U : 5U}, id};
  };
  expect_complaint("and is none of their contacts",
                   [&](auto& s) { s.contact_events.begun.push_back(corner_of(s.contacts[0], false)); });
  expect_complaint("has ended, and is there",
                   [&](auto& s) { s.contact_events.ended.push_back(corner_of(s.contacts[0], true)); });
}

TEST(WorldCheck, WhatIsNotSpoiledIsNotTold) {
  std::size_t pairs = 0, contacts = 0;
  for (std::uint64_t run = 0; run < 15; ++run) {
    SCOPED_TRACE("replay: Entropy(4700, " + std::to_string(run) + ")");
    Entropy e(4700, run);
    CollisionWorld world({.contacts = true, .execution = Execution::serial});
    EXPECT_THAT(world.check(), IsEmpty());
    std::vector<BodyHandle> bodies;
    for (int step = 0; step < 40; ++step) {
      if (bodies.size() < 12 || e.below(4) == 0) {
        const BodyOptions options{.group = 1U << e.below(2),
                                  .mask = e.below(4) == 0 ? 1U : every_group,
                                  .user_id = e.below(30),
                                  .margin = double(e.below(3)) / 4,
                                  .is_static = e.below(5) == 0};
        bodies.push_back(world.add(drawn_world::body(e).body, options));
      } else if (const std::size_t which = e.below(bodies.size()); e.below(3) == 0) {
        world.remove(bodies[which]);
        bodies.erase(bodies.begin() + std::ptrdiff_t(which));
      } else {
        world.move(bodies[which], drawn_world::pose(e));
      }
      if (e.below(3) == 0) world.commit();
      ASSERT_THAT(world.check(e.coin() ? 256 : e.below(6)), IsEmpty());
    }
    pairs += world.pairs().size(), contacts += world.contacts().size();
  }
  std::printf("%zu pairs, %zu contacts\n", pairs, contacts);
  EXPECT_GT(pairs, 60U);
  EXPECT_GT(contacts, 100U);
}

// A commit that throws half way leaves nothing that does not hold.
TEST(WorldCheck, HoldsAfterWhatThrows) {
  Row row;
  row.world.move(row.bodies[0], RigidPose{{}, {1, 0, 0}});
  row.world.remove(row.bodies[2]);
  row.world.set_filter([](const BodyHandle&, const BodyHandle&) -> bool { throw Unsupported("not today"); });
  EXPECT_THROW(row.world.commit(), Unsupported);
  EXPECT_THAT(row.world.check(), IsEmpty());
  row.world.clear_filter();
  row.world.commit();
  EXPECT_THAT(row.world.check(), IsEmpty());
}

}  // namespace
}  // namespace plumb

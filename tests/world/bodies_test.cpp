// Worlds of figures, meshes and compounds: are pairs, contacts and corners those of asking each two figures, frame by
// frame, on one thread and on two, in whatever order they came?
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb {
namespace {

using drawn_world::Drawn;
using Ids = std::pair<std::uint64_t, std::uint64_t>;

struct Member {
  Drawn drawn;
  BodyOptions options;
  BodyHandle handle;
};
using Members = std::map<std::uint64_t, Member>;

template <class Work>
void for_pairs(const Members& all, const Work& work) {
  for (auto a = all.begin(); a != all.end(); ++a) {
    for (auto b = std::next(a); b != all.end(); ++b) {
      if (!(a->second.options.is_static && b->second.options.is_static)) work(a->second, b->second);
    }
  }
}
template <class Work>
void for_figures(const Member& a, const Member& b, const Work& work) {
  for (std::uint32_t i = 0; i < a.drawn.figures.size(); ++i) {
    for (std::uint32_t k = 0; k < a.drawn.figures[i].size(); ++k) {
      for (std::uint32_t j = 0; j < b.drawn.figures.size(); ++j) {
        for (std::uint32_t l = 0; l < b.drawn.figures[j].size(); ++l) {
          work(BodyPart{i, k}, a.drawn.figures[i][k], BodyPart{j, l}, b.drawn.figures[j][l]);
        }
      }
    }
  }
}

std::map<Ids, Relation> meetings(const Members& all) {
  std::map<Ids, Relation> found;
  for_pairs(all, [&](const Member& a, const Member& b) {
    Relation most = Relation::disjoint;
    for_figures(a, b, [&](const BodyPart&, const AnyFigure& p, const BodyPart&, const AnyFigure& q) {
      most = std::max(most, relate(p, q));
    });
    if (most != Relation::disjoint) found[{a.options.user_id, b.options.user_id}] = most;
  });
  return found;
}

using Place = std::tuple<std::uint64_t, std::uint64_t, BodyPart, BodyPart>;
std::vector<std::pair<Place, ContactManifold>> manifolds(const Members& all) {
  std::vector<std::pair<Place, ContactManifold>> found;
  for_pairs(all, [&](const Member& a, const Member& b) {
    std::vector<std::pair<Place, ContactManifold>> of_pair;
    for_figures(a, b, [&](const BodyPart& i, const AnyFigure& p, const BodyPart& j, const AnyFigure& q) {
      if (const auto m = contact(p, q, {.margin = a.options.margin + b.options.margin})) {
        of_pair.push_back({{a.options.user_id, b.options.user_id, i, j}, *m});
      }
    });
    std::sort(of_pair.begin(), of_pair.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    found.insert(found.end(), of_pair.begin(), of_pair.end());
  });
  return found;
}

using CornerName = std::tuple<Place, ContactId>;
std::set<CornerName> corners_of(const std::vector<std::pair<Place, ContactManifold>>& all) {
  std::set<CornerName> names;
  for (const auto& [place, m] : all) {
    for (const ContactCorner& c : m.corners) names.insert({place, c.id});
  }
  return names;
}
std::set<CornerName> as_names(const std::vector<WorldCorner>& corners) {
  std::set<CornerName> names;
  for (const WorldCorner& c : corners) {
    EXPECT_TRUE(names.insert({{c.id_a, c.id_b, c.part_a, c.part_b}, c.id}).second);
  }
  return names;
}
std::set<CornerName> less(const std::set<CornerName>& a, const std::set<CornerName>& b) {
  std::set<CornerName> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(rest, rest.end()));
  return rest;
}

void expect_answers(const CollisionWorld& world, const Members& all, const std::set<CornerName>& corners_before) {
  std::map<Ids, Relation> told;
  for (const WorldPair& p : world.pairs()) {
    told[{p.id_a, p.id_b}] = p.relation;
  }
  EXPECT_EQ(told, meetings(all));
  const auto expected = manifolds(all);
  ASSERT_EQ(world.contacts().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const WorldContact& c = world.contacts()[i];
    EXPECT_EQ((Place{c.id_a, c.id_b, c.part_a, c.part_b}), expected[i].first);
    EXPECT_EQ(c.manifold, expected[i].second);
  }
  const std::set<CornerName> now = corners_of(expected);
  EXPECT_EQ(as_names(world.contact_events().begun), less(now, corners_before));
  EXPECT_EQ(as_names(world.contact_events().ended), less(corners_before, now));
}

BodyOptions drawn_options(Entropy& e, std::uint64_t id) {
  return {.user_id = id, .margin = e.below(3) == 0 ? 0.25 : 0.0, .is_static = e.below(4) == 0};
}

TEST(WorldBodies, ReplayAsAskingEachTwoFigures) {
  std::size_t pairs = 0, contacts = 0, begun = 0, ended = 0, of_triangles = 0;
  for (std::uint64_t run = 0; run < 12; ++run) {
    Entropy e(4500, run);
    const Execution execution = run % 2 == 0 ? Execution::serial : Execution::parallel;
    CollisionWorld world({.contacts = true, .execution = execution});
    Members all;
    std::set<CornerName> before;
    std::uint64_t next_id = 1;
    for (int frame = 0; frame < 10; ++frame) {
      SCOPED_TRACE("replay: Entropy(4500, " + std::to_string(run) + "), frame " + std::to_string(frame));
      for (std::uint64_t changes = frame == 0 ? 18 : e.below(5); changes > 0; --changes) {
        const std::uint64_t what = e.below(6);
        if (frame == 0 || all.empty() || what == 0) {
          Member m{drawn_world::body(e), drawn_options(e, next_id), {}};
          m.handle = world.add(m.drawn.body, m.options);
          all.insert({next_id++, m});
          continue;
        }
        Member& m = std::next(all.begin(), std::ptrdiff_t(e.below(all.size())))->second;
        if (what == 1) {
          world.remove(m.handle);
          all.erase(m.options.user_id);
        } else if (what == 2) {
          m.drawn = drawn_world::body(e);
          world.replace(m.handle, m.drawn.body);
        } else {
          const RigidPose pose = drawn_world::pose(e);
          m.drawn = m.drawn.under(pose);
          world.move(m.handle, pose);
        }
      }
      world.commit();
      expect_answers(world, all, before);
      EXPECT_EQ(world.check(), std::vector<std::string>());
      if (::testing::Test::HasFailure()) return;
      pairs += world.pairs().size(), contacts += world.contacts().size();
      begun += world.contact_events().begun.size(), ended += world.contact_events().ended.size();
      for (const WorldContact& c : world.contacts()) of_triangles += c.part_a.triangle + c.part_b.triangle > 0 ? 1 : 0;
      before = corners_of(manifolds(all));
      EXPECT_TRUE(world.commit().begun.empty());
      EXPECT_TRUE(world.contact_events().begun.empty());
      EXPECT_TRUE(world.contact_events().ended.empty());
      EXPECT_EQ(corners_of(manifolds(all)), before);
    }
  }
  std::printf("%zu pairs, %zu contacts, %zu of triangles beyond the first; corners: %zu begun, %zu ended\n", pairs,
              contacts, of_triangles, begun, ended);
  for (const std::size_t n : {pairs, contacts, of_triangles, begun, ended}) EXPECT_GT(n, 200U);
}

// More pairs than one block has, so that two threads have some each.
TEST(WorldBodies, ThreadsAndOrderOfInsertionChangeNothing) {
  Entropy e(4510);
  std::vector<Member> members;
  for (std::uint64_t id = 1; id <= 60; ++id) members.push_back({drawn_world::body(e), drawn_options(e, id), {}});
  const auto answers = [&](Execution execution) {
    CollisionWorld world({.contacts = true, .execution = execution});
    for (const Member& m : members) world.add(m.drawn.body, m.options);
    world.commit();
    std::vector<std::tuple<std::uint64_t, std::uint64_t, Relation>> pairs;
    for (const WorldPair& p : world.pairs()) pairs.push_back({p.id_a, p.id_b, p.relation});
    std::vector<std::pair<Place, ContactManifold>> contacts;
    for (const WorldContact& c : world.contacts()) {
      contacts.push_back({{c.id_a, c.id_b, c.part_a, c.part_b}, c.manifold});
    }
    return std::pair(pairs, contacts);
  };
  const auto first = answers(Execution::serial);
  EXPECT_GT(first.first.size(), 200U);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(answers(Execution::parallel), first);
    for (std::size_t i = members.size() - 1; i > 0; --i) std::swap(members[i], members[e.below(i + 1)]);
    EXPECT_EQ(answers(Execution::serial), first);
  }
}

TEST(WorldBodies, WhatContactHasNoAnswerForHasAPairAlone) {
  CollisionWorld world({.contacts = true});
  world.add(Cone3{{0, 0, 1}, {0, 0, 0}, 1}, {.user_id = 1});
  world.add(Aabb3{{-1, -1, -1}, {1, 1, 0}}, {.user_id = 2});
  const Polygon3 dart{{{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}}};  // not convex
  world.add(dart, {.user_id = 3});
  world.commit();
  EXPECT_EQ(world.pairs().size(), 3U);
  EXPECT_TRUE(world.contacts().empty());
}

TEST(WorldBodies, BadInputIsRefusedByName) {
  CollisionWorld world;
  const auto refused = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const Error& e) {
      return e.what();
    }
    return "nothing thrown";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SharedMesh mesh(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const BodyHandle rock = world.add(mesh, {.user_id = 5});
  EXPECT_THROW(SharedMesh(TriangleMesh{}), InvalidShape);
  EXPECT_THROW(static_cast<void>(AnyBody::compound({})), InvalidShape);
  EXPECT_THROW(AnyBody(mesh, Pose{}), UnevenPose);
  EXPECT_THROW(static_cast<void>(AnyBody::compound({AnyBody(mesh).under(Pose{})})), UnevenPose);
  EXPECT_THROW(static_cast<void>(world.figure(rock)), Unsupported);
  EXPECT_THROW(static_cast<void>(world.contacts()), Unsupported);
  EXPECT_THROW(static_cast<void>(world.contact_events()), Unsupported);
  EXPECT_EQ(world.body(rock).parts().size(), 1U);
  EXPECT_NE(refused([&] { world.move(rock, RigidPose{{}, {nan, 0, 0}}); }).find("body 5"), std::string::npos);
  EXPECT_NE(refused([&] { world.move(rock, RigidPose{{0, 0, 0, 0}, {}}); }).find("body 5"), std::string::npos);
  EXPECT_NE(refused([&] { world.add(mesh, {.user_id = 6, .margin = -1}); }).find("body 6: margin"), std::string::npos);
  EXPECT_NE(refused([&] { world.add(mesh, {.user_id = 7, .margin = nan}); }).find("body 7: margin"), std::string::npos);
  EXPECT_EQ(world.size(), 1U);
  EXPECT_TRUE(world.commit().begun.empty());
}

}  // namespace
}  // namespace plumb

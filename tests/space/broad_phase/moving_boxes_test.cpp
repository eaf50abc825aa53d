// Do boxes that come, go and move overlap as asking each pair says, frame after frame, and is every change told once?
#include "plumb/space/broad_phase/moving_boxes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "certify/batch/all_threads.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/pairs/brute_force_pairs.hpp"
#include "space/broad_phase/column_order.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using box_scenes::part;
using box_scenes::Scene;
using ::testing::HasSubstr;

/// What ought to be there, and what is.
struct Replay {
  explicit Replay(const MovingBoxesOptions& o) : options(o), world(o) {}

  MovingBoxesOptions options;
  MovingBoxes world;
  std::vector<BoxHandle> handles;
  std::vector<Aabb3> boxes;
  std::set<HandlePair> pairs;
  std::size_t anew = 0, kept = 0, scratch = 0, added = 0, lost = 0;
  MovingWork work;

  void insert(const Aabb3& box) {
    handles.push_back(world.insert(box));
    boxes.push_back(box);
  }
  void remove(std::size_t i) {
    world.remove(handles[i]);
    handles.erase(handles.begin() + static_cast<std::ptrdiff_t>(i));
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void expect(const std::string& about) {
    const BoxPairChanges& changes = world.changes();
    std::set<HandlePair> now;
    for (const BoxPair& p : boxes.size() < 400
                                ? brute_force_pairs(boxes, {.touching = options.touching})
                                : overlapping_pairs(boxes, BroadPhaseOptions{.touching = options.touching})) {
      const BoxHandle &a = handles[p.a], &b = handles[p.b];
      now.insert(a < b ? HandlePair{a, b} : HandlePair{b, a});
    }
    std::vector<HandlePair> new_ones, gone;
    std::set_difference(now.begin(), now.end(), pairs.begin(), pairs.end(), std::back_inserter(new_ones));
    std::set_difference(pairs.begin(), pairs.end(), now.begin(), now.end(), std::back_inserter(gone));
    ASSERT_EQ(changes.added, new_ones) << about;
    ASSERT_EQ(changes.lost, gone) << about;
    ASSERT_EQ(world.overlapping_pairs(), std::vector<HandlePair>(now.begin(), now.end())) << about;
    ASSERT_EQ(world.size(), boxes.size());
    added += new_ones.size(), lost += gone.size();
    work = changes.work;
    if (work.moved != 0) ++(work.made_anew ? anew : work.from_scratch ? scratch : kept);
    pairs = std::move(now);
  }
};

Aabb3 moved(const Aabb3& b, double x, double y, double z) {
  return {{b.min.x + x, b.min.y + y, b.min.z + z}, {b.max.x + x, b.max.y + y, b.max.z + z}};
}

// Of every scene; some boxes tremble, some jump, some change size, some come and some go.
TEST(MovingBoxes, AreReplayedAgainstFromScratch) {
  std::size_t anew = 0, kept = 0, scratch = 0, added = 0, lost = 0;
  for (int s = 0; s <= static_cast<int>(box_scenes::last_scene); ++s) {
    Entropy e(2051, static_cast<std::uint64_t>(s));
    const std::size_t n = 30 + e.below(60);
    const auto material = box_scenes::boxes_of(static_cast<Scene>(s), e, 4 * n);
    const double margins[] = {0.1, 0, 1, 5};
    Replay replay({.touching = s % 2 == 0, .margin = margins[e.below(4)]});
    for (std::size_t i = 0; i < n; ++i) replay.insert(material[i]);
    for (std::size_t frame = 0; frame < battery::fitting(250u); ++frame) {
      const std::uint64_t busy = frame % 16 == 0 ? 2 : 16;
      std::vector<BoxHandle> handles;
      std::vector<Aabb3> boxes;
      for (std::size_t i = 0; i < replay.boxes.size(); ++i) {
        Aabb3& box = replay.boxes[i];
        const std::uint64_t way = e.below(busy * 4);
        const double step = std::abs(box.max.x) > 1e6 ? 0 : part(e) - 0.5;
        if (way == 0) box = material[e.below(material.size())];
        if (way == 1 || way == 2) box = moved(box, 0.1 * step, -0.1 * step, 0);
        if (way == 3) box = moved(box, e.coin() ? 1 : -1, 0, 0);
        if (way > 3) continue;
        handles.push_back(replay.handles[i]);
        boxes.push_back(box);
      }
      replay.world.move(handles, boxes);
      while (!replay.boxes.empty() && e.below(8) == 0) replay.remove(e.below(replay.boxes.size()));
      while (replay.boxes.size() < 2 * n && e.below(8) == 0) replay.insert(material[e.below(material.size())]);
      replay.expect("scene " + std::to_string(s) + ", frame " + std::to_string(frame));
      if (HasFatalFailure()) return;
    }
    anew += replay.anew, kept += replay.kept, scratch += replay.scratch, added += replay.added, lost += replay.lost;
  }
  if (battery::reaches_rare) {
    EXPECT_GT(anew, 20u);
    EXPECT_GT(scratch, 500u);
    EXPECT_GT(kept, 500u);
    EXPECT_GT(added, 2000u);
    EXPECT_GT(lost, 2000u);
  }
}

// All jump in every frame, then 1 % move a little or jump, then all jump: what is done can be seen.
TEST(MovingBoxes, AreSettledOneByOneWhereThatIsCheaper) {
  Entropy e(2052);
  Replay replay({});
  for (const Aabb3& box : box_scenes::boxes_of(Scene::uniform, e, battery::fitting(2000u))) replay.insert(box);
  replay.expect("at first");
  EXPECT_EQ(replay.anew, 1u);
  const auto shift = [&](std::size_t every, double by) {
    std::vector<BoxHandle> handles;
    std::vector<Aabb3> boxes;
    for (std::size_t i = 0; i < replay.boxes.size(); i += every) {
      replay.boxes[i] = moved(replay.boxes[i], by * (part(e) - 0.5), by * (part(e) - 0.5), by * (part(e) - 0.5));
      handles.push_back(replay.handles[i]);
      boxes.push_back(replay.boxes[i]);
    }
    replay.world.move(handles, boxes);
    replay.expect("shifted");
  };
  for (int frame = 0; frame < 20; ++frame) shift(1, 20);
  EXPECT_EQ(replay.anew + replay.scratch, 21u);
  for (int frame = 0; frame < 40; ++frame) shift(100, frame % 2 == 0 ? 0.01 : 1);
  EXPECT_GT(replay.kept, 36u);
  const std::size_t kept = replay.kept;
  shift(1, 20);
  EXPECT_EQ(replay.kept, kept);
  replay.expect("nothing moved");
  EXPECT_EQ(replay.anew + replay.kept + replay.scratch, 62u);
}

// So many that they are swept in columns, which stay from frame to frame: all tremble and some jump, come, go, or are
// told of twice, and between these frames few do; then all lie in one plane, move out of it, go far away together, and
// some gather in one place.
TEST(MovingBoxes, AreSweptInColumnsThatStay) {
  for (const bool touching : {true, false}) {
    Entropy e(2058, touching ? 1 : 0);
    Replay replay({.touching = touching});
    const std::size_t n = battery::sanitized ? 1200 : 1500;
    const auto place = [&] { return std::floor(part(e) * 96) / 8; };  // on a lattice: many touch
    const auto some_box = [&]() -> Aabb3 {
      const Point3 p{place(), place(), place()};
      return {p, {p.x + 0.125 * double(e.below(9)), p.y + 0.125 * double(1 + e.below(8)), p.z + 1}};
    };
    const auto step = [&] { return 0.125 * (static_cast<double>(e.below(3)) - 1); };
    const auto trembling = [&](const Aabb3& box, bool in_plane) {
      const double x = step(), y = step();  // compilers draw the arguments of a function in another order
      return moved(box, x, y, in_plane ? 0 : step());
    };
    const auto expect = [&](const std::string& about, int times) {
      for (int i = 0; i < times; ++i) {
        replay.remove(e.below(replay.boxes.size()));
        if (i % 2 == 0) replay.insert(some_box());
      }
      replay.insert(replay.boxes[0]);
      replay.expect(about);
    };
    for (std::size_t i = 0; i < n; ++i) replay.insert(some_box());
    replay.expect("at first");
    for (int frame = 0; frame < 12; ++frame) {
      for (int times = 0; times < (frame % 3 == 2 ? 2 : 1); ++times) {
        for (Aabb3& box : replay.boxes) {
          if (frame == 8) box = {{box.min.x, box.min.y, 1}, {box.max.x, box.max.y, 1}};
          if (frame == 10) box = moved(box, 0, 0, e.coin() ? 0.5 : 0);
          if (frame == 11) box = moved(box, 4000, 0, 0);
          if (frame < 8) box = trembling(box, false);
          if (frame < 8 && e.below(16) == 0) box = some_box();
        }
        replay.world.move(replay.handles, replay.boxes);
      }
      expect("frame " + std::to_string(frame), 9);
      for (int few = 0; few < 3; ++few) {
        for (int times = 0; times < 20; ++times) {
          const std::size_t i = e.below(replay.boxes.size());
          Aabb3& box = replay.boxes[i];
          box = e.coin() ? trembling(box, frame > 7) : replay.boxes[e.below(n / 2)];
          replay.world.move(replay.handles[i], box);
        }
        expect("a few in frame " + std::to_string(frame), 3);
      }
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(replay.scratch, 4u);
    EXPECT_GT(replay.kept, 30u);
    EXPECT_GT(replay.added, n);
    EXPECT_GT(replay.lost, n);
    // One by one is thought to be cheaper, and is not.
    const std::size_t kept = replay.kept;
    for (std::size_t i = 0; i < replay.boxes.size(); i += 10) {
      replay.boxes[i] = replay.boxes[0];
      replay.world.move(replay.handles[i], replay.boxes[i]);
    }
    replay.expect("gathered");
    EXPECT_EQ(replay.kept, kept);
    const MovingWork& work = replay.work;
    if (battery::sanitized) continue;  // of fewer boxes
    EXPECT_TRUE(work.from_scratch && !work.made_anew && work.cost_to_keep < work.cost_from_scratch)
        << work.from_scratch << ' ' << work.made_anew << ' ' << work.cost_to_keep << ' ' << work.cost_from_scratch;
  }
}

// Keys that move are found again by whole keys: those of a long column, of which many begin alike, are in their order too.
TEST(MovingBoxes, StandInColumnsInTheOrderOfWholeKeys) {
  Entropy e(2057);
  space::ColumnOrder order;
  for (const std::size_t n : {20u, 3000u, 20'000u}) {
    std::vector<std::uint64_t> keys(n);
    for (std::uint64_t& key : keys) key = e.below(50) << 40 | e.below(std::uint64_t{1} << 30);
    order.sort_nearly_sorted(keys);
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end())) << n;
  }
}

// Along a line where most stand in one column, those that jump make room for each other until all are swept instead.
TEST(MovingBoxes, AreSweptWhereALongColumnMakesRoomTooOften) {
  if (battery::sanitized) GTEST_SKIP() << "of many boxes";
  Entropy e(2058);
  Replay replay({});
  for (int i = 0; i < 60'000; ++i) replay.insert({{i + part(e), 0, 0}, {i + 1.0, 1, 1}});
  replay.expect("at first");
  for (const std::size_t every : {10u, 200u}) {
    std::vector<BoxHandle> handles;
    std::vector<Aabb3> boxes;
    for (std::size_t i = 0; i < replay.boxes.size(); i += every) {
      const auto at = static_cast<double>(e.below(60'000));
      replay.boxes[i] = {{at, 0, 0}, {at + 1, 1, 1}};
      handles.push_back(replay.handles[i]), boxes.push_back(replay.boxes[i]);
    }
    replay.world.move(handles, boxes);
    replay.expect("jumped");
    EXPECT_EQ(replay.work.from_scratch, every == 10) << every;
  }
}

// Where all boxes were at one number of an axis, or there was none, others may be infinitely many steps off.
TEST(MovingBoxes, MayGoFromOneEndOfTheNumbersToTheOther) {
  constexpr double far = 1e308, farthest = std::numeric_limits<double>::max();
  Replay flat({});
  for (int i = 0; i < 20; ++i) flat.insert({{far, 0, i + 0.0}, {far, 1, i + 0.5}});
  flat.expect("at one end");
  for (Aabb3& box : flat.boxes) box.min.x = box.max.x = -far;
  flat.world.move(flat.handles, flat.boxes);
  flat.expect("at the other");

  Replay empty({});
  empty.insert({{0, 0, 0}, {1, 1, 1}});
  empty.remove(0);
  empty.expect("none");
  for (int i = 0; i < 10; ++i) empty.insert({{-farthest, -farthest, -farthest}, {0, 0, 0}});
  empty.expect("as large as the numbers");
}

TEST(MovingBoxes, RefuseWhatIsNotThereAndStayAsTheyWere) {
  constexpr Aabb3 unit{{0, 0, 0}, {1, 1, 1}}, far{{9, 9, 9}, {10, 10, 10}};
  MovingBoxes world;
  const BoxHandle a = world.insert(unit), b = world.insert(unit);
  EXPECT_EQ(world.changes().added, (std::vector<HandlePair>{{a, b}}));
  world.remove(b);
  EXPECT_THAT(text_of<InvalidShape>([&] { world.remove(b); }),
              HasSubstr("MovingBoxes::remove: handle (slot 1, generation 0) was removed"));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.move(b, far); }), HasSubstr("handles[0] (slot 1, generation 0) was"));
  EXPECT_EQ(world.changes().lost, (std::vector<HandlePair>{{a, b}}));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.remove(b); }), HasSubstr("was removed"));
  const BoxHandle c = world.insert(unit);
  EXPECT_EQ(c, (BoxHandle{1, 1}));
  EXPECT_FALSE(world.contains(b));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.remove(b); }), HasSubstr("generation 0) was removed"));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.remove({7, 0}); }), HasSubstr("names no box that was inserted"));
  EXPECT_EQ(world.changes().added, (std::vector<HandlePair>{{a, c}}));

  const Aabb3 empty{{0, 0, 0}, {1, -1, 1}}, infinite{{0, 0, 0}, {1, 1, std::numeric_limits<double>::infinity()}};
  EXPECT_THAT(text_of<InvalidShape>([&] { world.insert(empty); }), HasSubstr("MovingBoxes::insert: box is empty"));
  EXPECT_THAT(text_of<NonFinite>([&] { world.insert(infinite); }), HasSubstr("MovingBoxes::insert: box.max.z"));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.move(a, empty); }), HasSubstr("boxes[0] is empty"));
  const BoxHandle twice[]{a, c, a}, stale[]{a, b};
  const Aabb3 far_ones[]{far, far, far};
  EXPECT_THAT(text_of<InvalidShape>([&] { world.move(twice, far_ones); }),
              HasSubstr("handles[2] (slot 0, generation 0) is there twice"));
  EXPECT_THAT(text_of<InvalidShape>([&] { world.move(stale, std::span<const Aabb3>(far_ones).first(2)); }),
              HasSubstr("handles[1] (slot 1, generation 0) was removed"));
  EXPECT_THAT(text_of<UnequalLengths>([&] { world.move(stale, far_ones); }), HasSubstr("2 items, but boxes has 3"));
  EXPECT_EQ(world.box(a), unit);
  EXPECT_TRUE(world.changes().added.empty() && world.changes().lost.empty());
  EXPECT_EQ(world.overlapping_pairs(), (std::vector<HandlePair>{{a, c}}));
  world.move(std::span<const BoxHandle>(twice).first(2), std::span<const Aabb3>(far_ones).first(2));
  EXPECT_TRUE(world.changes().lost.empty());
  EXPECT_THAT(text_of<InvalidShape>([] { MovingBoxes({.margin = -1}); }), HasSubstr("options.margin is -1"));
}

TEST(MovingBoxes, AreAskedByRegionsAndRaysAsTheyAreNow) {
  constexpr Aabb3 unit{{0, 0, 0}, {1, 1, 1}}, next{{1, 0, 0}, {2, 1, 1}};
  const Ray3 along{{-1, 0.5, 1}, {1, 0, 0}};
  MovingBoxes world;
  EXPECT_TRUE(world.in_box(unit).empty());
  EXPECT_FALSE(world.first_hit(along));
  const BoxHandle a = world.insert(next), b = world.insert(unit), c = world.insert(unit);
  EXPECT_EQ(world.in_box(unit), (std::vector<BoxHandle>{a, b, c}));
  EXPECT_EQ(world.in_box(unit, {.touching = false}), (std::vector<BoxHandle>{b, c}));
  EXPECT_EQ(world.first_hit(along)->box, b);
  EXPECT_EQ(world.first_hit(along)->hit, *first_hit(along, unit));
  world.remove(b);
  EXPECT_EQ(world.first_hit(along)->box, c);
  world.move(c, next);
  EXPECT_EQ(world.first_hit(along)->box, a);
  EXPECT_FALSE(world.first_hit(Segment3{{-1, 0.5, 1}, {std::nextafter(1, 0), 0.5, 1}}));
  EXPECT_TRUE(world.in_box({{1, 0, 0}, {0, 1, 1}}).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)world.in_box({{0, 0, 0}, {1, nan, 1}});
              }),
              HasSubstr("MovingBoxes::in_box: box.max.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)MovingBoxes().first_hit(Ray3{{nan, 0, 0}, {1, 0, 0}});
              }),
              HasSubstr("MovingBoxes::first_hit: ray.origin.x is nan"));
}

// Threads that ask together, one of which makes the tree.
TEST(MovingBoxes, AnswerManyThreadsAlike) {
  Entropy e(2053);
  MovingBoxes world;
  const auto boxes = box_scenes::boxes_of(Scene::uniform, e, 300);
  const std::vector<BoxHandle> handles = world.insert(boxes);
  std::vector<std::vector<BoxHandle>> found(400);
  std::vector<std::optional<HandleHit>> hits(found.size());
  const auto region = [&](std::size_t i) { return moved(boxes[i % boxes.size()], 0.5, 0, -0.5); };
  certify::batch::for_each_part(Execution::parallel, found.size(), [&](std::size_t i) {
    found[i] = world.in_box(region(i));
    hits[i] = world.first_hit(Segment3{boxes[i % 300].min, boxes[i * 7 % 300].max});
  });
  std::size_t hit = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i], found[i % 300]) << i;
    std::vector<BoxHandle> expected;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (relate(boxes[k], region(i)) != Relation::disjoint) expected.push_back(handles[k]);
    }
    ASSERT_EQ(found[i], expected) << i;
    ASSERT_EQ(hits[i], world.first_hit(Segment3{boxes[i % 300].min, boxes[i * 7 % 300].max})) << i;
    hit += hits[i] ? 1 : 0;
  }
  EXPECT_GT(hit, 100u);
}

}  // namespace
}  // namespace plumb

// Are all structures that boxes come to, move in and go from of one mind with asking each pair, frame after frame?  One
// table of the structures, and the same scenes of thousands of frames for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "certify/sanitized.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/broad_phase/moving_boxes.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/bvh/insertion_tree.hpp"
#include "plumb/space/bvh/refit.hpp"
#include "plumb/space/sort_and_sweep/sweep_array.hpp"
#include "plumb/space/textbook/box_store.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using box_scenes::part;
using Id = std::uint32_t;
using Ids = std::vector<Id>;
using Pairs = std::vector<BoxPair>;
using Boxes = std::vector<std::optional<Aabb3>>;  // of each id

#if defined(PLUMB_LONG_TESTS)
constexpr std::size_t frames_of_scene = 20'000, most_boxes = 200;
#else
const std::size_t frames_of_scene = battery::sanitized ? 30 : 260, most_boxes = 20;
#endif

/// A structure without its type.  Boxes have ids of the scene, whatever the structure names them by.
struct World {
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  virtual ~World() = default;
  virtual void insert(Id id, const Aabb3& box) = 0;
  virtual void move(Id id, const Aabb3& box) = 0;
  virtual void remove(Id id) = 0;
  /// By ids, a < b, ascending.
  virtual Pairs pairs(bool touching) = 0;
  /// Those in the box, where the structure tells; ascending.
  virtual std::optional<Ids> in_box(const Aabb3&, bool) { return {}; }
  virtual void check_hit(const Boxes&, const AnyRay&) {}
};

Pairs ascending(Pairs pairs) {
  for (BoxPair& p : pairs) p = {std::min(p.a, p.b), std::max(p.a, p.b)};
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// What boxes are put into and asked as it is: grids, loose octrees, lists.
template <class Index>
class Numbered : public World {
 public:
  template <class... Arguments>
  explicit Numbered(Arguments&&... arguments) : index_(std::forward<Arguments>(arguments)...) {}

  void insert(Id id, const Aabb3& box) override {
    const BoxHandle handle = index_.insert(box);
    if (handle.slot >= id_of_.size()) id_of_.resize(handle.slot + 1);
    if (id >= handle_of_.size()) handle_of_.resize(id + 1);
    id_of_[handle.slot] = id, handle_of_[id] = handle;
  }
  void move(Id id, const Aabb3& box) override { index_.move(handle_of_[id], box); }
  void remove(Id id) override { index_.remove(handle_of_[id]); }
  Pairs pairs(bool touching) override {
    Pairs pairs;
    for (const HandlePair& p : index_.overlapping_pairs({touching, Execution::serial}))
      pairs.push_back({id_of_[p.a.slot], id_of_[p.b.slot]});
    return ascending(std::move(pairs));
  }
  std::optional<Ids> in_box(const Aabb3& box, bool touching) override {
    const std::vector<BoxHandle> found = index_.in_box(box, {.touching = touching});
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    Ids ids;
    for (const BoxHandle& h : found) ids.push_back(id_of_[h.slot]);
    std::sort(ids.begin(), ids.end());
    return ids;
  }

 private:
  Index index_;
  Ids id_of_;
  std::vector<BoxHandle> handle_of_;
};

/// What is told of changes makes the pairs before those of now, and is told once.
class Moving : public World {
 public:
  Moving(bool touching, double margin) : world_({.touching = touching, .margin = margin}) {}

  void insert(Id id, const Aabb3& box) override { name(id, world_.insert(box)); }
  void move(Id id, const Aabb3& box) override { world_.move(handle_of_[id], box); }
  void remove(Id id) override { world_.remove(handle_of_[id]); }
  Pairs pairs(bool) override {
    const BoxPairChanges& changes = world_.changes();
    std::vector<HandlePair> still, now;
    std::set_difference(before_.begin(), before_.end(), changes.lost.begin(), changes.lost.end(),
                        std::back_inserter(still));
    EXPECT_EQ(still.size() + changes.lost.size(), before_.size()) << "a pair is lost that was none";
    std::set_union(still.begin(), still.end(), changes.added.begin(), changes.added.end(), std::back_inserter(now));
    EXPECT_EQ(now.size(), still.size() + changes.added.size()) << "a pair is added that was one";
    EXPECT_EQ(now, world_.overlapping_pairs());
    before_ = std::move(now);
    Pairs pairs;
    for (const HandlePair& p : before_) pairs.push_back({id_of_[p.a.slot], id_of_[p.b.slot]});
    return ascending(std::move(pairs));
  }
  std::optional<Ids> in_box(const Aabb3& box, bool touching) override {
    const std::vector<BoxHandle> found = world_.in_box(box, {touching});
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    Ids ids;
    for (const BoxHandle& h : found) ids.push_back(id_of_[h.slot]);
    std::sort(ids.begin(), ids.end());
    return ids;
  }
  void check_hit(const Boxes& boxes, const AnyRay& ray) override {
    std::optional<HandleHit> expected;
    std::optional<RayParameter> least;
    for (Id id = 0; id < boxes.size(); ++id) {
      auto t = boxes[id] ? first_hit_parameter(ray, *boxes[id]) : std::nullopt;
      if (!t) continue;
      const bool ties = least && *t == *least;
      ties_ += ties ? 1 : 0;
      if (least && (ties ? expected->box < handle_of_[id] : *least < *t)) continue;
      expected = HandleHit{handle_of_[id], *first_hit(ray, *boxes[id])};
      least = std::move(t);
    }
    ASSERT_EQ(world_.first_hit(ray), expected);
    hits_ += expected ? 1 : 0;
  }

  static inline std::size_t hits_ = 0, ties_ = 0;

 private:
  void name(Id id, const BoxHandle& handle) {
    if (handle.slot >= id_of_.size()) id_of_.resize(handle.slot + 1);
    if (id >= handle_of_.size()) handle_of_.resize(id + 1);
    id_of_[handle.slot] = id, handle_of_[id] = handle;
  }

  MovingBoxes world_;
  std::vector<BoxHandle> handle_of_;
  Ids id_of_;
  std::vector<HandlePair> before_;
};

/// What is handed all boxes in each frame, or knows them by ids.
struct Kept : World {
  Boxes boxes;
  bool is_other = true;  // are there others than when last asked?

  void insert(Id id, const Aabb3& box) override {
    if (id >= boxes.size()) boxes.resize(id + 1);
    boxes[id] = box, is_other = true;
  }
  void move(Id id, const Aabb3& box) override { boxes[id] = box; }
  void remove(Id id) override { boxes[id].reset(), is_other = true; }

  /// Of the leaves of a tree.
  static Pairs pairs_of(const BoxTree& tree, bool touching, const std::function<const Aabb3&(Id)>& box_of) {
    Pairs pairs;
    const auto meet = [](const BoxNode& a, const BoxNode& b) {
      bool apart = false;
      for (std::size_t k = 0; k < 3; ++k) apart |= a.min[k] > b.max[k] || b.min[k] > a.max[k];
      return !apart;
    };
    descend_own_pairs(tree, meet, [&](const BoxNode& a, const BoxNode& b) {
      for (std::uint32_t s = a.link; s < a.link + a.count; ++s) {
        for (std::uint32_t t = &a == &b ? s + 1 : b.link; t < b.link + b.count; ++t) {
          const Relation r = relate(box_of(tree.items[s]), box_of(tree.items[t]));
          if (r == Relation::disjoint || (r == Relation::touching && !touching)) continue;
          pairs.push_back({tree.items[s], tree.items[t]});
        }
      }
    });
    return pairs;
  }
};

struct Swept : Kept {
  SweepArray sweep;

  explicit Swept(bool touching) : sweep({.touching = touching}) {}
  Pairs pairs(bool) override {
    std::vector<Aabb3> there;
    Ids ids;
    for (Id id = 0; id < boxes.size(); ++id) {
      if (boxes[id]) there.push_back(*boxes[id]), ids.push_back(id);
    }
    Pairs pairs = sweep.overlapping_pairs(there);
    for (BoxPair& p : pairs) p = {ids[p.a], ids[p.b]};
    return ascending(std::move(pairs));
  }
};

/// A tree that is fitted anew while the same boxes move.
struct Refitted : Kept {
  BoxTree tree;
  Ids ids;

  Pairs pairs(bool touching) override {
    std::vector<Aabb3> there;
    if (is_other) ids.clear();
    for (Id id = 0; id < boxes.size(); ++id) {
      if (!boxes[id]) continue;
      there.push_back(*boxes[id]);
      if (is_other) ids.push_back(id);
    }
    // The frame of a tree is that of its numbers when it was made.
    if (is_other) {
      tree = build_box_tree(there, {.most_in_leaf = 2, .execution = Execution::serial});
    } else {
      refit(tree, there, Execution::serial);
    }
    is_other = false;
    Pairs pairs = pairs_of(tree, touching, [&](Id i) -> const Aabb3& { return there[i]; });
    for (BoxPair& p : pairs) p = {ids[p.a], ids[p.b]};
    return ascending(std::move(pairs));
  }
};

struct Inserted : Kept {
  InsertionTree tree;

  void insert(Id id, const Aabb3& box) override { Kept::insert(id, box), tree.insert(id, box); }
  void move(Id id, const Aabb3& box) override { Kept::move(id, box), tree.remove(id), tree.insert(id, box); }
  void remove(Id id) override { Kept::remove(id), tree.remove(id); }
  Pairs pairs(bool touching) override {
    return ascending(pairs_of(tree.laid_out(), touching, [&](Id id) -> const Aabb3& { return *boxes[id]; }));
  }
};

struct Structure {
  const char* name;
  bool takes_any_size;  // whose boxes may reach into any number of cells of a size
  std::function<std::unique_ptr<World>(bool touching)> make;
};

constexpr Aabb3 around_zero{{-4, -4, -4}, {4, 4, 4}};

const std::vector<Structure>& structures() {
  using std::make_unique;
  using StoreOptions = BoxStoreOptions<Aabb3>;
  const auto lists = [](int axes, SweepAxis first) {
    return [=](bool) { return make_unique<Numbered<SweepLists>>(StoreOptions{.lists = axes, .first_axis = first}); };
  };
  const auto moving = [](double margin) {
    return [=](bool touching) { return make_unique<Moving>(touching, margin); };
  };
  static const std::vector<Structure> all{
      {"HashedGrid, cells of 1", false,
       [](bool) { return make_unique<Numbered<HashedGrid3>>(StoreOptions{.cell_size = 1}); }},
      {"HashedGrid, cells of 5", false,
       [](bool) { return make_unique<Numbered<HashedGrid3>>(StoreOptions{.cell_size = 5}); }},
      {"LinkedGrid", true,
       [](bool) {
         return make_unique<Numbered<LinkedGrid3>>(StoreOptions{around_zero, 1.5});
       }},
      {"ImplicitGrid", true,
       [](bool) { return make_unique<Numbered<ImplicitGrid3>>(StoreOptions{.cell_size = 0.75, .rows = 16}); }},
      {"HierarchicalGrid", true, [](bool) { return make_unique<Numbered<HierarchicalGrid3>>(); }},
      {"RowColumnGrid", true, [](bool) { return make_unique<Numbered<RowColumnGrid3>>(StoreOptions{.rows = 16}); }},
      {"LooseOctree", true,
       [](bool) { return make_unique<Numbered<LooseOctree>>(StoreOptions{.world = around_zero}); }},
      {"SweepLists, x", true, lists(1, SweepAxis::x)},
      {"SweepLists, y and z", true, lists(2, SweepAxis::y)},
      {"SweepLists", true, lists(3, SweepAxis::x)},
      {"SweepArray", true, [](bool touching) { return make_unique<Swept>(touching); }},
      {"MovingBoxes", true, moving(0.1)},
      {"MovingBoxes, margin 0", true, moving(0)},
      {"MovingBoxes, margin 2", true, moving(2)},
      {"BoxTree, refitted", true, [](bool) { return make_unique<Refitted>(); }},
      {"InsertionTree", true, [](bool) { return make_unique<Inserted>(); }},
  };
  return all;
}

enum class Motion { drift, jumps, lattice, ulps, equal, growth, flat, spread };
constexpr std::array motions{Motion::drift, Motion::jumps,  Motion::lattice, Motion::ulps,
                             Motion::equal, Motion::growth, Motion::flat,    Motion::spread};
constexpr std::array names{"drift", "jumps", "lattice", "ulps", "equal", "growth", "flat", "spread"};

/// f(min, max, axis) changes the box along each axis.
template <class Change>
Aabb3 changed(Aabb3 b, const Change& f) {
  f(b.min.x, b.max.x, 0), f(b.min.y, b.max.y, 1), f(b.min.z, b.max.z, 2);
  return b;
}

Aabb3 new_box(Motion motion, Entropy& e) {
  return changed({}, [&](double& min, double& max, int) {
    const double cell = static_cast<double>(e.below(4)) - 2;
    switch (motion) {
      case Motion::drift:
      case Motion::jumps:
        min = 7 * part(e) - 4, max = min + 2.5 * part(e);
        break;
      case Motion::lattice:
      case Motion::ulps:
        min = cell, max = cell + 1;
        break;
      case Motion::equal:
        min = 1, max = 2;
        break;
      case Motion::growth:
        min = cell, max = min + 0.5;
        break;
      case Motion::flat:
        min = cell, max = cell + (e.coin() ? 0 : 1);
        break;
      case Motion::spread:
        min = box_scenes::any_number(e), max = box_scenes::any_number(e);
        if (max < min) std::swap(min, max);
    }
  });
}

/// Where a box goes in a frame; nothing where it stays.
std::optional<Aabb3> next_box(Motion motion, const Aabb3& b, Id id, std::size_t frame, Entropy& e) {
  if (motion != Motion::drift && e.below(3) != 0) return {};
  if (e.below(motion == Motion::jumps || motion == Motion::spread ? 2 : 40) == 0) return new_box(motion, e);
  return changed(b, [&](double& min, double& max, int axis) {
    switch (motion) {
      case Motion::drift: {  // there and back, each at a speed of its own
        const auto turn = (frame / 32 + id + static_cast<std::size_t>(axis)) % 2;
        const double by = (turn == 0 ? 0.02 : -0.02) * static_cast<double>(id % 5);
        min += by, max += by;
        break;
      }
      case Motion::jumps:
      case Motion::lattice:
      case Motion::flat: {
        const double by = static_cast<double>(e.below(3)) - 1;
        if (std::abs(min + by) < 4) min += by, max += by;
        break;
      }
      case Motion::ulps: {
        const double far = e.coin() ? 1e9 : -1e9;
        double& moved = e.coin() ? min : max;
        moved = std::nextafter(moved, far);
        break;
      }
      case Motion::equal: {  // all together, but for those that have gone elsewhere
        const double at = id % 7 == 3 ? 2 : 1 + static_cast<double>(frame % 3);
        min = at, max = at + 1;
        break;
      }
      case Motion::growth: {
        const double half = e.coin() ? (max - min) : (max - min) / 4, middle = min + (max - min) / 2;
        if (half < 4) min = middle - half, max = middle + half;
        break;
      }
      case Motion::spread: {
        const double by = std::ldexp(max - min, -static_cast<int>(e.below(60)));
        if (std::abs(max + by) < 1e308 && std::abs(min) < 1e308) min += by, max += by;
      }
    }
  });
}

/// What happened, to be told where tests are representative.
struct Tally {
  std::size_t frames = 0, pairs = 0, touching = 0, added = 0, lost = 0, inserted = 0, removed = 0, found = 0;
};

Pairs by_each_pair(const Boxes& boxes, bool touching) {
  Pairs pairs;
  for (Id a = 0; a < boxes.size(); ++a) {
    for (Id b = a + 1; boxes[a] && b < boxes.size(); ++b) {
      const Relation r = boxes[b] ? relate(*boxes[a], *boxes[b]) : Relation::disjoint;
      if (r == Relation::overlapping || (touching && r == Relation::touching)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

AnyRay some_ray(Motion motion, Entropy& e) {
  const Aabb3 from = new_box(motion, e), to = new_box(motion, e);
  if (e.coin()) return Segment3{from.min, to.min};
  // Along the lattice, or anywhere.
  const double x = static_cast<double>(e.below(3)) - 1, y = static_cast<double>(e.below(3)) - 1;
  return Ray3{{from.min.x - 4 * x, from.min.y - 4 * y, from.min.z}, {x, y, e.coin() ? 0 : part(e) - 0.5}};
}

void play(Motion motion, std::uint64_t seed, Tally& tally) {
  Entropy e(2054, seed * motions.size() + static_cast<std::uint64_t>(motion));
  const bool touching = seed % 2 == 0;
  struct Played {
    const char* name;
    std::unique_ptr<World> world;
  };
  std::vector<Played> worlds;
  for (const Structure& s : structures()) {
    if (motion == Motion::spread && !s.takes_any_size) continue;
    worlds.push_back({s.name, s.make(touching)});
  }
  const auto each = [&](const auto& act) {
    for (const Played& p : worlds) act(*p.world);
  };
  Boxes boxes(most_boxes);
  Pairs before;
  const std::size_t frames = frames_of_scene / 2;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const bool is_busy = frame == 0 || e.below(24) == 0;
    for (Id id = 0; id < boxes.size(); ++id) {
      std::optional<Aabb3>& box = boxes[id];
      if (!box) {
        if (!is_busy && e.below(24) != 0) continue;
        box = new_box(motion, e);
        each([&](World& w) { w.insert(id, *box); });
        ++tally.inserted;
      } else if (e.below(is_busy ? 4 : 96) == 0) {
        box.reset();
        each([&](World& w) { w.remove(id); });
        ++tally.removed;
      } else if (const auto to = next_box(motion, *box, id, frame, e)) {
        box = to;
        each([&](World& w) { w.move(id, *box); });
      }
    }
    const Pairs expected = by_each_pair(boxes, touching);
    const Aabb3 region = new_box(motion, e);
    const AnyRay ray = some_ray(motion, e);
    Ids inside;
    for (Id id = 0; id < boxes.size(); ++id) {
      const Relation r = boxes[id] ? relate(*boxes[id], region) : Relation::disjoint;
      if (r == Relation::overlapping || (touching && r == Relation::touching)) inside.push_back(id);
    }
    for (const Played& p : worlds) {
      const auto about = [&] {
        return std::string(p.name) + ", " + names[static_cast<std::size_t>(motion)] + " " + std::to_string(seed) +
               ", frame " + std::to_string(frame);
      };
      p.world->check_hit(boxes, ray);
      ASSERT_FALSE(::testing::Test::HasFailure()) << about();
      ASSERT_EQ(p.world->in_box(region, touching).value_or(inside), inside) << about();
      ASSERT_EQ(p.world->pairs(touching), expected) << about();
      ASSERT_FALSE(::testing::Test::HasFailure()) << about();
    }
    ++tally.frames, tally.pairs += expected.size(), tally.found += inside.size();
    if (touching) tally.touching += expected.size() - by_each_pair(boxes, false).size();
    Pairs others;
    std::set_difference(expected.begin(), expected.end(), before.begin(), before.end(), std::back_inserter(others));
    tally.added += others.size(), tally.lost += before.size() + others.size() - expected.size();
    before = expected;
  }
}

TEST(MovingWorlds, AreReplayedAgainstEachPairInEveryFrame) {
  std::size_t frames = 0;
  for (const Motion motion : motions) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      play(motion, seed, tally);
      if (HasFailure()) return;
    }
    frames += tally.frames;
    if (!battery::reaches_rare) continue;
    const char* const name = names[static_cast<std::size_t>(motion)];
    EXPECT_GT(tally.pairs, tally.frames) << name;
    EXPECT_GT(tally.added, tally.frames / 4) << name;
    EXPECT_GT(tally.lost, tally.frames / 4) << name;
    EXPECT_GT(tally.inserted, tally.frames / 4) << name;
    EXPECT_GT(tally.removed, tally.frames / 4) << name;
    EXPECT_GT(tally.found, tally.frames / 4) << name;
    if (motion == Motion::lattice || motion == Motion::flat || motion == Motion::ulps) {
      EXPECT_GT(tally.touching, tally.frames) << name;
    }
  }
  if (battery::reaches_rare) {
    EXPECT_GT(frames, 2000u);
    EXPECT_GT(Moving::hits_, frames / 2);
    EXPECT_GT(Moving::ties_, frames / 20);
  }
}

}  // namespace
}  // namespace plumb

// Do all indexes of boxes that come, go and move tell the same pairs as asking each pair, whatever is done to them?
//
// The bytes are a scale and a sequence of insertions, moves, removals and questions.  Every index does the same; what an
// index refuses (a grid that would take too much memory) must leave it as it was.  Those that do not change are made of
// what is there at the end.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space.hpp"

namespace plumb::fuzz {
namespace {

using Id = std::uint32_t;  // of a box, given once
using Boxes = std::map<Id, Aabb3>;
using IdPairs = std::vector<std::array<Id, 2>>;  // ascending

[[noreturn]] void fail(std::string_view index, const char* what) {
  std::cerr << index << ": " << what << std::endl;
  std::abort();
}
void expect(bool holds, std::string_view index, const char* what) {
  if (!holds) fail(index, what);
}

enum class Scale { integers, nudged, spread, any };

double side(Entropy& e, Scale scale) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (scale) {
    case Scale::integers:
      return static_cast<double>(e.within(4));
    case Scale::nudged: {
      const double x = static_cast<double>(e.within(3)) / 4;
      const std::int64_t way = e.within(1);
      return way == 0 ? x : std::nextafter(x, static_cast<double>(way) * infinity);
    }
    case Scale::spread:
      return std::ldexp(static_cast<double>(e.within(8)), static_cast<int>(e.within(12)));
    case Scale::any:
      break;
  }
  const double x = std::bit_cast<double>(e.bits(64));
  return x - x == 0 ? x : 0;
}
Aabb3 some_box(Entropy& e, Scale scale) {
  const auto ends = [&] {
    const double a = side(e, scale), b = e.below(4) == 0 ? a : side(e, scale);
    return std::array{std::min(a, b), std::max(a, b)};
  };
  const auto x = ends(), y = ends(), z = ends();
  return {{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
}

bool count_as_pair(const Aabb3& a, const Aabb3& b, bool touching) {
  const Relation r = relate(a, b);
  return r == Relation::overlapping || (touching && r == Relation::touching);
}
IdPairs all_pairs(const Boxes& boxes, bool touching = true) {
  IdPairs pairs;
  for (auto a = boxes.begin(); a != boxes.end(); ++a) {
    for (auto b = std::next(a); b != boxes.end(); ++b) {
      if (count_as_pair(a->second, b->second, touching)) pairs.push_back({a->first, b->first});
    }
  }
  return pairs;
}

/// An index that is asked as it is.
template <class Index>
class Indexed {
 public:
  Indexed(const char* name, Index index) : name_(name), index_(std::move(index)) {}

  void insert(Id id, const Aabb3& box) {
    const std::size_t before = index_.size();
    try {
      const BoxHandle handle = index_.insert(box);
      expect(ids_.emplace(handle, id).second, name_, "a handle is given twice");
      handles_[id] = handle;
      boxes_[id] = box;
    } catch (const Error&) {
      expect(index_.size() == before, name_, "a refused box was kept");
    }
  }
  void move(Id id, const Aabb3& box) {
    const auto at = handles_.find(id);
    if (at == handles_.end()) return;
    try {
      index_.move(at->second, box);
      boxes_[id] = box;
    } catch (const Error&) {
      expect(index_.size() == boxes_.size(), name_, "a refused move changed the number of boxes");
    }
  }
  void remove(Id id) {
    const auto at = handles_.find(id);
    if (at == handles_.end()) return;
    const BoxHandle handle = at->second;
    index_.remove(handle);
    ids_.erase(handle);
    handles_.erase(at);
    boxes_.erase(id);
    try {
      index_.remove(handle);
    } catch (const Error&) {
      return;
    }
    fail(name_, "a handle is removed twice");
  }
  template <class Ask>
  void check_pairs(const Ask& ask, bool touching = true) const {
    IdPairs pairs;
    for (const HandlePair& p : ask(index_)) {
      expect(p.a < p.b && ids_.contains(p.a) && ids_.contains(p.b), name_, "a pair is none of handles");
      const Id a = ids_.at(p.a), b = ids_.at(p.b);
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
    std::ranges::sort(pairs);
    expect(pairs == all_pairs(boxes_, touching), name_, "the pairs differ");
    expect(index_.size() == boxes_.size(), name_, "the number of boxes differs");
  }
  void check_in_box(const Aabb3& box) const {
    for (const bool touching : {true, false}) {
      std::set<Id> found, expected;
      for (const BoxHandle& handle : index_.in_box(box, {.touching = touching}))
        expect(ids_.contains(handle) && found.insert(ids_.at(handle)).second, name_, "a box is found twice");
      for (const auto& [id, b] : boxes_) {
        if (count_as_pair(b, box, touching)) expected.insert(id);
      }
      expect(found == expected, name_, "what overlaps a box differs");
    }
  }

 private:
  const char* name_;
  Index index_;
  std::map<BoxHandle, Id> ids_;
  std::map<Id, BoxHandle> handles_;
  Boxes boxes_;
};

/// Those of this call and of the last differ by what is told.
class Moving {
 public:
  void insert(Id id, const Aabb3& box) {
    handles_[id] = world_.insert(box);
    ids_[handles_[id]] = id;
  }
  void move(Id id, const Aabb3& box) { world_.move(handles_.at(id), box); }
  void remove(Id id) {
    const BoxHandle handle = handles_.at(id);
    world_.remove(handle);
    expect(!world_.contains(handle), "MovingBoxes", "a handle outlives its box");
    handles_.erase(id);
  }
  void check(const Boxes& boxes, const Aabb3& region) {
    std::set<Id> inside, expected;
    for (const BoxHandle& h : world_.in_box(region)) inside.insert(ids_.at(h));
    std::optional<BoxHandle> first;
    std::optional<RayParameter> least;
    const Segment3 segment{region.min, region.max};
    for (const auto& [id, box] : boxes) {
      if (count_as_pair(box, region, true)) expected.insert(id);
      auto t = first_hit_parameter(segment, box);
      if (!t || (least && (*least < *t || (*least == *t && *first < handles_.at(id))))) continue;
      first = handles_.at(id);
      least = std::move(t);
    }
    expect(inside == expected, "MovingBoxes", "what is in a box differs");
    const auto hit = world_.first_hit(segment);
    expect(hit.has_value() == first.has_value() && (!hit || hit->box == *first), "MovingBoxes",
           "the first hit differs");
    const BoxPairChanges& changes = world_.changes();
    const auto named = [&](const HandlePair& p) {
      const Id a = ids_.at(p.a), b = ids_.at(p.b);
      return std::array{std::min(a, b), std::max(a, b)};
    };
    for (const HandlePair& p : changes.lost) expect(pairs_.erase(named(p)) == 1, "MovingBoxes", "lost a pair not had");
    for (const HandlePair& p : changes.added) expect(pairs_.insert(named(p)).second, "MovingBoxes", "added one had");
    expect(std::ranges::equal(pairs_, all_pairs(boxes)), "MovingBoxes", "the pairs differ");
    IdPairs all;
    for (const HandlePair& p : world_.overlapping_pairs()) all.push_back(named(p));
    std::ranges::sort(all);
    expect(std::ranges::equal(pairs_, all) && world_.size() == boxes.size(), "MovingBoxes", "pairs() differ");
  }

 private:
  MovingBoxes world_;
  std::map<Id, BoxHandle> handles_;
  std::map<BoxHandle, Id> ids_;  // of removed ones too: a handle names one box for ever
  std::set<std::array<Id, 2>> pairs_;
};

/// Of those that do not change: the numbers of the boxes that have a point in one, or overlap it.
template <class Ask>
void check_numbers(const char* name, const std::vector<Aabb3>& boxes, const Aabb3& box, const Ask& ask) {
  for (const bool touching : {true, false}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (count_as_pair(boxes[i], box, touching)) expected.push_back(i);
    }
    expect(ask(InBoxOptions{touching}) == expected, name, "what overlaps a box differs");
  }
}

void check_from_scratch(const Boxes& held, const Aabb3& box, BroadPhaseMethod method) {
  std::vector<Id> ids;
  std::vector<Aabb3> boxes;
  for (const auto& [id, b] : held) ids.push_back(id), boxes.push_back(b);
  const auto check = [&](std::string_view name, const std::vector<BoxPair>& found, bool touching) {
    IdPairs pairs;
    for (const BoxPair& p : found) pairs.push_back({ids[p.a], ids[p.b]});
    std::ranges::sort(pairs);
    expect(pairs == all_pairs(held, touching), name, "the pairs differ");
  };
  for (const bool touching : {true, false}) {
    for (const auto by : {BroadPhaseMethod::swept_columns, BroadPhaseMethod::sort_and_sweep, method})
      check(name_of(by), overlapping_pairs(boxes, {touching, Execution::serial, by}), touching);
  }
  const BoxPairOptions serial{.execution = Execution::serial};
  for (const auto rule : {CellRule::smallest_cell, CellRule::every_leaf}) {
    const BoxOctree tree = build_octree(boxes, {.most_in_leaf = 2, .rule = rule, .execution = Execution::serial});
    check("BoxOctree", overlapping_pairs(tree, serial), true);
    check_numbers("BoxOctree", boxes, box, [&](const InBoxOptions& o) { return in_box(tree, box, o); });
  }
  const StaticGrid3 grid(boxes);
  check_numbers("StaticGrid", boxes, box, [&](const InBoxOptions& o) { return grid.in_box(box, o); });
  const auto figures = build_figure_tree(boxes, {.most_in_leaf = 2, .execution = Execution::serial});
  check_numbers("FigureTree", boxes, box, [&](const InBoxOptions& o) { return in_box(figures, box, o); });
  const auto split = build_split_tree(boxes, {.most_in_leaf = 2, .execution = Execution::serial});
  check_numbers("SplitTree", boxes, box, [&](const InBoxOptions& o) { return in_box(split, box, o); });
  const HybridOptions small{.in_part = 4, .most_in_list = 2, .grid = {}, .execution = Execution::serial};
  const auto of_trees = build_grid_of_trees(boxes, small);
  check("GridOfTrees", overlapping_pairs(of_trees, serial), true);
  check_numbers("GridOfTrees", boxes, box, [&](const InBoxOptions& o) { return in_box(of_trees, box, o); });
  const auto of_grids = build_tree_of_grids(boxes, small);
  check("TreeOfGrids", overlapping_pairs(of_grids, serial), true);
  check_numbers("TreeOfGrids", boxes, box, [&](const InBoxOptions& o) { return in_box(of_grids, box, o); });
}

void run(Entropy& e) {
  constexpr std::size_t most_boxes = 24, most_steps = 80;
  const auto scale = static_cast<Scale>(e.below(4));
  constexpr std::size_t little = 1U << 20;
  Moving moving;
  Indexed hierarchical("HierarchicalGrid", HierarchicalGrid3());
  Indexed rows("RowColumnGrid", RowColumnGrid3({.rows = 64}));
  Indexed hashed("HashedGrid", HashedGrid3({.cell_size = 1, .most_memory = little}));
  Indexed linked("LinkedGrid",
                 LinkedGrid3({.world = {{-2, -2, -2}, {2, 2, 2}}, .cell_size = 0.5, .most_memory = little}));
  Indexed implicit("ImplicitGrid", ImplicitGrid3({.cell_size = 1, .rows = 64}));
  Indexed lists("SweepLists", SweepLists());
  Indexed list("SweepLists of one axis", SweepLists({.lists = 1, .first_axis = SweepAxis::y}));
  Indexed loose("LooseOctree", LooseOctree({.world = {{-4, -4, -4}, {4, 4, 4}}}));
  const auto each = [&](const auto& act) {
    act(hierarchical), act(rows), act(hashed), act(linked), act(implicit), act(lists), act(list), act(loose);
  };
  SweepArray array;
  Boxes boxes;
  Id next = 0;
  const auto some = [&] { return std::next(boxes.begin(), static_cast<std::ptrdiff_t>(e.below(boxes.size()))); };
  const auto check = [&] {
    const Aabb3 box = some_box(e, scale);
    moving.check(boxes, box);
    const auto pairs = [](const auto& index) { return index.overlapping_pairs(); };
    hierarchical.check_pairs(pairs), rows.check_pairs(pairs), hashed.check_pairs(pairs), linked.check_pairs(pairs);
    implicit.check_pairs(pairs), lists.check_pairs(pairs), list.check_pairs(pairs);
    std::vector<Aabb3> now;
    for (const auto& [id, b] : boxes) now.push_back(b);
    expect(array.overlapping_pairs(now) == sort_and_sweep_pairs(now), "SweepArray",
           "the pairs differ from those from scratch");
    for (const bool touching : {true, false}) {
      loose.check_pairs(
          [&](const LooseOctree& t) {
            return t.overlapping_pairs({touching, Execution::serial});
          },
          touching);
    }
    hierarchical.check_in_box(box), rows.check_in_box(box), implicit.check_in_box(box), loose.check_in_box(box);
    if (scale == Scale::any || scale == Scale::spread) return;  // which reach into too many cells
    hashed.check_in_box(box), linked.check_in_box(box);
  };
  for (std::size_t step = 0; step < most_steps && !e.exhausted(); ++step) {
    switch (e.below(8)) {
      case 0:
        check();
        break;
      case 1:
        if (boxes.empty()) break;
        {
          const auto at = some();
          moving.remove(at->first);
          each([&](auto& index) { index.remove(at->first); });
          boxes.erase(at);
        }
        break;
      case 2:
      case 3:
        if (boxes.empty()) break;
        {
          const auto at = some();
          at->second = some_box(e, scale);
          moving.move(at->first, at->second);
          each([&](auto& index) { index.move(at->first, at->second); });
        }
        break;
      default:
        if (boxes.size() == most_boxes) break;
        const Aabb3 box = some_box(e, scale);
        boxes[next] = box;
        moving.insert(next, box);
        each([&](auto& index) { index.insert(next, box); });
        ++next;
    }
  }
  check();
  const Aabb3 box = some_box(e, scale);
  check_from_scratch(boxes, box, broad_phase_methods[e.below(broad_phase_methods.size())]);
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::Entropy entropy = plumb::Entropy::from_bytes({data, size});
  plumb::fuzz::run(entropy);
  return 0;
}

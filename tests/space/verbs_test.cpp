// Is every verb asked of every index that has it by one rule?  Which index has which is a table; what differs from it is a
// line that is wrong.  The rules are those of docs/space.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"

namespace plumb {
namespace {

/// Boxes at whole numbers: each touches the next one, and the last two are one box.
std::vector<Aabb3> row_of_boxes() {
  std::vector<Aabb3> boxes;
  for (int i = 0; i < 5; ++i) boxes.push_back({{1.0 * i, 0, 0}, {i + 1.0, 1, 1}});
  boxes.push_back(boxes.back());
  return boxes;
}
std::vector<Point3> corners_of(const std::vector<Aabb3>& boxes) {
  std::vector<Point3> points;
  for (const Aabb3& b : boxes) points.push_back(b.min);
  return points;
}
/// A triangle across each box, from corner to corner.
TriangleMesh mesh_of(const std::vector<Aabb3>& boxes) {
  TriangleMesh mesh;
  for (const Aabb3& b : boxes) {
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {b.min, b.max, {b.max.x, b.min.y, b.max.z}});
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  return mesh;
}
constexpr Aabb3 world{{-8, -8, -8}, {16, 16, 16}};

template <class Index>
Index filled(Index index, const std::vector<Aabb3>& boxes) {
  for (const Aabb3& b : boxes) (void)insert(index, b);
  return index;
}
MovingBoxes world_of(const std::vector<Aabb3>& boxes) {
  MovingBoxes made;
  (void)made.insert(boxes);
  (void)made.changes();  // whose pairs overlapping_pairs tells
  return made;
}

/// Names of verbs, each with the rules that are broken.
using Broken = std::map<std::string, std::string>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Aabb3 no_box{{0, 0, 0}, {1, nan, 1}};
constexpr Point3 no_point{0, nan, 0};

/// Does the call throw this, and say the name of what was called?
template <class Thrown, class Call>
bool refuses(const char* name, const Call& call) {
  return text_of<Thrown>(call).find(name) != std::string::npos;
}

constexpr Ray3 ray{{-1, 0.25, 0.5}, {1, 0, 0}};
constexpr Point3 probe{2, 0, 0};

/// What is asked of an index of these boxes, and of one of nothing.
template <class Index>
Broken verbs_of(const Index& index, const Index& nothing, std::size_t n) {
  Broken verbs;
  const auto asked = [&](const std::string& verb, bool keeps_rules, const std::string& rule) {
    std::string& broken = verbs[verb];
    if (!keeps_rules) broken += " " + rule;
  };
  const Aabb3 beside{{5, 0, 0}, {6, 1, 1}};  // touches the last two alone
  if constexpr (requires { in_box(index, beside); }) {
    asked("in_box", in_box(nothing, world).empty(), "of nothing there is something");
    const auto touched = in_box(index, beside), all = in_box(index, world);
    asked("in_box", all.size() == n, "not all are in the world");
    asked("in_box",
          std::ranges::is_sorted(all, {},
                                 [](const auto& x) {
                                   if constexpr (requires { x.slot; })
                                     return x.slot;
                                   else
                                     return x;
                                 }),
          "they do not ascend");
    const auto inside = in_box(index, beside, InBoxOptions{.touching = false});
    asked("in_box", inside.empty() && inside.size() <= touched.size(),
          "what touches is told where it is not asked for");
    asked("in_box", refuses<NonFinite>("in_box", [&] { (void)in_box(index, no_box); }), "NaN is taken");
  }
  if constexpr (requires { overlapping_pairs(index); }) {
    asked("overlapping_pairs", overlapping_pairs(nothing).empty(), "of nothing there is something");
    asked("overlapping_pairs", overlapping_pairs(index).size() == n,
          "closed boxes touch");  // 0-1, 1-2, 2-3, 3-4, 3-5, 4-5
    if constexpr (requires { overlapping_pairs(index, BoxPairOptions{.touching = false}); }) {
      asked("overlapping_pairs", overlapping_pairs(index, BoxPairOptions{.touching = false}).size() == 1,
            "what touches is told where it is not asked for");
      asked("overlapping_pairs",
            overlapping_pairs(index, BoxPairOptions{.execution = Execution::serial}) == overlapping_pairs(index),
            "threads tell others");
    }
  }
  if constexpr (requires { nearest(index, probe, std::size_t{3}); }) {
    asked("nearest", nearest(nothing, probe, std::size_t{3}).empty(), "of nothing there is something");
    const auto all = nearest(index, probe, n + 7);
    asked("nearest", all.size() == n, "there are not as many as there are");
    asked("nearest",
          std::ranges::is_sorted(all,
                                 [](const auto& a, const auto& b) {
                                   return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
                                 }),
          "ties do not go by their numbers");
    asked("nearest", nearest(index, probe, std::size_t{0}).empty(), "none was asked for");
    asked("nearest", refuses<InvalidShape>("nearest", [&] { (void)nearest(nothing, probe); }), "there is a nearest");
    asked("nearest", refuses<NonFinite>("nearest", [&] { (void)nearest(index, no_point, 1); }), "NaN is taken");
  }
  if constexpr (requires { within(index, probe, 1.0); }) {
    asked("within", within(nothing, probe, 1e9).empty(), "of nothing there is something");
    asked("within", within(index, probe, 1e9).size() == n, "not all are within reach");
    const auto none = within(index, Point3{-2, 0, 0}, 2.0), short_of = within(index, Point3{-2, 0, 0}, 1.75);
    asked("within", none.size() == 1 && short_of.empty(), "a distance of exactly as much is within");
    asked("within", refuses<NonFinite>("within", [&] { (void)within(index, no_point, 1.0); }), "NaN is taken");
  }
  if constexpr (requires { meeting(index, beside); }) {
    asked("meeting", meeting(nothing, world).empty(), "of nothing there is something");
    asked("meeting", meeting(index, world).size() == n, "not all are in the world");
    asked("meeting", meeting(index, beside) == std::vector<std::uint32_t>{4, 5}, "closed sets touch");
    const std::vector<Aabb3> many{beside, world};
    const auto batch = meeting(index, std::span<const Aabb3>(many));
    asked("meeting", batch.size() == 2 && batch[0] == meeting(index, beside), "a batch answers as one by one");
    asked("meeting", refuses<NonFinite>("max.y is nan", [&] { (void)meeting(index, no_box); }), "NaN is taken");
  }
  if constexpr (requires { first_hit(index, ray); }) {
    asked("first_hit", !first_hit(nothing, ray), "of nothing there is something");
    asked("first_hit", first_hit(index, ray).has_value(), "it is not hit");
    const Ray3 no_ray{no_point, {1, 0, 0}};
    asked("first_hit", refuses<NonFinite>("first_hit", [&] { (void)first_hit(index, no_ray); }), "NaN is taken");
  }
  if constexpr (requires { any_hit(index, ray); }) {
    asked("any_hit", !any_hit(nothing, ray) && any_hit(index, ray), "it is not hit");
  }
  if constexpr (requires { hits(index, ray); }) {
    const auto all = hits(index, ray);
    asked("hits", hits(nothing, ray).empty() && all.size() == n, "not all are hit");
    asked("hits",
          std::ranges::is_sorted(all,
                                 [](const NumberedHit& a, const NumberedHit& b) {
                                   return a.hit.t != b.hit.t ? a.hit.t < b.hit.t : a.index < b.index;
                                 }),
          "they are not in the order of the ray, then of their numbers");
    asked("hits", first_hit(index, ray) == all.at(0), "the first is not the first of all");
    asked("count_hits", count_hits(index, ray) == n && count_hits(nothing, ray) == 0, "not all are counted");
    asked("first_triangle", first_triangle(index, ray) == all.at(0).index, "it is not the first hit's");
    const std::vector<AnyRay> rays{ray, Ray3{{-1, 9, 9}, {1, 0, 0}}};
    std::vector<std::optional<NumberedHit>> first(2);
    first_hit(index, rays, first);
    asked("first_hit", first[0] == all.at(0) && !first[1], "a batch answers as one by one");
    const auto too_few = std::span(first).first(1);
    asked("first_hit", refuses<UnequalLengths>("first_hit", [&] { first_hit(index, rays, too_few); }),
          "a batch has fewer answers than questions");
    std::vector<std::uint8_t> any(2);
    any_hit(index, rays, any);
    asked("any_hit", any == std::vector<std::uint8_t>{1, 0}, "a batch answers as one by one");
  }
  if constexpr (requires { locate(index, probe); }) {
    if constexpr (std::is_same_v<decltype(locate(index, probe)), Location>)
      asked("locate", locate(nothing, probe) == Location::outside, "in nothing there is something");
  }
  if constexpr (requires { intersecting_pairs(index, index); }) {
    asked("intersecting_pairs", intersecting_pairs(index, nothing).empty(), "of nothing there is something");
    const auto pairs = intersecting_pairs(index, index);
    asked("intersecting_pairs", pairs.size() >= n, "each meets itself");
    const auto count = count_intersecting_pairs(index, index);
    asked("count_intersecting_pairs", count.touching + count.overlapping == pairs.size(), "not all are counted");
    asked("any_intersecting_pair", any_intersecting_pair(index, index).has_value(), "none is found");
    asked("intersecting_pairs", intersecting_pairs(index, index, PairOptions{.execution = Execution::serial}) == pairs,
          "threads tell others");
    const PairOptions stopped{.progress = [](double) { return false; }};
    asked("intersecting_pairs",
          refuses<Cancelled>("intersecting_pairs", [&] { (void)intersecting_pairs(index, index, stopped); }),
          "it is not stopped");
    const auto own = intersecting_pairs(index);
    asked("intersecting_pairs", std::ranges::all_of(own, [](const TrianglePair& p) { return p.a < p.b; }),
          "of one with itself each is told once");
  }
  if constexpr (requires { memory_of(index); }) asked("memory_of", memory_of(index) > 0, "it takes nothing");
  return verbs;
}

template <class Index>
std::string size_rule(const Index& index, std::size_t n) {
  return index.size() == n ? "" : "not as many as were put in";
}

/// Whether what was put in can be moved and taken out again.
template <class Index>
Broken changes_of(Index index) {
  Broken verbs;
  if constexpr (requires { insert(index, world); }) {
    const BoxHandle handle = insert(index, Aabb3{{0, 0, 0}, {1, 1, 1}});
    move(index, handle, Aabb3{{2, 2, 2}, {3, 3, 3}});
    verbs["move"] = size_rule(index, 1);
    remove(index, handle);
    verbs["remove"] = size_rule(index, 0);
    const BoxHandle other = insert(index, Aabb3{{0, 0, 0}, {1, 1, 1}});
    const bool is_refused = refuses<InvalidShape>(" was removed", [&] { move(index, handle, world); });
    verbs["insert"] = is_refused && !index.contains(handle) && index.contains(other) &&
                              in_box(index, world) == std::vector<BoxHandle>{other}
                          ? ""
                          : "a handle names two boxes";
  }
  return verbs;
}
std::string spoken(const Broken& verbs) {
  std::string text;
  for (const auto& [verb, broken] : verbs)
    text += (text.empty() ? "" : " ") + verb + (broken.empty() ? "" : "(" + broken + ")");
  return text;
}
template <class Build>
std::string asked_of(const Build& build) {
  const std::vector<Aabb3> boxes = row_of_boxes();
  const auto index = build(boxes), nothing = build(std::vector<Aabb3>());
  return spoken(verbs_of(index, nothing, boxes.size()));
}

struct Row {
  std::string index, verbs;
};

const std::string of_meshes =
    "any_hit any_intersecting_pair count_hits count_intersecting_pairs first_hit first_triangle hits "
    "intersecting_pairs "
    "locate meeting";

TEST(Verbs, AreThoseOfTheTable) {
  using Boxes = std::vector<Aabb3>;
  const std::vector<Row> told{
      {"KdTree", asked_of([](const Boxes& b) { return build_kd_tree(corners_of(b)); })},
      {"FigureTree", asked_of([](const Boxes& b) { return build_figure_tree(b); })},
      {"GridOfTrees", asked_of([](const Boxes& b) { return build_grid_of_trees(b); })},
      {"TreeOfGrids", asked_of([](const Boxes& b) { return build_tree_of_grids(b); })},
      {"SplitTree", asked_of([](const Boxes& b) { return build_split_tree(b); })},
      {"PointOctree", asked_of([](const Boxes& b) { return build_octree(corners_of(b)); })},
      {"BoxOctree", asked_of([](const Boxes& b) { return build_octree(b); })},
      {"LooseOctree", asked_of([](const Boxes& b) { return filled(LooseOctree({.world = world}), b); })},
      {"StaticGrid", asked_of([](const Boxes& b) { return StaticGrid3(b, {.cell_size = 2}); })},
      {"HashedGrid", asked_of([](const Boxes& b) { return filled(HashedGrid3({.cell_size = 2}), b); })},
      {"LinkedGrid", asked_of([](const Boxes& b) { return filled(LinkedGrid3({.world = world, .cell_size = 2}), b); })},
      {"HierarchicalGrid", asked_of([](const Boxes& b) { return filled(HierarchicalGrid3(), b); })},
      {"ImplicitGrid", asked_of([](const Boxes& b) { return filled(ImplicitGrid3({.cell_size = 2}), b); })},
      {"RowColumnGrid", asked_of([](const Boxes& b) { return filled(RowColumnGrid3(), b); })},
      {"SweepLists", asked_of([](const Boxes& b) { return filled(SweepLists(), b); })},
      {"MovingBoxes", asked_of([](const Boxes& b) { return world_of(b); })},
  };
  const std::map<std::string, std::string> expected{
      {"KdTree", "in_box memory_of nearest within"},
      {"FigureTree", "in_box memory_of nearest within"},
      {"GridOfTrees", "in_box memory_of overlapping_pairs"},
      {"TreeOfGrids", "in_box memory_of overlapping_pairs"},
      {"SplitTree", "any_hit first_hit in_box memory_of overlapping_pairs"},
      {"PointOctree", "in_box"},
      {"BoxOctree", "in_box overlapping_pairs"},
      {"LooseOctree", "in_box memory_of overlapping_pairs"},
      {"StaticGrid", "in_box memory_of overlapping_pairs"},
      {"HashedGrid", "in_box memory_of overlapping_pairs"},
      {"LinkedGrid", "in_box memory_of overlapping_pairs"},
      {"HierarchicalGrid", "in_box memory_of overlapping_pairs"},
      {"ImplicitGrid", "in_box memory_of overlapping_pairs"},
      {"RowColumnGrid", "in_box memory_of overlapping_pairs"},
      {"SweepLists", "in_box memory_of overlapping_pairs"},
      {"MovingBoxes", "first_hit in_box overlapping_pairs"},
  };
  for (const Row& row : told) EXPECT_EQ(row.verbs, expected.at(row.index)) << row.index;
}

// A mesh in any of its forms is one index.
TEST(Verbs, OfMeshesAreThoseOfOneIndexInEveryForm) {
  const Bvh bvh = build_bvh(mesh_of(row_of_boxes())), none = build_bvh(TriangleMesh{});
  const CompactBvh small = compact(bvh), small_none = compact(none);
  const Pose as_built = identity_pose;
  const RigidPose half{{1, 0, 0, 0}, {0, 0, 0}}, whole_turn{{0, 0, 0, 2}, {0, 0, 0}};
  const RigidChain chain{{whole_turn, whole_turn, half}};
  const std::size_t n = bvh.triangles.size();
  EXPECT_EQ(spoken(verbs_of(MeshView(bvh), MeshView(none), n)), of_meshes);
  EXPECT_EQ(spoken(verbs_of(MeshView(small), MeshView(small_none), n)), of_meshes);
  EXPECT_EQ(spoken(verbs_of(MeshView(bvh, as_built), MeshView(none, as_built), n)), of_meshes);
  EXPECT_EQ(spoken(verbs_of(MeshView(bvh, half), MeshView(none, half), n)), of_meshes);
  EXPECT_EQ(spoken(verbs_of(MeshView(bvh, chain), MeshView(none, chain), n)), of_meshes);
  EXPECT_EQ(spoken(verbs_of(MeshView(small, chain), MeshView(small_none, half), n)), of_meshes);
  EXPECT_EQ(intersecting_pairs(small, bvh), intersecting_pairs(bvh, bvh));
  EXPECT_EQ(intersecting_pairs({bvh, chain}, {small, half}), intersecting_pairs(bvh, bvh));
}

TEST(Verbs, ChangeWhatComesAndGoes) {
  const std::string all = "insert move remove";
  EXPECT_EQ(spoken(changes_of(LooseOctree({.world = world}))), all);
  EXPECT_EQ(spoken(changes_of(HashedGrid3({.cell_size = 2}))), all);
  EXPECT_EQ(spoken(changes_of(LinkedGrid3({.world = world, .cell_size = 2}))), all);
  EXPECT_EQ(spoken(changes_of(HierarchicalGrid3())), all);
  EXPECT_EQ(spoken(changes_of(ImplicitGrid3({.cell_size = 2}))), all);
  EXPECT_EQ(spoken(changes_of(RowColumnGrid3())), all);
  EXPECT_EQ(spoken(changes_of(SweepLists())), all);
  EXPECT_EQ(spoken(changes_of(MovingBoxes())), all);
}

}  // namespace
}  // namespace plumb

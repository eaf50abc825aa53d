// Rows that are given back lend their memory to the next rows, which are the same: every function that returns rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/plumb.hpp"
#include "plumb/space/range/volume_range.hpp"
#include "plumb/space/ray/open_winding.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

bool is_same(const BoxPair& p, const BoxPair& q) { return p.a == q.a && p.b == q.b; }
bool is_same(const BoxHandle& p, const BoxHandle& q) { return p == q; }
bool is_same(const HandlePair& p, const HandlePair& q) { return p.a == q.a && p.b == q.b; }
bool is_same(const NearestFigure& p, const NearestFigure& q) { return p.index == q.index && p.distance == q.distance; }
bool is_same(const Intersection3& p, const Intersection3& q) {
  const std::vector<Point3> a = approximate(p), b = approximate(q);
  return std::ranges::equal(a, b);
}
template <class Row>
requires requires(const Row& p) { p == p; }
bool is_same(const Row& p, const Row& q) { return p == q; }

/// ask(rows) gives rows.
template <class Row, class Ask>
void expect_kept(const char* name, const Ask& ask) {
  SCOPED_TRACE(name);
  std::vector<Row> rows = ask(std::vector<Row>());
  ASSERT_FALSE(rows.empty());
  const std::vector<Row> expected = rows;
  const Row* const place = rows.data();
  rows.resize(rows.size() / 2);  // what is in them is nothing to anybody
  rows = ask(std::move(rows));
  EXPECT_EQ(rows.data(), place);
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_TRUE(is_same(rows[i], expected[i])) << i;
}

#define EXPECT_KEPT(Row, ...) expect_kept<Row>(#__VA_ARGS__, [&](std::vector<Row> rows) { return __VA_ARGS__; })
#define KEPT std::move(rows)

using Number = std::uint32_t;

struct KeptRows : testing::Test {
  static std::vector<Aabb3> boxes_in_space() {
    std::vector<Aabb3> boxes;
    for (int i = 0; i < 300; ++i) {
      const double x = i % 7, y = i / 7 % 7, z = i / 49;
      boxes.push_back({{x, y, z}, {x + 1.25, y + 1.5, z + 1}});
    }
    return boxes;
  }
  std::vector<Aabb3> boxes = boxes_in_space();
  std::vector<Aabb2> flat = [this] {
    std::vector<Aabb2> f;
    for (const Aabb3& b : boxes) f.push_back({{b.min.x, b.min.y}, {b.max.x, b.max.y}});
    return f;
  }();
  TriangleMesh ring = [] {  // one in another, a little aside
    TriangleMesh m = meshes::ring(12);
    const auto n = static_cast<std::uint32_t>(m.vertices.size());
    for (std::uint32_t i = 0; i < n; ++i)
      m.vertices.push_back({m.vertices[i].x + 0.25, m.vertices[i].y, m.vertices[i].z});
    for (std::size_t i = m.triangles.size(); i-- > 0;) {
      const auto [a, b, c] = m.triangles[i];
      m.triangles.push_back({a + n, b + n, c + n});
    }
    return m;
  }();
  Bvh mesh = build_bvh(ring);
  TriangleMesh shaken = [this] {
    TriangleMesh m = ring;
    for (Point3& p : m.vertices) p.x += 0.125;
    return m;
  }();
  Bvh other = build_bvh(shaken);
  CompactBvh compact = build_compact_bvh(ring), compact_other = build_compact_bvh(shaken);
  Pose pose{{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {0.0625, 0, 0}};
  Pose at_rest{pose.columns, {0, 0, 0}};
  Aabb3 region{{0, 0, -1}, {3, 3, 3}};
  Aabb2 square{{0, 0}, {3, 3}};
};

TEST_F(KeptRows, OfPairsOfBoxes) {
  const std::vector<FloatBox3> floats = [this] {
    std::vector<FloatBox3> f;
    const auto narrow = [](const Point3& p) {
      return std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    };
    for (const Aabb3& b : boxes) f.push_back({narrow(b.min), narrow(b.max)});
    return f;
  }();
  for (const BroadPhaseMethod method : broad_phase_methods) {
    SCOPED_TRACE(std::string(name_of(method)));
    const BroadPhaseOptions options{.method = method};
    EXPECT_KEPT(BoxPair, overlapping_pairs(boxes, options, KEPT));
    EXPECT_KEPT(BoxPair, overlapping_pairs(flat, options, KEPT));
    EXPECT_KEPT(BoxPair, overlapping_pairs(floats, options, KEPT));
    EXPECT_KEPT(BoxPair, overlapping_pairs(boxes, std::span<const Aabb3>(boxes).first(50), options, KEPT));
  }
  EXPECT_KEPT(BoxPair, brute_force_pairs(boxes, {}, KEPT));
  EXPECT_KEPT(BoxPair, brute_force_pairs(flat, flat, {}, KEPT));
  EXPECT_KEPT(BoxPair, sort_and_sweep_pairs(boxes, {}, KEPT));
}

TEST_F(KeptRows, OfIndexesOfBoxes) {
  const StaticGrid3 fixed(boxes);
  EXPECT_KEPT(BoxPair, fixed.overlapping_pairs({}, KEPT));
  EXPECT_KEPT(Number, fixed.in_box(region, {}, KEPT));
  const auto ask = [&](const char* name, const auto& index) {
    SCOPED_TRACE(name);
    EXPECT_KEPT(HandlePair, index.overlapping_pairs({}, KEPT));
    EXPECT_KEPT(BoxHandle, index.in_box(region, {}, KEPT));
  };
  HierarchicalGrid3 levels;
  ImplicitGrid3 implicit({.cell_size = 1.5});
  RowColumnGrid3 columns;
  SweepLists lists;
  MovingBoxes moving;
  for (const Aabb3& b : boxes) levels.insert(b), implicit.insert(b), columns.insert(b), lists.insert(b);
  moving.insert(boxes);
  moving.changes();
  ask("hierarchical grid", levels);
  ask("implicit grid", implicit);
  ask("row-column grid", columns);
  ask("lists", lists);
  EXPECT_KEPT(HandlePair, moving.overlapping_pairs(KEPT));
  EXPECT_KEPT(BoxHandle, moving.in_box(region, {}, KEPT));
}

TEST_F(KeptRows, OfTreesOfBoxesAndPoints) {
  const auto ask = [&](const char* name, const auto& index) {
    SCOPED_TRACE(name);
    EXPECT_KEPT(BoxPair, overlapping_pairs(index, {}, KEPT));
    EXPECT_KEPT(Number, in_box(index, region, {}, KEPT));
  };
  const std::span<const Aabb3> all(boxes);
  ask("octree", build_octree(all));
  ask("k-d tree", build_split_tree(all));
  ask("grid of trees", build_grid_of_trees(all, {}));
  ask("tree of grids", build_tree_of_grids(all, {}));
  const auto figures = build_figure_tree(all);
  EXPECT_KEPT(Number, in_box(figures, region, {}, KEPT));
  EXPECT_KEPT(Number, within(figures, Point3{1, 1, 1}, 2, KEPT));
  EXPECT_KEPT(NearestFigure, nearest(figures, Point3{1, 1, 1}, 20, Ties::lowest, KEPT));
  EXPECT_KEPT(NearestFigure, nearest(figures, Point3{1, 1, 1}, 20, Ties::all, KEPT));
  const std::span<const Point3> points(ring.vertices);
  const KdTree3 tree = build_kd_tree(points);
  EXPECT_KEPT(Number, in_box(tree, region, {}, KEPT));
  EXPECT_KEPT(Number, within(tree, Point3{1, 0, 0}, 0.5, KEPT));
  EXPECT_KEPT(NearestPoint, nearest(tree, Point3{1, 0, 0}, 20, Ties::lowest, KEPT));
  EXPECT_KEPT(NearestPoint, nearest(tree, Point3{1, 0, 0}, 20, Ties::all, KEPT));
  EXPECT_KEPT(Number, cells_along(tree, Ray3{{-9, 0.1, 0.1}, {1, 0, 0}}, WalkedCells::closed, KEPT));
  EXPECT_KEPT(Number, in_box(build_octree(points), region, {}, KEPT));
}

TEST_F(KeptRows, OfListsOfBatches) {
  const KdTree3 tree = build_kd_tree(std::span<const Point3>(ring.vertices));
  const std::span<const Point3> queries(shaken.vertices);
  PointLists lists = within(tree, queries, 0.4, Execution::serial);
  const PointLists expected = lists;
  const auto* const place = lists.numbers.data();
  const auto* const first = lists.first.data();
  lists = within(tree, queries, 0.4, Execution::serial, std::move(lists));
  EXPECT_EQ(lists.numbers.data(), place);
  EXPECT_EQ(lists.first.data(), first);
  EXPECT_EQ(lists, expected);
  const std::vector<Aabb3> regions(20, region);
  auto rows = meeting(mesh, std::span<const Aabb3>(regions), {});
  const auto expected_rows = rows;
  const auto* const inner = rows[7].data();
  rows = meeting(mesh, std::span<const Aabb3>(regions), {}, std::move(rows));
  EXPECT_EQ(rows[7].data(), inner);
  EXPECT_EQ(rows, expected_rows);
}

TEST_F(KeptRows, OfMeshes) {
  const Bvh open = build_bvh(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_KEPT(BorderEdge, border_of(open, KEPT));
  const PosedMesh posed{mesh, pose};
  const PosedCompactMesh posed_compact{compact, pose};
  const auto ask = [&](const char* name, const auto& a, const auto& b) {
    SCOPED_TRACE(name);
    const Point3 p{1, 0.1, 0.1};
    EXPECT_KEPT(TrianglePair, intersecting_pairs(a, b, {}, KEPT));
    EXPECT_KEPT(TrianglePair, intersecting_pairs(a, {}, KEPT));
    const std::vector<TrianglePair> pairs = intersecting_pairs(a, b);
    EXPECT_KEPT(Intersection3, intersections(a, b, pairs, {}, KEPT));
    EXPECT_KEPT(NearTriangle, nearest_triangles(a, p, 30, KEPT));
    EXPECT_KEPT(NearTriangle, triangles_within(a, p, 0.6, KEPT));
    EXPECT_KEPT(Number, meeting(a, Sphere3{p, 0.5}, KEPT));
    EXPECT_KEPT(NumberedHit, hits(a, Ray3{{-9, 0.01, 0.02}, {1, 0, 0}}, HitRule::closed, KEPT));
  };
  ask("mesh", mesh, other);
  ask("compact", compact, compact_other);
  ask("posed", posed, PosedMesh{other, at_rest});
  ask("posed compact", posed_compact, PosedCompactMesh{compact_other, at_rest});
  const BspTree solids = build_bsp(ring);
  EXPECT_KEPT(Number, leaves_at(solids, ring.vertices[0], KEPT));
  EXPECT_KEPT(ExactPoint3, solids.corners_of(0, KEPT));
  const TriangleBatch batch = triangle_batch(ring);
  EXPECT_KEPT(Number, all_hits(Ray3{{-9, 0.01, 0.02}, {1, 0, 0}}, batch, HitRule::closed, KEPT));
}

// Whoever adds a function that returns rows lets them be given back.
TEST(KeptRowsOfHeaders, AreTakenByEveryFunctionThatReturnsThem) {
  const std::set<std::string> others{"insert",         // handles, once for each box
                                     "writable",       // no answer: what a mesh keeps
                                     "cells_meeting",  // of a grid, for those who walk it
                                     "found"};
  const std::regex declaration(
      R"(\n *(?:\[\[nodiscard\]\] )?(?:requires[^\n]*\) )?(?:std::vector<[A-Za-z:_<>0-9]+>|PointLists|FigureLists) (\w+)\(([^;]*)\)(?: const)?;)");
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PLUMB_SOURCE_DIR "/include/plumb/space")) {
    if (entry.path().extension() != ".hpp" || entry.path().string().find("/detail/") != std::string::npos) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (auto at = std::sregex_iterator(text.begin(), text.end(), declaration); at != std::sregex_iterator(); ++at) {
      const std::string name = (*at)[1], parameters = (*at)[2];
      if (others.contains(name)) continue;
      ++seen;
      EXPECT_TRUE(parameters.find(" rows = {}") != parameters.npos || parameters.find(" lists = {}") != parameters.npos)
          << entry.path() << ": " << name << " returns rows and takes none";
    }
  }
  EXPECT_GE(seen, 80U);
}

}  // namespace
}  // namespace plumb

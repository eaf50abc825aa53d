// Are the pairs of compact trees those that every triangle asked against every other gives, and those of the trees that
// they are made of, where they stand and moved, on one thread and on two?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;
using Pairs = std::vector<TrianglePair>;

Triangle3 at(const TriangleMesh& mesh, std::size_t i) { return posed_triangle(mesh, i, identity_pose).shape; }

Pairs by_brute_force(const TriangleMesh& a, const TriangleMesh& b) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
      const Relation relation = relate(at(a, i), at(b, k));
      if (relation != Relation::disjoint) pairs.push_back({i, k, relation});
    }
  }
  return pairs;
}

Pairs by_brute_force(const TriangleMesh& mesh) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::uint32_t k = i + 1; k < mesh.triangles.size(); ++k) {
      const Relation relation = relate_in_mesh(mesh.vertices, mesh.triangles[i], mesh.triangles[k]);
      if (relation != Relation::disjoint) pairs.push_back({i, k, relation});
    }
  }
  return pairs;
}

Pairs by_brute_force(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b, const Pose& pose_b) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
      const Relation relation = query::relate(posed_triangle(a, i, pose_a), posed_triangle(b, k, pose_b));
      if (relation != Relation::disjoint) pairs.push_back({i, k, relation});
    }
  }
  return pairs;
}

Pairs overlapping(Pairs pairs) {
  std::erase_if(pairs, [](const TrianglePair& p) { return p.relation != Relation::overlapping; });
  return pairs;
}
PairCount counted(const Pairs& pairs) {
  const std::size_t n = overlapping(pairs).size();
  return {pairs.size() - n, n};
}

/// All answers about two meshes, or about one where there is no second, moved or not.
template <class Mesh>
void expect_pairs(const Mesh& a, const Mesh* b, const Pairs& expected, const std::string& about) {
  const auto all = [&](const PairOptions& o) { return b ? intersecting_pairs(a, *b, o) : intersecting_pairs(a, o); };
  const auto count = [&](const PairOptions& o) {
    return b ? count_intersecting_pairs(a, *b, o) : count_intersecting_pairs(a, o);
  };
  const auto any = [&](const PairOptions& o) {
    return b ? any_intersecting_pair(a, *b, o) : any_intersecting_pair(a, o);
  };
  ASSERT_EQ(all({.execution = Execution::serial}), expected) << about;
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(all({}), expected) << about;
    EXPECT_EQ(all({.touching = false}), overlapping(expected)) << about;
    EXPECT_EQ(count({}), counted(expected)) << about;
    EXPECT_EQ(count({.touching = false}), counted(overlapping(expected))) << about;
  }
  for (const bool touching : {true, false}) {
    const Pairs from = touching ? expected : overlapping(expected);
    const auto found = any({.touching = touching});
    ASSERT_EQ(found.has_value(), !from.empty()) << about;
    if (found) {
      EXPECT_THAT(from, ::testing::Contains(*found)) << about;
    }
  }
}

BvhOptions any_leaves(Material& m) {
  return {.method = bvh_methods[m.below(bvh_methods.size())],
          .most_in_leaf = static_cast<std::uint32_t>(1 + m.below(9))};
}

TEST(CompactPairs, AreThoseOfEachTriangleAgainstEach) {
  std::size_t touching = 0, overlap = 0;
  shape_cases::on_shapes(961, battery::fitting(100), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(30), m.below(40));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(30), m.below(40));
    const CompactBvh a = build_compact_bvh(mesh_a, any_leaves(m)), b = build_compact_bvh(mesh_b, any_leaves(m));
    const Pairs expected = by_brute_force(mesh_a, mesh_b);
    expect_pairs(a, &b, expected, m.about());
    touching += counted(expected).touching, overlap += counted(expected).overlapping;
    const Pairs own = by_brute_force(mesh_a);
    expect_pairs<CompactBvh>(a, nullptr, own, m.about());
    const Bvh whole_a = build_bvh(mesh_a), whole_b = build_bvh(mesh_b);
    EXPECT_EQ(intersections(a, b, expected), intersections(whole_a, whole_b, expected)) << m.about();
  });
  EXPECT_GT(touching, battery::fitting(400u));
  EXPECT_GT(overlap, battery::fitting(400u));
}

TEST(CompactPairs, AreThoseOfMovedTriangles) {
  std::size_t found = 0;
  shape_cases::on_shapes(962, battery::fitting(60), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(20), m.below(20));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(20), m.below(20));
    const Pose pose_a = any_pose(m), pose_b = pose_like(m, pose_a);
    const Bvh whole_a = build_bvh(mesh_a, any_leaves(m)), whole_b = build_bvh(mesh_b, any_leaves(m));
    const CompactBvh small_a = compact(whole_a), small_b = compact(whole_b);
    const PosedCompactMesh a{small_a, pose_a}, b{small_b, pose_b};
    const Pairs expected = by_brute_force(mesh_a, pose_a, mesh_b, pose_b);
    expect_pairs(a, &b, expected, m.about());
    expect_pairs<PosedCompactMesh>(a, nullptr, intersecting_pairs(PosedMesh{whole_a, pose_a}), m.about());
    EXPECT_EQ(intersections(a, b, expected), intersections({whole_a, pose_a}, {whole_b, pose_b}, expected));
    found += expected.size();
  });
  EXPECT_GT(found, battery::fitting(150u));
}

// Trees of many levels, leaves that were divided, and boxes on all grids.
TEST(CompactPairs, OfDegenerateMeshesAreThoseOfTheTree) {
  std::vector<TriangleMesh> meshes{{}, {{{1, 2, 3}}, {}}, meshes::repeated(70), meshes::ring(9)};
  for (const int first : {-1074, -149, 0, 500}) meshes.push_back(meshes::doubling(21, first, 25));
  std::vector<Bvh> whole;
  std::vector<CompactBvh> small;
  for (const TriangleMesh& mesh : meshes) {
    whole.push_back(build_bvh(mesh, {.most_in_leaf = 70}));
    small.push_back(compact(whole.back()));
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    expect_pairs<CompactBvh>(small[i], nullptr, intersecting_pairs(whole[i]), std::to_string(i));
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      const Pairs expected = intersecting_pairs(whole[i], whole[k]);
      found += expected.size();
      expect_pairs(small[i], &small[k], expected, std::to_string(i) + " " + std::to_string(k));
    }
  }
  EXPECT_GT(found, 70u * 70u);
}

// A triangle in several slots is named once.
TEST(CompactPairs, OfSplitTrianglesAreNamedOnce) {
  TriangleMesh fan;
  for (std::uint32_t i = 0; i < 40; ++i) {
    fan.vertices.insert(fan.vertices.end(), {{0, 0.5 * i, 0}, {90, 90 + 0.5 * i, 90}, {0, 0.5 * i + 0.25, 0}});
    fan.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const TriangleMesh across{{{45, -100, 0}, {45, 300, 0}, {45, 100, 300}, {46, 0, 0}}, {{0, 1, 2}, {1, 3, 2}}};
  const CompactBvh parts = build_compact_bvh(fan, {.split_share = 2}), b = build_compact_bvh(across);
  EXPECT_GT(parts.slots(), 60u);
  expect_pairs(parts, &b, by_brute_force(fan, across), "split");
  expect_pairs<CompactBvh>(parts, nullptr, by_brute_force(fan), "split");
  const Pose turn{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {30, 0, 0}};
  const PosedCompactMesh turned{parts, turn}, still{b};
  const Pairs expected = by_brute_force(fan, turn, across, identity_pose);
  EXPECT_GT(expected.size(), 5u);
  expect_pairs(turned, &still, expected, "split and turned");
}

TEST(CompactPairs, OfLeavesAreVisitedOnceByEveryRule) {
  const CompactBvh a = build_compact_bvh(meshes::ring(8)), b = build_compact_bvh(meshes::ring(11));
  ASSERT_EQ(a.tree.frame, b.tree.frame);
  const auto meets = [](const BoxNode& x, const BoxNode& y) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(x.min[k] <= y.max[k] && y.min[k] <= x.max[k])) return false;
    }
    return true;
  };
  using Leaves = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const auto by = [&](const auto& rule) {
    Leaves found;
    descend_pairs(a.tree, b.tree, rule, meets,
                  [&](const BoxNode& x, const BoxNode& y) { found.emplace_back(x.link, y.link); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    return found;
  };
  // Each leaf with the boxes on the way to it, all of which must meet.
  const Leaves larger = by(descend_larger{});
  std::size_t leaves = 0;
  const auto every = [&](const auto& small, const auto& take) {
    descend(
        small.tree, [](const BoxNode&) { return true; }, take);
  };
  every(a, [&](std::uint32_t, std::uint32_t) { ++leaves; });
  EXPECT_GT(larger.size(), leaves);
  Leaves all_first;
  descend_pairs(
      a.tree, b.tree, descend_first{}, [](const BoxNode&, const BoxNode&) { return true; },
      [&](const BoxNode& x, const BoxNode& y) { all_first.emplace_back(x.link, y.link); });
  std::size_t leaves_b = 0;
  every(b, [&](std::uint32_t, std::uint32_t) { ++leaves_b; });
  EXPECT_EQ(all_first.size(), leaves * leaves_b);
  std::size_t mixed = 0;  // with a binary tree
  const Bvh whole = build_bvh(meshes::ring(11));
  descend_pairs(
      a.tree, whole.tree, descend_both{}, [](const BoxNode&, const BoxNode&) { return true; },
      [&](const BoxNode&, const BoxNode&) { ++mixed; });
  EXPECT_EQ(mixed, leaves * cost_of(whole.tree).leaves);
  Leaves own;
  descend_own_pairs(
      a.tree, [](const BoxNode&, const BoxNode&) { return true; },
      [&](const BoxNode& x, const BoxNode& y) {
        own.emplace_back(std::min(x.link, y.link), std::max(x.link, y.link));
      });
  std::sort(own.begin(), own.end());
  EXPECT_EQ(own.size(), leaves * (leaves + 1) / 2);
  EXPECT_EQ(std::adjacent_find(own.begin(), own.end()), own.end());
}

TEST(CompactPairs, NameWhatIsWrong) {
  const CompactBvh a = build_compact_bvh(meshes::repeated(3));
  const Pairs pairs{{0, 3, Relation::overlapping}};
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)intersections(a, a, pairs); }),
              ::testing::HasSubstr("pairs[0].b is 3"));
  Pose bad = identity_pose;
  bad.translation.x = std::nan("");
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)intersecting_pairs(a, {a, bad});
              }),
              ::testing::HasSubstr("intersecting_pairs: b.pose.translation.x is nan"));
}

TEST(CompactPairs, OfTheModelsAreThoseOfTheTree) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  for (const char* name : {"fandisk.obj", "suzanne.obj"}) {
    const TriangleMesh mesh = read_mesh(folder / name);
    const Bvh whole = build_bvh(mesh);
    const CompactBvh small = compact(whole);
    const Aabb3 box = fit_aabb(mesh.vertices);
    const Pose turn{{{{0.96, 0.28, 0}, {-0.28, 0.96, 0}, {0, 0, 1}}}, {(box.max.x - box.min.x) / 8, 0, 0}};
    EXPECT_EQ(count_intersecting_pairs(small), count_intersecting_pairs(whole));
    const Pairs pairs = intersecting_pairs(PosedMesh{whole, turn}, whole);
    EXPECT_GT(pairs.size(), 100u);
    EXPECT_EQ(intersecting_pairs(PosedCompactMesh{small, turn}, small), pairs);
  }
}

}  // namespace
}  // namespace plumb

// Are the pairs those that every triangle asked against every other gives, on one thread and on two?
#include "plumb/space/pairs/mesh_pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/meetings.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using Pairs = std::vector<TrianglePair>;

Triangle3 at(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

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

Pairs overlapping(Pairs pairs) {
  std::erase_if(pairs, [](const TrianglePair& p) { return p.relation != Relation::overlapping; });
  return pairs;
}

PairCount counted(const Pairs& pairs) {
  const std::size_t n = overlapping(pairs).size();
  return {pairs.size() - n, n};
}

/// All answers about two meshes, or one, against these pairs; on one thread, on two and on however many.
void expect_pairs(const Bvh& a, const Bvh* b, const Pairs& expected, const std::string& about) {
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
      EXPECT_EQ(any({.touching = touching}), found) << about;
    }
  }
}

TEST(IntersectingPairs, AreThoseOfEachTriangleAgainstEach) {
  std::size_t touching = 0, overlap = 0, shapes = 0;
  const auto sets = batch_instruction_sets();
  shape_cases::on_shapes(941, battery::fitting(200), [&](shape_cases::Material& m) {
    certify::batch::take_instruction_set(sets[shapes++ % sets.size()]);
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(30), m.below(40));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(30), m.below(40));
    const Bvh a = build_bvh(mesh_a, {.most_in_leaf = 1}),
              b = build_bvh(mesh_b, {.most_in_leaf = m.below(2) ? 4u : 40u});
    const Pairs expected = by_brute_force(mesh_a, mesh_b);
    expect_pairs(a, &b, expected, m.about());
    touching += counted(expected).touching, overlap += counted(expected).overlapping;
    Pairs turned;
    for (const auto& [i, k, relation] : intersecting_pairs(b, a)) turned.push_back({k, i, relation});
    EXPECT_THAT(turned, ::testing::UnorderedElementsAreArray(expected));
  });
  certify::batch::take_instruction_set({});
  EXPECT_GT(touching, battery::fitting(1000u));
  EXPECT_GT(overlap, battery::fitting(1000u));
}

TEST(SelfIntersectingPairs, AreThoseOfEachTriangleAgainstEach) {
  std::size_t touching = 0, overlap = 0;
  shape_cases::on_shapes(942, battery::fitting(200), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(30), m.below(50));
    const Pairs expected = by_brute_force(mesh);
    expect_pairs(build_bvh(mesh), nullptr, expected, m.about());
    touching += counted(expected).touching, overlap += counted(expected).overlapping;
  });
  EXPECT_GT(touching, battery::fitting(500u));
  EXPECT_GT(overlap, battery::fitting(500u));
}

/// On the lattice of 1 / 16, so that sums of its numbers are doubles.
TriangleMesh lattice_ring(std::uint32_t n) {
  TriangleMesh mesh = meshes::ring(n);
  for (Point3& p : mesh.vertices) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::round(*x * 16) / 16;
  }
  return mesh;
}

TEST(IntersectingPairs, OfAMeshMovedByALatticeStepByNothingAndMirrored) {
  const TriangleMesh mesh = lattice_ring(7);
  std::size_t touching = 0;
  const Bvh bvh = build_bvh(mesh);
  const auto check = [&](const auto& moved_point, const char* about) {
    TriangleMesh moved = mesh;
    for (Point3& p : moved.vertices) p = moved_point(p);
    const Bvh other = build_bvh(moved, {.method = BvhMethod::linear});
    const Pairs expected = by_brute_force(mesh, moved);
    EXPECT_GT(counted(expected).overlapping, 100u) << about;
    touching += counted(expected).touching;
    expect_pairs(bvh, &other, expected, about);
  };
  check([](Point3 p) { return p; }, "by nothing");
  check([](Point3 p) { return Point3{p.x + 0x1p-4, p.y, p.z}; }, "by a lattice step");
  check([](Point3 p) { return Point3{p.x + 0x1p-4, p.y - 0x1p-4, p.z + 0x1p-4}; }, "by a step along the diagonal");
  check([](Point3 p) { return Point3{-p.x, p.y, p.z}; }, "mirrored");
  check([](Point3 p) { return Point3{p.y, p.x, p.z}; }, "mirrored at a diagonal plane");
  EXPECT_GT(touching, 2000u);
  expect_pairs(bvh, nullptr, by_brute_force(mesh), "itself");
}

TEST(IntersectingPairs, AgreeWithCgal) {
  std::size_t asked = 0;
  shape_cases::on_shapes(943, 40, [&](shape_cases::Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 10, 12), mesh_b = meshes::soup(m, 10, 12);
    const Pairs pairs = intersecting_pairs(build_bvh(mesh_a), build_bvh(mesh_b));
    for (std::uint32_t i = 0; i < mesh_a.triangles.size(); ++i) {
      for (std::uint32_t k = 0; k < mesh_b.triangles.size(); ++k) {
        const auto meet = oracle::meet_by_cgal(at(mesh_a, i), at(mesh_b, k));
        if (!meet) continue;
        ++asked;
        const bool found = std::ranges::any_of(pairs, [&](const TrianglePair& p) { return p.a == i && p.b == k; });
        EXPECT_EQ(found, *meet) << m.about(at(mesh_a, i), at(mesh_b, k));
      }
    }
  });
  EXPECT_GT(asked, 1000u);
}

// A closed surface without self-intersections has none, whatever its angles; a wavy ring of many triangles.
TEST(SelfIntersectingPairs, OfACleanSurfaceAreNone) {
  const Bvh bvh = build_bvh(meshes::ring(60));
  EXPECT_EQ(intersecting_pairs(bvh), Pairs{});
  EXPECT_EQ(any_intersecting_pair(bvh), std::nullopt);
}

TEST(IntersectingPairs, OfTreesInOtherFrames) {
  const TriangleMesh near = meshes::ring(5);
  TriangleMesh far = near;
  for (Point3& p : far.vertices) p = {p.x * 0x1p-30 + 1.4, p.y * 0x1p-30, p.z * 0x1p-30};
  far.vertices.push_back({0x1p300, 0, 0});  // of no triangle
  const Bvh a = build_bvh(near), b = build_bvh(far);
  ASSERT_FALSE(a.tree.frame == b.tree.frame);
  const Pairs expected = by_brute_force(near, far);
  EXPECT_GT(expected.size(), 0u);
  expect_pairs(a, &b, expected, "frames");
}

TEST(IntersectingPairs, OfNothingAreNone) {
  const Bvh none = build_bvh(TriangleMesh{}), some = build_bvh(meshes::ring(3));
  expect_pairs(none, &none, {}, "none");
  expect_pairs(none, &some, {}, "none and some");
  expect_pairs(some, &none, {}, "some and none");
  expect_pairs(none, nullptr, {}, "none itself");
}

TEST(Intersections, AreWhatEachPairHasInCommon) {
  const TriangleMesh mesh = lattice_ring(4);
  TriangleMesh moved = mesh;
  for (Point3& p : moved.vertices) p.x += 0x1p-4;
  const Bvh a = build_bvh(mesh), b = build_bvh(moved);
  const Pairs pairs = intersecting_pairs(a, b);
  const std::vector<Intersection3> common = intersections(a, b, pairs);
  ASSERT_EQ(common.size(), pairs.size());
  std::size_t segments = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_FALSE(common[i].empty());
    EXPECT_EQ(common[i], intersection(at(mesh, pairs[i].a), at(moved, pairs[i].b)));
    segments += common[i].kind == IntersectionKind::segment ? 1 : 0;
  }
  EXPECT_GT(segments, 20u);
  const auto beyond = [&] { (void)intersections(a, b, std::vector<TrianglePair>{{0, 64, Relation::touching}}); };
  EXPECT_THAT(text_of<InvalidShape>(beyond), ::testing::HasSubstr("pairs[0].b is 64, but there are 64 triangles"));
}

TEST(IntersectingPairs, SayHowFarTheyAreAndStop) {
  const Bvh bvh = build_bvh(lattice_ring(20));
  const Pairs expected = intersecting_pairs(bvh, bvh);
  for (const Execution execution : {Execution::serial, Execution::parallel}) {
    double last = 0;
    std::size_t calls = 0;
    const auto watched = intersecting_pairs(bvh, bvh, {.execution = execution, .progress = [&](double share) {
                                                         EXPECT_GE(share, last);
                                                         last = share;
                                                         ++calls;
                                                         return true;
                                                       }});
    EXPECT_EQ(watched, expected);
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls, 100u);
    calls = 0;
    const auto stopped = [&] {
      (void)intersecting_pairs(bvh, {.execution = execution, .progress = [&](double) { return ++calls < 3; }});
    };
    EXPECT_THAT(text_of<Cancelled>(stopped), ::testing::HasSubstr("intersecting_pairs: cancelled"));
    EXPECT_EQ(calls, 3u);
  }
}

}  // namespace
}  // namespace plumb

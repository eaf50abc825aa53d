// Are the pairs of moved meshes those of the exactly moved triangles?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "arith/rational_lp.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"

namespace plumb {
namespace {

using namespace poses;
using Pairs = std::vector<TrianglePair>;

/// Points of both that weights give: of all that are not negative, or positive.
Relation relation_by_weights(const Posed<Triangle3>& a, const Posed<Triangle3>& b) {
  std::array<RationalPoint, 6> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = image(std::array{a.shape.a, a.shape.b, a.shape.c}[i], a.pose);
    p[3 + i] = image(std::array{b.shape.a, b.shape.b, b.shape.c}[i], b.pose);
  }
  // The last weight of each triangle is what the others leave of one.
  arith::Constraints all;
  for (std::size_t i = 0; i < 4; ++i) {
    arith::RationalVector row(4);
    row[i] = -1;
    all.add(row, 0);
  }
  all.add({1, 1, 0, 0}, 1);
  all.add({0, 0, 1, 1}, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    arith::RationalVector row{p[0][k] - p[2][k], p[1][k] - p[2][k], p[5][k] - p[3][k], p[5][k] - p[4][k]};
    const mpq_class limit = p[5][k] - p[2][k];
    all.add(row, limit);
    for (mpq_class& x : row) x = -x;
    all.add(row, -limit);
  }
  std::vector<bool> strictly(all.rows.size());
  std::fill_n(strictly.begin(), 6, true);
  return static_cast<Relation>(arith::feasible(all, strictly).slack);
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

TEST(PosedTriangles, AreRelatedAsTheirPointsSay) {
  std::array<long, 3> seen{};
  shape_cases::on_shapes(1701, battery::fitting(700), [&](Material& m) {
    const Pose pose = any_pose(m);
    const Posed<Triangle3> a{m.shape<Triangle3>(), pose}, b{m.shape<Triangle3>(), pose_like(m, pose)};
    const Relation relation = query::relate(a, b);
    ++seen[static_cast<std::size_t>(static_cast<int>(relation) + 1)];
    ASSERT_EQ(relation, relation_by_weights(a, b)) << m.about(a, b);
    ASSERT_EQ(relation, query::relate(b, a)) << m.about(a, b);
    const auto exact = [](const Posed<Triangle3>& t) {
      return exact_mesh({{t.shape.a, t.shape.b, t.shape.c}, {{0, 1, 2}}}, t.pose);
    };
    const auto p = exact(a), q = exact(b);
    if (!p || !q) return;
    const auto triangle = [](const TriangleMesh& t) { return Triangle3{t.vertices[0], t.vertices[1], t.vertices[2]}; };
    ASSERT_EQ(relation, relate(triangle(*p), triangle(*q))) << m.about(a, b);
  });
  if (battery::reaches_rare) {
    for (const long n : seen) EXPECT_GT(n, 70);
  }
}

void expect_pairs(const PosedMesh& a, const PosedMesh& b, const Pairs& expected, const std::string& about) {
  ASSERT_EQ(intersecting_pairs(a, b, {.execution = Execution::serial}), expected) << about;
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(intersecting_pairs(a, b), expected) << about;
    EXPECT_EQ(intersecting_pairs(a, b, {.touching = false}), overlapping(expected)) << about;
    EXPECT_EQ(count_intersecting_pairs(a, b), counted(expected)) << about;
  }
  for (const bool touching : {true, false}) {
    const Pairs from = touching ? expected : overlapping(expected);
    const auto found = any_intersecting_pair(a, b, {.touching = touching});
    ASSERT_EQ(found.has_value(), !from.empty()) << about;
    if (found) {
      EXPECT_THAT(from, ::testing::Contains(*found)) << about;
    }
  }
}

TEST(PosedPairs, AreThoseOfEachTriangleAgainstEach) {
  std::size_t touching = 0, overlap = 0;
  shape_cases::on_shapes(1702, battery::fitting(60), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(20), m.below(20));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(20), m.below(20));
    const Pose pose_a = any_pose(m), pose_b = pose_like(m, pose_a);
    const Bvh a = build_bvh(mesh_a, {.most_in_leaf = 1}), b = build_bvh(mesh_b);
    const Pairs expected = by_brute_force(mesh_a, pose_a, mesh_b, pose_b);
    expect_pairs({a, pose_a}, {b, pose_b}, expected, m.about());
    touching += counted(expected).touching, overlap += counted(expected).overlapping;
  });
  if (battery::reaches_rare) {
    EXPECT_GT(touching, 300u);
    EXPECT_GT(overlap, 300u);
  }
}

TEST(PosedPairs, OfOneMeshAreThoseOfTheExactlyPosedOne) {
  std::size_t pairs = 0, singular = 0;
  shape_cases::on_shapes(1703, battery::fitting(600), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(12), m.below(8));
    const Pose pose = integer_pose(m);
    const auto posed = exact_mesh(mesh, pose);
    if (!posed) return;
    Pairs expected;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::uint32_t k = i + 1; k < mesh.triangles.size(); ++k) {
        const Relation relation = relate_in_mesh(posed->vertices, mesh.triangles[i], mesh.triangles[k]);
        if (relation != Relation::disjoint) expected.push_back({i, k, relation});
      }
    }
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = 1 + static_cast<std::uint32_t>(m.below(3))});
    const PosedMesh asked{bvh, pose};
    ASSERT_EQ(intersecting_pairs(asked), expected) << m.about();
    ASSERT_EQ(intersecting_pairs(asked, {.execution = Execution::serial}), expected) << m.about();
    ASSERT_EQ(count_intersecting_pairs(asked), counted(expected)) << m.about();
    ASSERT_EQ(any_intersecting_pair(asked).has_value(), !expected.empty()) << m.about();
    pairs += expected.size();
    singular += expected.size() != intersecting_pairs(bvh).size();
  });
  if (battery::reaches_rare) {
    EXPECT_GT(pairs, 300u);
    EXPECT_GT(singular, 20u);
  }
}

TEST(PosedPairs, HaveInCommonWhatTheExactlyPosedTrianglesHave) {
  std::array<long, 7> kinds{};
  shape_cases::on_shapes(1706, battery::fitting(1000), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(8), m.below(5));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(8), m.below(5));
    const Pose pose_a = integer_pose(m), pose_b = pose_like(m, pose_a);
    const auto posed_a = exact_mesh(mesh_a, pose_a), posed_b = exact_mesh(mesh_b, pose_b);
    if (!posed_a || !posed_b) return;
    const Bvh a = build_bvh(mesh_a), b = build_bvh(mesh_b), there_a = build_bvh(*posed_a),
              there_b = build_bvh(*posed_b);
    Pairs pairs = intersecting_pairs({a, pose_a}, {b, pose_b});
    if (!mesh_a.triangles.empty() && !mesh_b.triangles.empty()) pairs.push_back({0, 0, Relation::disjoint});
    const auto found = intersections({a, pose_a}, {b, pose_b}, pairs);
    const auto expected = intersections(there_a, there_b, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_TRUE(found[i] == expected[i]) << m.about() << " pair " << i;
      ASSERT_EQ(found[i].vertices.size(), expected[i].vertices.size()) << m.about() << " pair " << i;
      for (std::size_t k = 0; k < found[i].vertices.size(); ++k)
        ASSERT_TRUE(found[i].vertices[k] == expected[i].vertices[k]) << m.about() << " pair " << i;
      ++kinds[static_cast<std::size_t>(found[i].kind)];
    }
  });
  if (battery::reaches_rare) {
    for (const auto kind :
         {IntersectionKind::nothing, IntersectionKind::point, IntersectionKind::segment, IntersectionKind::polygon})
      EXPECT_GT(kinds[static_cast<std::size_t>(kind)], 20);
  }
  const Bvh bvh = build_bvh(meshes::repeated(2));
  EXPECT_THROW((void)intersections(PosedMesh(bvh), PosedMesh(bvh), Pairs{{0, 2, Relation::touching}}), InvalidShape);
}

/// A rotation in doubles rounds nothing: what touches along an edge, at a vertex or in a plane goes on touching.
TEST(PosedPairs, UnderOnePoseAreThoseWithoutIt) {
  const TriangleMesh mesh = meshes::ring(10);
  TriangleMesh shifted = mesh;
  for (Point3& p : shifted.vertices) p.z = -p.z;
  const Bvh a = build_bvh(mesh), b = build_bvh(shifted);
  const Pairs expected = intersecting_pairs(a, b), own = intersecting_pairs(a, a);
  EXPECT_GT(counted(own).touching, 1000u);
  shape_cases::on_shapes(1704, battery::fitting(10), [&](Material& m) {
    const Pose pose = turn(m);
    EXPECT_EQ(intersecting_pairs({a, pose}, {b, pose}), expected) << m.about();
    EXPECT_EQ(intersecting_pairs({a, pose}), intersecting_pairs(a)) << m.about();
  });
  // The same pairs by posed triangles alone: the second pose is another, though it moves all points alike.
  shape_cases::on_shapes(1705, battery::fitting(2), [&](Material& m) {
    Pose pose = turn(m);
    TriangleMesh half = mesh;
    for (Point3& p : half.vertices) p = {p.x / 2, p.y / 2, p.z / 2};
    Pose twice = pose;
    for (Vector3& c : twice.columns) c = {2 * c.x, 2 * c.y, 2 * c.z};
    const Bvh halved = build_bvh(half);
    EXPECT_EQ(intersecting_pairs({a, pose}, {halved, twice}), own) << m.about();
  });
}

TEST(PosedPairs, RefusePosesThatAreNone) {
  const Bvh bvh = build_bvh(meshes::repeated(2));
  Pose pose = identity_pose;
  pose.columns[1].z = std::nan("");
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)intersecting_pairs(bvh, {bvh, pose});
            }),
            "intersecting_pairs: b.pose.columns[1].z is nan, not a real number; give a finite double");
  pose = identity_pose;
  pose.translation.y = -INFINITY;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)any_intersecting_pair({bvh, pose});
            }),
            "any_intersecting_pair: mesh.pose.translation.y is -inf, not a real number; give a finite double");
}

}  // namespace
}  // namespace plumb

// Are the pairs that a front finds those of a descent, in every frame and on any number of threads?
#include "plumb/space/coherence/pair_front.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "space/coherence/frames.hpp"

namespace plumb {
namespace {

using namespace frames;
using Pairs = std::vector<TrianglePair>;

/// Of all pairs of nodes that a descent compares.
std::size_t compared_by_descent(const Bvh& a, const Bvh& b) {
  std::size_t n = 0;
  descend_pairs(
      a.tree, b.tree, descend_larger{},
      [&](const BoxNode& p, const BoxNode& q) {
        ++n;
        return p.min[0] <= q.max[0] && q.min[0] <= p.max[0] && p.min[1] <= q.max[1] && q.min[1] <= p.max[1] &&
               p.min[2] <= q.max[2] && q.min[2] <= p.max[2];
      },
      [](const BoxNode&, const BoxNode&) {});
  return n;
}

TEST(PairFront, OfMeshesThatBendIsThatOfADescent) {
  std::size_t pairs = 0, kept = 0;
  shape_cases::on_shapes(1751, battery::fitting(150), [&](Material& m) {
    TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(30), m.below(40));
    TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(30), m.below(40));
    const std::vector<Point3> first_a = mesh_a.vertices, first_b = mesh_b.vertices;
    Bvh a = build_bvh(mesh_a, {.most_in_leaf = 1}), b = build_bvh(mesh_b, {.most_in_leaf = 1});
    PairFront front, serial, own;
    for (int frame = 0; frame < 12; ++frame) {
      const PairOptions options{.touching = m.below(4) != 0};
      const Pairs expected = intersecting_pairs(a, b, options);
      ASSERT_EQ(front.intersecting_pairs(a, b, options), expected) << m.about() << " frame " << frame;
      {
        const ThreadLimit one(1);
        ASSERT_EQ(serial.intersecting_pairs(a, b, options), expected) << m.about() << " frame " << frame;
      }
      ASSERT_EQ(front.size(), serial.size());
      ASSERT_EQ(front.work(), serial.work());
      ASSERT_EQ(own.intersecting_pairs(a, options), intersecting_pairs(a, options)) << m.about() << " frame " << frame;
      pairs += expected.size();
      kept += front.work().from_roots ? 0 : 1;
      if (m.below(3) != 0) refit(a, mesh_a.vertices = next_vertices(m, mesh_a.vertices, first_a));
      if (m.below(3) != 0) refit(b, mesh_b.vertices = next_vertices(m, mesh_b.vertices, first_b));
      if (m.below(6) == 0) rebuild_parts(a, 1);  // divided otherwise from now on
      if (m.below(12) == 0) b = build_bvh(mesh_b, {.method = BvhMethod::linear});
    }
  });
  if (battery::reaches_rare) {
    EXPECT_GT(pairs, 5000u);
    EXPECT_GT(kept, 300u);
  }
}

TEST(PairFront, OfPosedMeshesIsThatOfADescent) {
  std::size_t pairs = 0, kept = 0, own_pairs = 0, own_kept = 0;
  shape_cases::on_shapes(1752, battery::fitting(45), [&](Material& m) {
    const TriangleMesh mesh_a = meshes::soup(m, 1 + m.below(20), m.below(25));
    const TriangleMesh mesh_b = meshes::soup(m, 1 + m.below(20), m.below(25));
    const Bvh a = build_bvh(mesh_a, {.most_in_leaf = 1}), b = build_bvh(mesh_b, {.most_in_leaf = 1});
    Pose pose_a = identity_pose, pose_b = identity_pose;
    PairFront front, serial, own;
    for (int frame = 0; frame < 10; ++frame) {
      const Pairs expected = intersecting_pairs({a, pose_a}, {b, pose_b});
      ASSERT_EQ(front.intersecting_pairs({a, pose_a}, {b, pose_b}), expected) << m.about() << " frame " << frame;
      ASSERT_EQ(serial.intersecting_pairs({a, pose_a}, {b, pose_b}, {.execution = Execution::serial}), expected)
          << m.about() << " frame " << frame;
      ASSERT_EQ(front.work(), serial.work());
      pairs += expected.size();
      kept += front.work().from_roots ? 0 : 1;
      Pose flat = pose_a;  // as a shadow, as a rule: else it is the question without a pose
      if (m.below(4) != 0) flat.columns[m.below(3)] = {0, 0, 0};
      const Pairs of_one = intersecting_pairs({a, flat});
      ASSERT_EQ(own.intersecting_pairs({a, flat}), of_one) << m.about() << " frame " << frame;
      own_pairs += of_one.size();
      own_kept += own.work().from_roots ? 0 : 1;
      pose_a = next_pose(m, pose_a);
      if (m.below(3) == 0) pose_b = m.below(2) == 0 ? pose_a : next_pose(m, pose_b);
    }
  });
  if (battery::reaches_rare) {
    EXPECT_GT(pairs, 1000u);
    EXPECT_GT(kept, 100u);
    EXPECT_GT(own_pairs, 1000u);
    EXPECT_GT(own_kept, 100u);
  }
}

/// A mesh that turns, and its shadow on a plane: less is posed and compared than by a descent.
TEST(PairFront, OfAShadowIsKept) {
  const Bvh mesh = build_bvh(meshes::ring(battery::sanitized ? 4 : 6));
  PairFront own, begun;
  std::size_t kept = 0;
  for (int frame = 0; frame < 5; ++frame) {
    const double tilt = frame * 0x1p-8;
    const PosedMesh shadow{mesh, {{{{1, 0, 0}, {tilt, 1, 0}, {0, tilt, 0}}}, {0.25, 0, 0}}};
    const Pairs expected = intersecting_pairs(shadow);
    begun.forget();
    ASSERT_EQ(begun.intersecting_pairs(shadow), expected) << frame;
    ASSERT_EQ(own.intersecting_pairs(shadow), expected) << frame;
    EXPECT_FALSE(expected.empty());
    if (own.work().from_roots) continue;
    ++kept;
    EXPECT_LT(own.work().comparisons, begun.work().comparisons) << frame;
  }
  EXPECT_GE(kept, 3u);
}

/// Through one another in small steps, there and back, with leaps: less is compared than by a descent.
TEST(PairFront, FollowsMeshesThatPass) {
  const TriangleMesh mesh = meshes::ring(battery::sanitized ? 8 : 24);
  const Bvh still = build_bvh(mesh);
  Bvh moving = still;
  PairFront front, posed_front;
  std::size_t by_front = 0, by_descent = 0, begun = 0;
  const int steps = 60;
  for (int frame = 0; frame <= 2 * steps; ++frame) {
    const int at = frame == steps / 2 ? 3 : frame <= steps ? frame : 2 * steps - frame;
    const double x = 0.75 + at * 0x1p-7;
    refit(moving, moved(mesh, x, 0.25).vertices);
    const Pairs expected = intersecting_pairs(moving, still);
    ASSERT_EQ(front.intersecting_pairs(moving, still), expected) << frame;
    const Pose pose{identity_pose.columns, {x, 0.25, 0}};
    if (frame % 10 < 2) {
      const Pairs posed = intersecting_pairs({still, pose}, still);
      ASSERT_EQ(posed_front.intersecting_pairs({still, pose}, still), posed) << frame;
    }
    by_front += front.work().comparisons;
    by_descent += compared_by_descent(moving, still);
    begun += front.work().from_roots ? 1 : 0;
  }
  EXPECT_GE(begun, 1u);
  EXPECT_LT(begun, 12u);
  if (battery::reaches_rare) {
    EXPECT_LT(by_front, by_descent * 3 / 4);
  }
  EXPECT_GT(front.memory(), 8 * front.size());
}

/// Of exact ties: a lattice against itself, moved by steps of the lattice.
TEST(PairFront, OfLatticesThatTouch) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 9 * 9; ++i) mesh.vertices.push_back({1.0 * (i % 9), 1.0 * (i / 9), 0});
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      mesh.triangles.push_back({9 * y + x, 9 * y + x + 1, 9 * y + x + 10});
      mesh.triangles.push_back({9 * y + x, 9 * y + x + 10, 9 * y + x + 9});
    }
  }
  const Bvh still = build_bvh(mesh, {.most_in_leaf = 1});
  Bvh moving = still;
  PairFront front, own;
  std::size_t touching = 0;
  for (int frame = 0; frame < 24; ++frame) {
    const double x = frame <= 12 ? frame : 24 - frame;
    refit(moving, moved(mesh, x, frame % 5 == 0 ? 9 : frame % 3).vertices);
    const Pairs expected = intersecting_pairs(moving, still);
    ASSERT_EQ(front.intersecting_pairs(moving, still), expected) << frame;
    ASSERT_EQ(own.intersecting_pairs(moving), intersecting_pairs(moving)) << frame;
    for (const TrianglePair& p : expected) touching += p.relation == Relation::touching ? 1 : 0;
  }
  EXPECT_GT(touching, 500u);
}

/// One front is asked about everything: what it remembers is checked.
TEST(PairFront, IsAskedAboutOtherMeshesAndNone) {
  const Bvh empty = build_bvh(TriangleMesh{}), one = build_bvh(meshes::repeated(1)),
            many = build_bvh(meshes::repeated(9)), ring = build_bvh(meshes::ring(6)),
            far = build_bvh(moved(meshes::ring(6), 0x1p60, 0)), huge = build_bvh(meshes::doubling(20, -900, 90));
  const std::vector<const Bvh*> all{&empty, &one, &many, &ring, &far, &huge};
  PairFront front;
  EXPECT_EQ(front.size(), 0u);
  for (int round = 0; round < 2; ++round) {
    for (const Bvh* a : all) {
      for (const Bvh* b : all) {
        ASSERT_EQ(front.intersecting_pairs(*a, *b), intersecting_pairs(*a, *b));
        const Pose pose{identity_pose.columns, {0.5, 0, 0}};
        ASSERT_EQ(front.intersecting_pairs({*a, pose}, *b), intersecting_pairs({*a, pose}, *b));
        ASSERT_EQ(front.intersecting_pairs(*b), intersecting_pairs(*b));
      }
    }
  }
  front.forget();
  EXPECT_EQ(front.size(), 0u);
  EXPECT_EQ(front.memory(), 0u);
}

TEST(PairFront, StaysTrueWhereItIsCancelled) {
  const TriangleMesh mesh = meshes::ring(10);
  const Bvh still = build_bvh(mesh);
  Bvh moving = still;
  PairFront front;
  const PairOptions cancelled{.progress = [](double) { return false; }};
  EXPECT_EQ(text_of<Cancelled>([&] { (void)front.intersecting_pairs(moving, still, cancelled); }),
            "intersecting_pairs: cancelled by its progress function");
  for (int frame = 0; frame < 5; ++frame) {
    refit(moving, moved(mesh, frame * 0.125, 0).vertices);
    EXPECT_THROW((void)front.intersecting_pairs(moving, still, cancelled), Cancelled);
    EXPECT_EQ(front.intersecting_pairs(moving, still), intersecting_pairs(moving, still)) << frame;
  }
  Pose pose = identity_pose;
  pose.translation.x = NAN;
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)front.intersecting_pairs(still, {still, pose});
            }),
            "intersecting_pairs: b.pose.translation.x is nan, not a real number; give a finite double");
}

}  // namespace
}  // namespace plumb

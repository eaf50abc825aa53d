// Are the answers of trees the same by every instruction set that this machine has, on one thread and on several?
//
// Taken from set to set are what asks boxes and triangles in lanes: rays, pairs, compact trees, and boxes and closest
// points of batches. The rest, trees of volumes but for the pairs, poses, motion, Hausdorff, closest points and ranges of
// a Bvh, is compiled once: it is equal by being the same code, and is asked so that it stays so.  Of single triangles
// some filters take fused products where the processor has them, from the start of a process on: tests/CMakeLists.txt
// runs others by PLUMB_INSTRUCTION_SET.
#include <gtest/gtest.h>

#include "certify/batch/take_instruction_set.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

constexpr Pose quarter_turn{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {0.125, 0.25, 0}};

class EveryInstructionSet : public ::testing::Test {
 protected:
  ~EveryInstructionSet() override { certify::batch::take_instruction_set({}); }

  /// ask(execution) by every set against the first, which is on one thread.
  template <class Ask>
  static auto same(const char* about, const Ask& ask) {
    const auto sets = batch_instruction_sets();
    certify::batch::take_instruction_set(sets.front());
    const auto first = ask(Execution::serial);
    for (const std::string_view set : sets) {
      certify::batch::take_instruction_set(set);
      EXPECT_TRUE(ask(Execution::parallel) == first) << about << " by " << set;
    }
    return first;
  }

  static TriangleMesh moved(TriangleMesh mesh) {
    for (Point3& p : mesh.vertices) p = {p.x + 0.125, 0.75 * p.y - 0.5 * p.z, 0.5 * p.y + 0.75 * p.z};
    return mesh;
  }
  static std::vector<Point3> points() {
    std::vector<Point3> all;
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy e(971, i);
      const auto any = [&] { return static_cast<double>(e.within(1000)) / 500; };
      all.push_back({any(), any(), any()});
    }
    return all;
  }

  const TriangleMesh mesh_ = meshes::ring(9), other_ = moved(mesh_);
  const Bvh a_ = build_bvh(mesh_), b_ = build_bvh(other_);
  const Bvh split_ = build_bvh(mesh_, {.split_share = 0.5});
  const CompactBvh small_ = compact(a_);
};

TEST_F(EveryInstructionSet, FindsTheSamePairs) {
  const auto pairs = same("pairs", [&](Execution e) { return intersecting_pairs(a_, b_, {.execution = e}); });
  EXPECT_GT(pairs.size(), 20u);
  const auto with_itself = same("itself", [&](Execution e) { return intersecting_pairs(a_, a_, {.execution = e}); });
  EXPECT_GT(with_itself.size(), 12 * mesh_.triangles.size());
  EXPECT_EQ(same("split", [&](Execution e) { return intersecting_pairs(split_, b_, {.execution = e}); }), pairs);
  TriangleMesh both = mesh_;
  for (const auto& [i, k, l] : other_.triangles) {
    const auto n = static_cast<std::uint32_t>(mesh_.vertices.size());
    both.triangles.push_back({n + i, n + k, n + l});
  }
  both.vertices.insert(both.vertices.end(), other_.vertices.begin(), other_.vertices.end());
  const Bvh of_both = build_bvh(both);
  const auto own = same("own", [&](Execution e) { return intersecting_pairs(of_both, {.execution = e}); });
  EXPECT_EQ(own.size(), pairs.size());
  same("count", [&](Execution e) { return count_intersecting_pairs(a_, b_, {.execution = e}); });
  same("any", [&](Execution) { return any_intersecting_pair(a_, b_); });
  same("common", [&](Execution e) { return intersections(a_, b_, pairs, {.execution = e}); });
  const PosedMesh turned{b_, quarter_turn};
  same("posed", [&](Execution e) { return intersecting_pairs(PosedMesh{a_}, turned, {.execution = e}); });
  const auto spheres_a = build_volume_tree<Sphere3>(a_), spheres_b = build_volume_tree<Sphere3>(b_);
  const auto by_spheres = same("volumes", [&](Execution e) {
    return intersecting_pairs(VolumeMesh(a_, spheres_a), VolumeMesh(b_, spheres_b), {.execution = e});
  });
  EXPECT_EQ(by_spheres, pairs);
}

TEST_F(EveryInstructionSet, FindsTheSameNearestTriangles) {
  const std::vector<Point3> all = points();
  const auto ask = [&](const auto& mesh) {
    return same("closest", [&](Execution e) {
      std::vector<ClosestOnMesh> closest(all.size());
      closest_on_mesh(mesh, all, closest, {.execution = e});
      std::vector<std::vector<NearTriangle>> near;
      for (const Point3& p : all)
        near.push_back(nearest_triangles(mesh, p, 7)), near.push_back(triangles_within(mesh, p, 0.5));
      return std::pair(closest, near);
    });
  };
  const auto answers = ask(a_);
  EXPECT_TRUE(ask(small_) == answers);
  ask(PosedMesh{a_, quarter_turn});
  const Bvh far = build_bvh(TriangleMesh{{{3, 0, 0}, {3, 1, 0}, {3, 0, 1}, {4, 1, 1}}, {{0, 1, 2}, {1, 2, 3}}});
  same("two meshes", [&](Execution) { return closest_triangles(a_, far); });
  same("hausdorff", [&](Execution e) { return hausdorff_distance(a_, far, {.relative = 0.125, .execution = e}); });
}

TEST_F(EveryInstructionSet, FindsTheSameInRangesAndAlongRays) {
  std::vector<Aabb3> boxes;
  std::vector<Sphere3> balls;
  std::vector<AnyRay> rays;
  for (const Point3& p : points()) {
    boxes.push_back({{p.x - 0.25, p.y - 0.25, p.z - 0.25}, {p.x + 0.25, p.y + 0.5, p.z + 0.25}});
    balls.push_back({p, 0.375});
    rays.emplace_back(Ray3{p, {-p.x, -p.y, -p.z}});
  }
  const auto ask = [&](const auto& mesh) {
    return same("ranges and rays", [&](Execution e) {
      std::vector<std::optional<NumberedHit>> first(rays.size());
      std::vector<std::vector<NumberedHit>> ordered(rays.size());
      std::vector<std::uint8_t> any(rays.size());
      first_hit(mesh, rays, first, {.execution = e});
      hits(mesh, rays, ordered, {.execution = e});
      any_hit(mesh, rays, any, {.execution = e});
      return std::tuple(meeting(mesh, std::span<const Aabb3>(boxes), {.execution = e}),
                        meeting(mesh, std::span<const Sphere3>(balls), {.execution = e}), first, ordered, any);
    });
  };
  const auto answers = ask(a_);
  EXPECT_TRUE(ask(small_) == answers);
  ask(PosedMesh{a_, quarter_turn});
  const auto dops = build_volume_tree<KDop3>(a_, {.k = 14});
  same("volumes", [&](Execution) { return meeting(a_, dops, balls[0]); });
  const std::vector<Point3> all = points();
  same("inside", [&](Execution e) {
    std::vector<Location> where(all.size());
    locate(a_, all, where, e);
    return where;
  });
}

TEST_F(EveryInstructionSet, FindsTheSameContactsInMotion) {
  same("translating", [&](Execution) { return first_contact(a_, {0, 0, 1}, b_); });
  const TriangleMesh small = meshes::ring(4);
  std::vector<Point3> to = small.vertices;
  for (Point3& p : to) p.x = -0.5 * p.x;  // turned inside out
  const MovingMesh moving = build_moving_mesh(small.vertices, to, small.triangles);
  EXPECT_TRUE(same("motion", [&](Execution e) { return first_contact(moving, {.execution = e}); }).has_value());
  same("all in motion", [&](Execution e) { return contacts_in_motion(moving, {.execution = e}); });
}

}  // namespace
}  // namespace plumb

// How long does the distance of two meshes take, standing and under poses?  One thread; beside FCL, which rounds.
//
// Scenes: boxes of 43,200 triangles each, face to face, of which thousands of pairs are equally near; tori of 86,436
// side by side; wavy rings of 16,384 apart; spheres of 43,200, one within the other; a wavy ring of a million and a
// ball of 4,800.  `plumb_first` is asked for the first of equally near pairs, `plumb_within` whether the
// meshes are within half of their distance, `plumb_rigid` under one exact turn, and moved a little, `plumb_posed` and
// `fcl_posed` under one that rounds.  Trees are built beforehand.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#ifdef PLUMB_BENCH_FCL
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "bench/rivals/fcl_meshes.hpp"
#endif

namespace plumb::bench {
namespace {

void add(const std::string& name, std::function<double()> ask) {
  benchmark::RegisterBenchmark(("mesh_distance/" + name).c_str(), [ask = std::move(ask)](benchmark::State& state) {
    double answer = 0;
    for (auto _ : state) benchmark::DoNotOptimize(answer = ask());
    state.counters["answer"] = answer;
  })->Unit(benchmark::kMillisecond);
}

#ifdef PLUMB_BENCH_FCL
double fcl_distance(const FclModel& a, const FclModel& b, const fcl::Transform3d& to_a, const fcl::Transform3d& to_b) {
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(&a, to_a, &b, to_b, request, result);
  return result.min_distance;
}
bool fcl_meet(const FclModel& a, const FclModel& b, const fcl::Transform3d& to_a, const fcl::Transform3d& to_b) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&a, to_a, &b, to_b, request, result) > 0;
}
#endif

/// A box [0, 8]^3 whose faces are lattices of n^2 squares, each two triangles.
TriangleMesh lattice_box(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 8.0}) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
        std::array<double, 3> p{};
        p[axis] = side, p[(axis + 1) % 3] = 8.0 * (i % (n + 1)) / n, p[(axis + 2) % 3] = 8.0 * (i / (n + 1)) / n;
        mesh.vertices.push_back({p[0], p[1], p[2]});
      }
      for (std::uint32_t i = 0; i < n * n; ++i) {
        const std::uint32_t a = first + i / n * (n + 1) + i % n;
        mesh.triangles.push_back({a, a + 1, a + n + 2});
        mesh.triangles.push_back({a, a + n + 2, a + n + 1});
      }
    }
  }
  return mesh;
}

TriangleMesh ball(std::uint32_t across, std::uint32_t around, const Point3& center, double radius) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= across; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double u = std::numbers::pi * i / across, v = 2 * std::numbers::pi * k / around;
      mesh.vertices.push_back({center.x + radius * std::sin(u) * std::cos(v),
                               center.y + radius * std::sin(u) * std::sin(v), center.z + radius * std::cos(u)});
    }
  }
  for (std::uint32_t i = 0; i < across; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

TriangleMesh placed(TriangleMesh mesh, double scale, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {scale * p.x + by.x, scale * p.y + by.y, scale * p.z + by.z};
  return mesh;
}

/// A turn about a slanted axis, rounded.
Pose turned() {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(0.4), t = std::sin(0.4);
  return {{{{c, s * d, s * t}, {-s, c * d, c * t}, {0, -t, d}}}, {0.1, 0.2, 0.3}};
}

void add_scene(const std::string& name, const TriangleMesh& a, const TriangleMesh& b) {
  const auto first = std::make_shared<Bvh>(build_bvh(a)), second = std::make_shared<Bvh>(build_bvh(b));
  const Pose pose = turned();
  add(name + "/plumb", [=] { return closest_triangles(*first, *second)->closest.distance; });
  add(name + "/plumb_first", [=] { return closest_triangles(*first, *second, {.first = true})->closest.distance; });
  const double half = closest_triangles(*first, *second)->closest.distance / 2;
  add(name + "/plumb_within", [=] { return within(*first, *second, half) ? 1.0 : 0.0; });
  const RigidPose rigid{{1, 0.25, -0.125, 0.375}, {0.1, 0.2, 0.3}};
  RigidPose beside = rigid;
  beside.translation.x += 0x1p-7;
  add(name + "/plumb_rigid", [=] { return closest_triangles({*first, rigid}, {*second, beside})->closest.distance; });
  add(name + "/plumb_posed", [=] { return closest_triangles({*first, pose}, {*second, pose})->closest.distance; });
#ifdef PLUMB_BENCH_FCL
  const std::shared_ptr<FclModel> model_a = fcl_model(a), model_b = fcl_model(b);
  const fcl::Transform3d none = fcl::Transform3d::Identity(), by = fcl_transform(pose);
  add(name + "/fcl", [=] { return fcl_distance(*model_a, *model_b, none, none); });
  add(name + "/fcl_posed", [=] { return fcl_distance(*model_a, *model_b, by, by); });
#endif
}

/// Do they meet, five widths apart?
void add_far(std::uint32_t n) {
  const auto mesh = meshes::ring(n);
  const auto bvh = std::make_shared<Bvh>(build_bvh(mesh));
  Pose there = turned();
  there.translation.x += 15;
  const Pose pose = turned(), other = there;
  const std::string name = "far/" + std::to_string(mesh.triangles.size());
  const PairOptions serial{.execution = Execution::serial};
  add(name + "/plumb", [=] { return any_intersecting_pair({*bvh, pose}, {*bvh, other}, serial) ? 1.0 : 0.0; });
#ifdef PLUMB_BENCH_FCL
  const std::shared_ptr<FclModel> model = fcl_model(mesh);
  add(name + "/fcl",
      [=, a = fcl_transform(pose), b = fcl_transform(other)] { return fcl_meet(*model, *model, a, b) ? 1.0 : 0.0; });
#endif
}

const bool added = [] {
  add_scene("boxes", lattice_box(60), placed(lattice_box(60), 1, {0.3, 0.4, 9}));
  add_scene("tori", solids::torus(300, 100, 294, 147), placed(solids::torus(300, 100, 294, 147), 1, {900, 30, 20}));
  add_scene("rings", meshes::ring(64), placed(meshes::ring(64), 1, {4, 1, 0.5}));
  add_scene("spheres", ball(120, 180, {0, 0, 0}, 1), ball(120, 180, {0.02, 0.01, 0.03}, 0.8));
  add_scene("million", placed(meshes::ring(500), 100, {0, 0, 0}), placed(ball(40, 60, {0, 0, 0}, 1), 30, {0, 0, 80}));
  for (const std::uint32_t n : {40u, 130u, 260u}) add_far(n);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

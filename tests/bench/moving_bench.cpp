// How long does it take to find when a mesh that moves along a line first meets another?  One thread.
//
// Boxes with n x n squares on each face come face to face along an axis or askew; the same turned by three times a
// rotation of integers, so that their faces lie askew and still are flat; lifted by a pose; and wavy rings, which meet
// in one place, one of them turned by a pose.  And how near are boxes under poses that lie face to face?
// `s_query` is the time of each answer.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

using Map = std::function<Point3(const Point3&)>;

TriangleMesh mapped(TriangleMesh mesh, const Map& map) {
  for (Point3& p : mesh.vertices) p = map(p);
  return mesh;
}

/// Six squares of 2 n^2 triangles, from 0 to n.
TriangleMesh box(std::uint32_t n) {
  TriangleMesh mesh;
  const double top = n;
  for (int side = 0; side < 6; ++side) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t k = 0; k <= n; ++k) {
        const double u = i, v = k, w = side % 2 == 0 ? 0 : top;
        mesh.vertices.push_back(side < 2 ? Point3{u, v, w} : side < 4 ? Point3{v, w, u} : Point3{w, u, v});
      }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t a = first + (n + 1) * i + k;
        mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, a + n + 2}, {a, a + n + 2, a + n + 1}});
      }
    }
  }
  return mesh;
}

Point3 turned(const Point3& p) { return {2 * p.x - p.y + 2 * p.z, 2 * p.x + 2 * p.y - p.z, -p.x + 2 * p.y + 2 * p.z}; }

void add(const std::string& name, std::function<bool()> ask) {
  benchmark::RegisterBenchmark(("moving/" + name).c_str(), [ask = std::move(ask)](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(ask());
    state.counters["s_query"] = benchmark::Counter(static_cast<double>(state.iterations()),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMicrosecond);
}
void add(const std::string& name, const TriangleMesh& a, const Vector3& by, const TriangleMesh& b) {
  const auto tree_a = std::make_shared<Bvh>(build_bvh(a)), tree_b = std::make_shared<Bvh>(build_bvh(b));
  add(name, [=] { return first_contact(*tree_a, by, *tree_b).has_value(); });
}
void add_posed(const std::string& name, const TriangleMesh& a, const Pose& pose_a, const Vector3& by,
               const TriangleMesh& b) {
  const auto tree_a = std::make_shared<Bvh>(build_bvh(a)), tree_b = std::make_shared<Bvh>(build_bvh(b));
  add(name, [=] { return first_contact({*tree_a, pose_a}, by, *tree_b).has_value(); });
}

/// How near face to face, one of them turned: closest triangles, many of them equally near.
void add_near(std::uint32_t n) {
  const std::string size = std::to_string(n);
  const double top = n;
  const auto tree = std::make_shared<Bvh>(build_bvh(box(n)));
  const Pose lifted{identity_pose.columns, {0.25, 0.5, 2 * top}};
  const Pose turn{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {0.25, 0.5, 2 * top}};
  add("near/" + size + "/lifted", [=] { return closest_triangles({*tree, lifted}, *tree).has_value(); });
  add("near/" + size + "/turned", [=] { return closest_triangles({*tree, turn}, *tree).has_value(); });
}

/// A ring whose vertices are shaken: where they are given, and under a pose at each end of the motion.
void add_shaken(std::uint32_t n) {
  const TriangleMesh ring = meshes::ring(n);
  std::vector<Point3> to = ring.vertices;
  Entropy entropy(2026, n);
  const auto step = [&] { return static_cast<double>(entropy.within(1 << 20)) * 0x1p-20 / n; };
  for (Point3& p : to) p = {p.x + step(), p.y + step(), p.z + step()};
  const auto mesh = std::make_shared<MovingMesh>(build_moving_mesh(ring.vertices, to, ring.triangles));
  const Pose from{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {0.1, 0.2, 0.3}};
  Pose moved = from;
  moved.translation.x = 0.1 + 0x1p-40;
  const std::string name = "shaken/" + std::to_string(n);
  const MotionContactOptions serial{.execution = Execution::serial};
  std::printf("%s: %zu contacts, %zu posed\n", name.c_str(), contacts_in_motion(*mesh, serial).size(),
              contacts_in_motion({*mesh, from, moved}, serial).size());
  add(name, [=] { return contacts_in_motion(*mesh, serial).empty(); });
  add(name + "/posed", [=] { return contacts_in_motion({*mesh, from, moved}, serial).empty(); });
}

void add_boxes(std::uint32_t n) {
  const std::string size = std::to_string(n);
  const double top = n;
  const TriangleMesh floor = box(n);
  const TriangleMesh above = mapped(floor, [&](const Point3& p) {
    return Point3{p.x + 0.25, p.y + 0.5, p.z + 2 * top};
  });
  add("boxes/" + size + "/straight", above, {0, 0, -3 * top}, floor);
  add("boxes/" + size + "/askew", above, {0.3, 0.1, -3 * top}, floor);
  const Point3 way = turned({0.25, 0.5, -3 * top});
  add("boxes/" + size + "/turned", mapped(above, turned), {way.x, way.y, way.z}, mapped(floor, turned));
  const TriangleMesh level = mapped(floor, [&](const Point3& p) { return Point3{p.x, p.y, p.z + 2 * top}; });
  add("boxes/" + size + "/level", level, {0, 0, -3 * top}, floor);
  add_posed("boxes/" + size + "/posed", floor, {identity_pose.columns, {0.25, 0.5, 2 * top}}, {0, 0, -3 * top}, floor);
}

const bool added = [] {
  for (const std::uint32_t n : {4u, 16u, 64u}) add_boxes(n);
  for (const std::uint32_t n : {2u, 4u, 8u}) add_near(n);
  for (const std::uint32_t n : {16u, 32u}) add_shaken(n);
  for (const std::uint32_t n : {16u, 64u}) {
    const TriangleMesh ring = meshes::ring(n);
    const TriangleMesh far = mapped(ring, [](const Point3& p) { return Point3{p.x + 3, p.y + 0.25, p.z + 0.125}; });
    const Pose turn{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {0, 0, 0}};
    add("rings/" + std::to_string(n), ring, {4, 0.5, 0}, far);
    add_posed("rings/" + std::to_string(n) + "/posed", ring, turn, {4, 0.5, 0}, far);
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

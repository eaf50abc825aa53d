// How do trees grow?  Time to build and to ask them, and memory, from a thousand triangles to ten million; one thread.
//
// A closed wavy ring of 4 n^2 triangles, its vertices floats.  `build_binned` and `build_linear` are ns for each
// triangle, with the bytes that the tree and the mesh in it take, and the most that the process held meanwhile, the
// mesh that it is built of included; `rays_random` (from around the mesh to places in its box) and `rays_camera`
// (through the pixels of an image, in rows) are ns for each ray, asked together; `rays_random_single` one at a time.
// tests/bench/report/growth.py draws it.  --benchmark_filter='growth/.{1,6}/' leaves a million and more out.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "bench/report/growth_counters.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

/// One size at a time.
struct Grown {
  std::uint32_t side = 0;
  TriangleMesh mesh;
  Bvh bvh;
};

double in_float(double x) { return static_cast<double>(static_cast<float>(x)); }

Grown& grown(std::uint32_t side) {
  static Grown now;
  if (now.side == side) return now;
  now = Grown{};  // before the next is made
  now = {side, meshes::ring(side), {}};
  for (Point3& p : now.mesh.vertices) p = {in_float(p.x), in_float(p.y), in_float(p.z)};
  now.mesh.vertices.shrink_to_fit();
  now.mesh.triangles.shrink_to_fit();
  return now;
}
const Bvh& tree_of(std::uint32_t side) {
  Grown& g = grown(side);
  if (g.bvh.triangles.size() == 0) g.bvh = build_bvh(g.mesh, {.execution = Execution::serial});
  return g.bvh;
}

void build(benchmark::State& state, std::uint32_t side, BvhMethod method) {
  Grown& g = grown(side);
  g.bvh = Bvh{};
  forget_peak();
  std::size_t bytes = 0;
  for (auto _ : state) {
    const Bvh bvh = build_bvh(g.mesh, {.method = method, .execution = Execution::serial});
    bytes = memory_of(bvh);
  }
  const auto n = static_cast<double>(g.mesh.triangles.size());
  state.counters["ns"] = ns_for_each(g.mesh.triangles.size());
  state.counters["bytes"] = static_cast<double>(bytes) / n;
  state.counters["peak"] = peak_bytes();
}

std::vector<AnyRay> rays_at_ring(bool camera) {
  constexpr std::int64_t width = 256;
  std::vector<AnyRay> rays;
  Entropy e(77);
  const auto number = [&e](double most) { return in_float(most * signed_unit_coordinate(e)); };
  for (std::int64_t i = 0; i < width * width; ++i) {
    const double u = static_cast<double>(i % width) / width - 0.5, v = static_cast<double>(i / width) / width - 0.5;
    Point3 from{2.5, 1.5, in_float(1.8)}, to{1.6 * u - 0.5 * v, -2.6 * u, 2 * v};
    if (!camera) {
      const double x = number(3), y = number(3), z = number(3);
      from = {x, y, z};
      const double to_x = number(1.4), to_y = number(1.4), to_z = number(0.4);
      to = {to_x, to_y, to_z};
    }
    rays.emplace_back(Ray3{from, {in_float(to.x - from.x), in_float(to.y - from.y), in_float(to.z - from.z)}});
  }
  return rays;
}

void ask(benchmark::State& state, std::uint32_t side, bool camera, bool together) {
  const Bvh& bvh = tree_of(side);
  const std::vector<AnyRay> rays = rays_at_ring(camera);
  std::vector<std::uint32_t> first(rays.size());
  for (auto _ : state) {
    if (together) {
      first_triangle(bvh, rays, first, {.execution = Execution::serial});
    } else {
      for (std::size_t i = 0; i < rays.size(); ++i) first[i] = first_triangle(bvh, rays[i]).value_or(no_triangle);
    }
    benchmark::DoNotOptimize(first.data());
  }
  state.counters["ns"] = ns_for_each(rays.size());
}

const bool added = [] {
  for (const std::uint32_t side : {16U, 50U, 158U, 500U, 1581U}) {  // 10^3, 10^4, ..., 10^7 triangles, about
    const auto add = [side](const std::string& what, std::function<void(benchmark::State&)> run) {
      const std::string name = "growth/" + std::to_string(4 * std::uint64_t{side} * side) + "/" + what;
      benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run)](benchmark::State& state) {
        run(state);
      })->Unit(benchmark::kMillisecond);
    };
    using State = benchmark::State;
    add("build_linear", [side](State& s) { build(s, side, BvhMethod::linear); });
    add("build_binned", [side](State& s) { build(s, side, BvhMethod::binned); });
    add("rays_random", [side](State& s) { ask(s, side, false, true); });
    add("rays_random_single", [side](State& s) { ask(s, side, false, false); });
    add("rays_camera", [side](State& s) { ask(s, side, true, true); });
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

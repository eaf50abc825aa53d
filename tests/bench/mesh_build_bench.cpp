// How long does a tree of a mesh take to build?  Beside Embree's builders where it is installed, on the same triangles.
//
// Meshes: a closed wavy ring of n triangles, as it is generated (neighbors in memory are neighbors in space) or
// `shuffled`.  Threads: as many as the second argument says.  `triangles` is triangles a second; `cost` that of the tree,
// by the surface-area heuristic.
// `needles` are long thin triangles that lie anyhow in a cube, so many as the first argument says, with spatial splits by
// a budget of so many hundredths as the second says: `rays` is rays a second on one thread that ask for the first, `slots`
// the slots for each triangle, `build` the milliseconds that the tree took.
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

#include "plumb/certify/thread_limit.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#ifdef PLUMB_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif

namespace plumb::bench {
namespace {

enum class Order : int { generated, shuffled };

const TriangleMesh& mesh_of(std::int64_t size, Order order) {
  struct Made {
    std::int64_t size;
    Order order;
    TriangleMesh mesh;
  };
  static std::vector<Made> made;
  for (const Made& m : made) {
    if (m.size == size && m.order == order) return m.mesh;
  }
  TriangleMesh mesh = meshes::ring(static_cast<std::uint32_t>(size));
  Entropy e(17);
  for (std::size_t i = mesh.triangles.size(); order == Order::shuffled && i > 1; --i) {
    std::swap(mesh.triangles[i - 1], mesh.triangles[e.below(i)]);
  }
  return made.emplace_back(Made{size, order, std::move(mesh)}).mesh;
}

void report(benchmark::State& state, const TriangleMesh& mesh) {
  state.counters["triangles"] =
      benchmark::Counter(static_cast<double>(mesh.triangles.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

void build_mesh(benchmark::State& state, BvhMethod method, Order order) {
  const TriangleMesh& mesh = mesh_of(state.range(0), order);
  const auto threads = static_cast<std::size_t>(state.range(1));
  const ThreadLimit control(threads);
  BvhOptions options;
  options.method = method;
  options.execution = threads == 1 ? Execution::serial : Execution::parallel;
  for (auto _ : state) benchmark::DoNotOptimize(build_bvh(mesh, options).wide.nodes.data());
  report(state, mesh);
  state.counters["cost"] = cost_of(build_bvh(mesh, options).tree).total(1, 0.5);
}

#ifdef PLUMB_BENCH_EMBREE
void build_embree(benchmark::State& state, RTCBuildQuality quality, Order order) {
  const TriangleMesh& mesh = mesh_of(state.range(0), order);
  const RTCDevice device = rtcNewDevice(("threads=" + std::to_string(state.range(1))).c_str());
  for (auto _ : state) {
    const RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, quality);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality);
    auto* const vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      vertices[3 * i] = static_cast<float>(mesh.vertices[i].x);
      vertices[3 * i + 1] = static_cast<float>(mesh.vertices[i].y);
      vertices[3 * i + 2] = static_cast<float>(mesh.vertices[i].z);
    }
    auto* const triangles = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) triangles[3 * i + k] = mesh.triangles[i][k];
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    rtcReleaseScene(scene);
  }
  rtcReleaseDevice(device);
  report(state, mesh);
}
#endif

void shoot_needles(benchmark::State& state) {
  Entropy e(4711);
  const auto number = [&] { return 100 * signed_unit_coordinate(e); };
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(state.range(0)); ++i) {
    const Point3 a{number(), number(), number()}, b{number(), number(), number()};
    mesh.vertices.insert(mesh.vertices.end(), {a, b, {a.x + number() / 1000, a.y + number() / 1000, a.z}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  BvhOptions options;
  options.split_share = static_cast<float>(state.range(1)) / 100;
  options.execution = Execution::serial;
  const auto start = std::chrono::steady_clock::now();
  const Bvh bvh = build_bvh(mesh, options);
  const std::chrono::duration<double, std::milli> built = std::chrono::steady_clock::now() - start;
  std::vector<AnyRay> rays;
  for (int i = 0; i < 4096; ++i) {
    const Point3 a{number(), number(), number()}, b{number(), number(), number()};
    rays.emplace_back(Ray3{a, {b.x - a.x, b.y - a.y, b.z - a.z}});
  }
  std::vector<std::uint32_t> first(rays.size());
  for (auto _ : state) first_triangle(bvh, rays, first, {.execution = Execution::serial});
  state.counters["rays"] = benchmark::Counter(
      static_cast<double>(rays.size()) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["cost"] = cost_of(bvh.tree).total(1, 0.5);
  state.counters["slots"] = static_cast<double>(bvh.triangles.size()) / static_cast<double>(mesh.triangles.size());
  state.counters["build"] = built.count();
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{50, 158, 500, 1000}, {1, 2}})->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(build_mesh, binned, BvhMethod::binned, Order::generated)->Apply(sizes);
BENCHMARK_CAPTURE(build_mesh, linear, BvhMethod::linear, Order::generated)->Apply(sizes);
BENCHMARK_CAPTURE(build_mesh, binned_shuffled, BvhMethod::binned, Order::shuffled)->Apply(sizes);
BENCHMARK_CAPTURE(build_mesh, linear_shuffled, BvhMethod::linear, Order::shuffled)->Apply(sizes);
BENCHMARK(shoot_needles)->ArgsProduct({{1000, 100000}, {0, 20, 100, 400}})->Unit(benchmark::kMillisecond);
#ifdef PLUMB_BENCH_EMBREE
BENCHMARK_CAPTURE(build_embree, medium, RTC_BUILD_QUALITY_MEDIUM, Order::generated)->Apply(sizes);
BENCHMARK_CAPTURE(build_embree, low, RTC_BUILD_QUALITY_LOW, Order::generated)->Apply(sizes);
BENCHMARK_CAPTURE(build_embree, medium_shuffled, RTC_BUILD_QUALITY_MEDIUM, Order::shuffled)->Apply(sizes);
BENCHMARK_CAPTURE(build_embree, low_shuffled, RTC_BUILD_QUALITY_LOW, Order::shuffled)->Apply(sizes);
#endif

}  // namespace
}  // namespace plumb::bench

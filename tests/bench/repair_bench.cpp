// How long do welding, topology and repair take?  Beside plain code for the same: a hash table of points and edges, and
// union-find alone.
//
// Meshes: a closed wavy ring; `soup` is its triangles with three vertices each, in their order.  `faults` are planted one
// a thousandth of the triangles: holes, turned and doubled triangles, repeated vertices.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <random>
#include <string_view>
#include <unordered_map>

#include "plumb/surface.hpp"
#include "space/bvh/meshes.hpp"
#include "surface/repair/planted_faults.hpp"

namespace plumb::bench {
namespace {

TriangleMesh soup_of(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const auto& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

/// Of some so many triangles.
TriangleMesh ring(const benchmark::State& state) {
  return meshes::ring(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(state.range(0)) / 4)));
}

void weld_and_half_edges(benchmark::State& state) {
  const TriangleMesh soup = soup_of(ring(state));
  for (auto _ : state) {
    const TriangleMesh mesh = welded(soup, find_weld(soup));
    benchmark::DoNotOptimize(half_edges(mesh, find_edges(mesh)).twin.data());
  }
}

/// As it is often written: points by a hash of their bytes, half-edges by a hash of their ends.
void weld_and_half_edges_plain(benchmark::State& state) {
  const TriangleMesh soup = soup_of(ring(state));
  struct PointHash {
    std::size_t operator()(const Point3& p) const {
      return std::hash<std::string_view>{}({reinterpret_cast<const char*>(&p), sizeof p});
    }
  };
  for (auto _ : state) {
    std::unordered_map<Point3, std::uint32_t, PointHash> number;
    std::unordered_map<std::uint64_t, std::uint32_t> half;
    number.reserve(soup.vertices.size()), half.reserve(soup.vertices.size());
    std::vector<std::uint32_t> named, twin(soup.vertices.size(), no_half_edge);
    for (const Point3& p : soup.vertices)
      named.push_back(number.emplace(p, static_cast<std::uint32_t>(number.size())).first->second);
    for (std::uint32_t h = 0; h < twin.size(); ++h) {
      const std::uint64_t a = named[h], b = named[next_half_edge(h)];
      half.emplace(a << 32 | b, h);
      if (const auto at = half.find(b << 32 | a); at != half.end()) twin[h] = at->second, twin[at->second] = h;
    }
    benchmark::DoNotOptimize(twin.data());
  }
}

/// Points in one ball as wide as the tolerance, or in balls with some ten each.
void weld_cloud(benchmark::State& state, WeldRule rule, double width) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along(-1, 1);
  TriangleMesh cloud;
  while (std::ssize(cloud.vertices) < state.range(0)) {
    const Point3 p{along(random), along(random), along(random)};
    if (std::hypot(p.x, p.y, p.z) <= 1) cloud.vertices.push_back({p.x * width, p.y * width, p.z * width});
  }
  for (auto _ : state) benchmark::DoNotOptimize(find_weld(cloud, {.tolerance = 1, .rule = rule}).into.data());
}

void components(benchmark::State& state, JoinedOver over) {
  const TriangleMesh mesh = ring(state);
  const MeshEdges edges = find_edges(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(connected_components(mesh, edges, over).count);
}

void loops(benchmark::State& state) {
  TriangleMesh mesh = ring(state);
  std::size_t number = 0;
  std::erase_if(mesh.triangles, [&](const auto&) { return number++ % 1000 == 0; });
  const MeshEdges edges = find_edges(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(boundary_loops(mesh, edges).data());
}

void union_find_plain(benchmark::State& state) {
  const TriangleMesh mesh = ring(state);
  const auto pairs = interior_edges(find_edges(mesh));
  for (auto _ : state) {
    std::vector<std::uint32_t> above(mesh.triangles.size());
    std::iota(above.begin(), above.end(), 0U);
    const auto find = [&](std::uint32_t i) {
      while (above[i] != i) i = above[i] = above[above[i]];
      return i;
    };
    for (const InteriorEdge& e : pairs) {
      const std::uint32_t s = find(e.face_c), t = find(e.face_d);
      above[std::max(s, t)] = std::min(s, t);
    }
    for (std::uint32_t t = 0; t < above.size(); ++t) above[t] = find(t);
    benchmark::DoNotOptimize(above.data());
  }
}

void mend(benchmark::State& state) {
  TriangleMesh mesh = ring(state);
  std::mt19937 random(5);
  std::vector<std::uint32_t> gone;
  for (std::int64_t i = 0; i < state.range(0) / 1000; ++i) {
    const std::string_view name = std::array{"hole of a triangle", "turned triangle", "duplicate triangle",
                                             "opposite triangle", "repeated vertex"}[i % 5];
    const auto fault = std::ranges::find(planted::faults, name, &planted::Fault::name);
    planted::Ground ground{mesh, static_cast<std::uint32_t>(random() % mesh.triangles.size()), 1e-12};
    fault->plant(ground);
    gone.insert(gone.end(), ground.gone.begin(), ground.gone.end());
  }
  std::ranges::sort(gone, std::greater());
  gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
  for (const std::uint32_t triangle : gone) mesh.triangles.erase(mesh.triangles.begin() + triangle);
  std::size_t changes = 0;
  bool sound = false;
  for (auto _ : state) {
    const Repaired done = repair(mesh);
    changes = done.changes.size();
    sound = !done.faults.any();
  }
  state.counters["changes"] = static_cast<double>(changes);
  state.counters["sound"] = sound ? 1 : 0;
}

BENCHMARK(weld_and_half_edges)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(weld_and_half_edges_plain)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld_cloud, dense_clusters, WeldRule::clusters, 0.5)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld_cloud, dense_chains, WeldRule::chains, 0.5)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld_cloud, loose_clusters, WeldRule::clusters, 10)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld_cloud, loose_chains, WeldRule::chains, 10)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(components, vertices, JoinedOver::vertices)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(components, edges, JoinedOver::edges)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(loops)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(union_find_plain)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(mend)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace plumb::bench

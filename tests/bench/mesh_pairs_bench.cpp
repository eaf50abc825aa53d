// How long does it take to find all pairs of triangles that meet?  One thread; beside CGAL's tree of boxes.
//
// Meshes: a torus of 4 n^2 / 2 triangles against itself turned a little, which crosses it along curves; against itself
// moved by nothing, where every pair is exactly degenerate; and itself alone, which has no pairs but neighbors.
// `s_pair` is the time of each pair found, `s_triangle` that of each triangle of a mesh; trees are built beforehand.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <string>

#include "bench/rivals/mesh_rival.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/space.hpp"

namespace plumb::bench {
namespace {

TriangleMesh torus(std::uint32_t around) { return solids::torus(300, 100, around, around / 2); }

TriangleMesh turned(TriangleMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point3& p : mesh.vertices) p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
  return mesh;
}

void add_pairs(const std::string& name, std::size_t triangles, std::function<std::size_t()> count) {
  benchmark::RegisterBenchmark(name.c_str(), [triangles, count = std::move(count)](benchmark::State& state) {
    std::size_t pairs = 0;
    for (auto _ : state) benchmark::DoNotOptimize(pairs = count());
    const auto each = [&](std::size_t n) {
      return benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(n),
                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    };
    state.counters["pairs"] = static_cast<double>(pairs);
    state.counters["s_pair"] = each(pairs);
    state.counters["s_triangle"] = each(triangles);
  })->Unit(benchmark::kMillisecond);
}

void add_mesh(std::uint32_t around) {
  const auto mesh = std::make_shared<TriangleMesh>(torus(around));
  const auto bvh = std::make_shared<Bvh>(build_bvh(*mesh));
  const auto cgal = std::make_shared<CgalMesh>(*mesh);
  const std::string size = std::to_string(mesh->triangles.size());
  const std::size_t n = mesh->triangles.size();
  const PairOptions serial{.execution = Execution::serial};
  for (const double angle : {0.0, 0.1}) {
    const auto other = std::make_shared<TriangleMesh>(turned(*mesh, angle));
    const auto tree = std::make_shared<Bvh>(build_bvh(*other));
    const std::string name = "mesh_pairs/" + std::string(angle == 0 ? "same/" : "turned/") + size;
    add_pairs(name + "/plumb", n, [=] { return intersecting_pairs(*bvh, *tree, serial).size(); });
    add_pairs(name + "/plumb_any", n, [=] { return any_intersecting_pair(*bvh, *tree, serial) ? 1u : 0u; });
    add_pairs(name + "/cgal", n, [=] { return cgal->pairs_with(*other); });
  }
  add_pairs("mesh_pairs/itself/" + size + "/plumb", n, [=] { return self_intersecting_pairs(*bvh, serial).size(); });
}

const bool added = [] {
  add_mesh(64);
  add_mesh(416);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

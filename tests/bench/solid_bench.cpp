// How long does it take to unite solids, from bare arrays to an exact result, and beside CGAL's corefinement in doubles?
//
//   bench_solid --benchmark_repetitions=5 --benchmark_report_aggregates_only
//
// tori: two smooth ones that cross.  grids: two blocks whose faces are cut into cells, half a cell apart, so that all of
// it is coplanar, merged.  boxes: two walls of boxes face to face.  itself: a mesh and itself.  pipes: slender ones that
// cross many times.  chain: sixty boxes of a lattice in turn, kept exact, merged or not.  What CGAL refuses is `refused`.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <utility>

#include "bench/rivals/solid/rival.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/surface/solid/boolean.hpp"

namespace plumb::bench {
namespace {

using Pair = std::pair<TriangleMesh, TriangleMesh>;

/// Makes a torus of 2 n n triangles.
TriangleMesh torus(std::uint32_t n, const Vector3& at) {
  TriangleMesh mesh;
  const double part = 6.283185307179586 / n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double u = part * i, v = part * k, r = 3 + std::cos(v);
      mesh.vertices.push_back({r * std::cos(u) + at.x, r * std::sin(u) + at.y, std::sin(v) + at.z});
      const auto number = [n](std::uint32_t p, std::uint32_t q) { return p % n * n + q % n; };
      mesh.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
      mesh.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  }
  return mesh;
}
Pair tori(std::uint32_t n) { return {torus(n, {0, 0, 0}), torus(n, {1.2345, 0.777, 0.321})}; }

/// Makes blocks of n by n by 1 cells, of which all faces that are outside are kept.
Pair grids(int n) {
  std::set<solids::Cell> cells;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) cells.insert({i, k, 0});
  TriangleMesh a = solids::voxels(cells), b = a;
  for (Point3& p : b.vertices) p.x += 0.5, p.y += 0.5;
  return {std::move(a), std::move(b)};
}

Pair boxes(int n) {
  Pair walls;
  for (int i = 0; i < n; ++i) {
    const double x = 2.0 * (i % 32), y = 2.0 * (i / 32);
    solids::append(walls.first, solids::box({x, y, 0}, {x + 1, y + 1, 1}));
    solids::append(walls.second, solids::box({x + 0.25, y + 0.5, 1}, {x + 1.25, y + 1.5, 2}));
  }
  return walls;
}

/// It leads along the first axis, or the second.
TriangleMesh pipe(bool is_first, double across, double up, int sides, double length) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(sides);
  for (const double along : {0.0, length}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 6.283185307179586 * i / sides, u = across + 0.4 * std::cos(angle),
                   v = up + 0.4 * std::sin(angle);
      mesh.vertices.push_back(is_first ? Point3{along, u, v} : Point3{u, along, v});
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (!is_first) std::swap(b, c);
    mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    add(i, next, n + next), add(i, n + next, n + i);
    if (i > 1) add(0, i, i - 1), add(n, n + i - 1, n + i);
  }
  return mesh;
}
Pair pipes(int n) {
  Pair all;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      solids::append(all.first, pipe(true, 1 + 2 * i, 1 + 2 * k, 32, 2 * n + 2));
      solids::append(all.second, pipe(false, 1.13 + 2 * i, 1.21 + 2 * k, 32, 2 * n + 2));
    }
  }
  return all;
}

void unite_ours(benchmark::State& state, const Pair& of, Pieces pieces) {
  std::size_t triangles = 0;
  for (auto _ : state) triangles = unite(of.first, of.second, WindingRule::positive, pieces).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["input"] = static_cast<double>(of.first.triangles.size() + of.second.triangles.size());
}
void unite_rival(benchmark::State& state, const Pair& of) {
  std::optional<std::size_t> triangles;
  for (auto _ : state) triangles = unite_by_cgal(of.first, of.second);
  state.counters["triangles"] = static_cast<double>(triangles.value_or(0));
  state.counters["refused"] = triangles ? 0 : 1;
}

void chain(benchmark::State& state, Pieces pieces) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> at(0, 7), size(1, 4);
  std::vector<ExactMesh> all;
  for (int i = 0; i < 60; ++i) {
    const double x = at(random), y = at(random), z = at(random), u = size(random), v = size(random), w = size(random);
    const TriangleMesh box = solids::box({x, y, z}, {x + u, y + v, z + w});
    all.push_back(unite(std::span<const TriangleMesh>(&box, 1)));
  }
  std::size_t triangles = 0;
  for (auto _ : state) {
    ExactMesh made = all[0];
    for (std::size_t i = 1; i < all.size(); ++i) {
      const std::vector<ExactMesh> two{std::move(made), all[i]};
      made = i % 3 == 2 ? subtract(two, WindingRule::positive, pieces) : unite(two, WindingRule::positive, pieces);
    }
    triangles = made.triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void add(const std::string& name, const Pair& of, Pieces pieces = Pieces::of_triangles) {
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), unite_ours, of, pieces)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/cgal").c_str(), unite_rival, of)->Unit(benchmark::kMillisecond);
}

const bool added = [] {
  add("tori/2x100352", tori(224));
  add("grids/2x12000", grids(53), Pieces::of_polygons);
  add("boxes/2x1000", boxes(1000));
  const TriangleMesh mesh = torus(224, {0, 0, 0});
  add("itself/100352", {mesh, mesh});
  add("pipes/2x36", pipes(6));
  benchmark::RegisterBenchmark("chain/60/plumb", chain, Pieces::of_polygons)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("chain/60/unmerged/plumb", chain, Pieces::of_triangles)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

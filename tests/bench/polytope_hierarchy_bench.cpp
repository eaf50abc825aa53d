// When does a Dobkin-Kirkpatrick hierarchy pay for itself?  Support and distance by it, by climbing and by looking at
// all vertices; what it takes to build.
//
// Points of a sphere, nearly all of which are vertices.  An iteration is 256 questions, of any directions and of points
// at twice the radius; `ns` is the time of one.  `climb` begins each at the same vertex, `bytes` are those of the
// hierarchy without its polyhedron.
#include <benchmark/benchmark.h>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/polytope_hierarchy/polytope_hierarchy.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t questions = 256;

ConvexPolyhedron3 ball_of(std::int64_t vertices) {
  Entropy entropy(1, 1);
  const std::vector<Point3> points = cloud3(Cloud::sphere, static_cast<std::size_t>(vertices), entropy);
  return convex_polyhedron(convex_hull(points), points);
}

std::vector<Point3> some_points() {
  Entropy entropy(2, 2);
  std::vector<Point3> points = cloud3(Cloud::sphere, questions, entropy);
  for (Point3& p : points) p = {2 * p.x, 2 * p.y, 2 * p.z};
  return points;
}

template <class Ask>
void ask_all(benchmark::State& state, Ask ask) {
  const std::vector<Point3> points = some_points();
  for (auto _ : state) {
    for (const Point3& p : points) benchmark::DoNotOptimize(ask(p));
  }
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(questions) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

Vector3 toward(const Point3& p) { return {p.x, p.y, p.z}; }

void build(benchmark::State& state) {
  const ConvexPolyhedron3 polyhedron = ball_of(state.range(0));
  std::size_t most = 0, levels = 0;
  for (auto _ : state) {
    const PolytopeHierarchy h = build_polytope_hierarchy(polyhedron);
    levels = h.levels.size(), most = bytes(h);
  }
  const ConvexPolyhedron3& p = polyhedron;
  const std::size_t own = p.mesh.vertices.size() * sizeof(Point3) +
                          sizeof(std::uint32_t) * (p.mesh.corners.size() + p.mesh.first.size() + p.across.size() +
                                                   p.neighbors.size() + p.first_neighbor.size());
  state.counters["levels"] = static_cast<double>(levels);
  state.counters["bytes"] = static_cast<double>(most - own);
}
void support_hierarchy(benchmark::State& state) {
  const PolytopeHierarchy h = build_polytope_hierarchy(ball_of(state.range(0)));
  ask_all(state, [&](const Point3& p) { return support_point(h, toward(p)); });
}
void support_climb(benchmark::State& state) {
  const ConvexPolyhedron3 polyhedron = ball_of(state.range(0));
  ask_all(state, [&](const Point3& p) { return support_point(polyhedron, toward(p)); });
}
void support_all(benchmark::State& state) {
  const ConvexPolyhedron3 polyhedron = ball_of(state.range(0));
  ask_all(state,
          [&](const Point3& p) { return support_point(std::span<const Point3>(polyhedron.mesh.vertices), toward(p)); });
}
void distance_hierarchy(benchmark::State& state) {
  const PolytopeHierarchy h = build_polytope_hierarchy(ball_of(state.range(0)));
  ask_all(state, [&](const Point3& p) { return distance(p, h); });
}
void distance_walk(benchmark::State& state) {
  const ConvexPolyhedron3 polyhedron = ball_of(state.range(0));
  ask_all(state, [&](const Point3& p) { return distance(p, polyhedron); });
}

#define PLUMB_BENCH_SIZES Arg(32)->Arg(128)->Arg(1024)->Arg(10'000)->Arg(100'000)
BENCHMARK(build)->PLUMB_BENCH_SIZES->Unit(benchmark::kMicrosecond);
BENCHMARK(support_hierarchy)->PLUMB_BENCH_SIZES;
BENCHMARK(support_climb)->PLUMB_BENCH_SIZES;
BENCHMARK(support_all)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_hierarchy)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_walk)->PLUMB_BENCH_SIZES;

}  // namespace
}  // namespace plumb::bench

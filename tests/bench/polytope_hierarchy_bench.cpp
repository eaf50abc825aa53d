// When does a Dobkin-Kirkpatrick hierarchy pay for itself?  Support and distance by it, by climbing and by looking at
// all vertices; what it takes to build.
//
// Points of a sphere, nearly all of which are vertices.  An iteration is 256 questions, of any directions and of points
// at twice the radius; `ns` is the time of one.  `climb` begins each at the same vertex, `bytes` are those of the
// hierarchy without its polyhedron.  `pair`: 64 pairs of two such polytopes, the second moved by 2 to 3 radii any way.
#include <benchmark/benchmark.h>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/gjk/gjk.hpp"
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

/// Both of a pair, and a hierarchy of each.
struct Pair {
  PolytopeHierarchy a, b;
};
const std::vector<Pair>& pairs_of(std::int64_t vertices) {
  static std::vector<Pair> pairs;
  static std::int64_t known = 0;
  if (known == vertices) return pairs;
  known = vertices, pairs.clear();
  const ConvexPolyhedron3 still = ball_of(vertices);
  const std::size_t count = vertices > 10'000 ? 4 : vertices > 1024 ? 16 : 64;
  Entropy entropy(4, 4);
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 to = cloud3(Cloud::sphere, 1, entropy)[0];
    const double far = 2 + static_cast<double>(entropy.bits(53)) * 0x1p-53;
    ConvexPolyhedron3 moved = still;
    for (Point3& p : moved.mesh.vertices) p = {far * to.x - p.y, far * to.y + p.x, far * to.z + p.z};  // and turned
    pairs.push_back({build_polytope_hierarchy(still), build_polytope_hierarchy(convex_polyhedron(
                                                          convex_hull(moved.mesh.vertices), moved.mesh.vertices))});
  }
  return pairs;
}
template <class Ask>
void ask_pairs(benchmark::State& state, Ask ask) {
  const std::vector<Pair>& pairs = pairs_of(state.range(0));
  for (auto _ : state) {
    for (const Pair& p : pairs) benchmark::DoNotOptimize(ask(p));
  }
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(pairs.size()) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void pair_hierarchy(benchmark::State& state) {
  ask_pairs(state, [](const Pair& p) { return distance(p.a, p.b); });
}
void pair_gjk(benchmark::State& state) {
  ask_pairs(state, [](const Pair& p) { return gjk_distance(p.a.polyhedron, p.b.polyhedron); });
}

#define PLUMB_BENCH_SIZES Arg(32)->Arg(128)->Arg(1024)->Arg(10'000)->Arg(100'000)
BENCHMARK(build)->PLUMB_BENCH_SIZES->Unit(benchmark::kMicrosecond);
BENCHMARK(support_hierarchy)->PLUMB_BENCH_SIZES;
BENCHMARK(support_climb)->PLUMB_BENCH_SIZES;
BENCHMARK(support_all)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_hierarchy)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_walk)->PLUMB_BENCH_SIZES;
BENCHMARK(pair_hierarchy)->PLUMB_BENCH_SIZES;
BENCHMARK(pair_gjk)->PLUMB_BENCH_SIZES;

}  // namespace
}  // namespace plumb::bench

// Which method of convex polyhedra is the fastest?  V-Clip, Chung and Wang's separating vector, separating axes, and
// the library's own intersects and distance, from scratch and from the last answer.
//
// Hulls of points of a sphere, of coordinates that are multiples of 2^-30, so that moves are exact.  `scattered`: 64
// pairs, half of which meet.  `coherent`: one passes the other in 64 steps, a quarter of which meet.  An iteration is
// all 64; `ns` is the time of one pair.
#include <benchmark/benchmark.h>

#include <cmath>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/vclip/separating_axis.hpp"
#include "plumb/query/vclip/separating_vector.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 64;

double on_grid(double x) { return std::nearbyint(x * 0x1p30) * 0x1p-30; }

ConvexPolyhedron3 ball_of(std::int64_t vertices, std::uint64_t start) {
  Entropy entropy(start, 1);
  std::vector<Point3> points = cloud3(Cloud::sphere, static_cast<std::size_t>(vertices), entropy);
  for (Point3& p : points) p = {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
  return convex_polyhedron(convex_hull(points), points);
}

ConvexPolyhedron3 moved(ConvexPolyhedron3 p, const Vector3& by) {
  for (Point3& v : p.mesh.vertices) v = {v.x + on_grid(by.x), v.y + on_grid(by.y), v.z + on_grid(by.z)};
  return p;
}

struct Scene {
  ConvexPolyhedron3 still;
  std::vector<ConvexPolyhedron3> others;
};

Scene scattered(std::int64_t n) {
  Scene s{ball_of(n, 1), {}};
  Entropy entropy(3, 3);
  for (std::size_t i = 0; i < pairs; ++i) {
    const Point3 to = cloud3(Cloud::sphere, 1, entropy)[0];
    const double far = i % 2 == 0 ? 1.5 : 2.5;
    s.others.push_back(moved(ball_of(n, 10 + i % 4), {far * to.x, far * to.y, far * to.z}));
  }
  return s;
}
Scene coherent(std::int64_t n) {
  Scene s{ball_of(n, 1), {}};
  const ConvexPolyhedron3 other = ball_of(n, 10);
  for (std::size_t i = 0; i < pairs; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(pairs);
    s.others.push_back(moved(other, {-1 + 2 * part, 1.9, 0.5 * part}));
  }
  return s;
}

template <class Ask>
void run(benchmark::State& state, const Scene& scene, Ask ask) {
  for (auto _ : state) {
    for (const ConvexPolyhedron3& other : scene.others) ask(scene.still, other);
  }
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(pairs) * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

using Maker = Scene (*)(std::int64_t);

template <Maker make>
void intersects_own(benchmark::State& state) {
  run(state, make(state.range(0)), [](const auto& a, const auto& b) { benchmark::DoNotOptimize(intersects(a, b)); });
}
template <Maker make>
void distance_own(benchmark::State& state) {
  run(state, make(state.range(0)), [](const auto& a, const auto& b) { benchmark::DoNotOptimize(distance(a, b)); });
}
template <Maker make>
void vclip_cold(benchmark::State& state) {
  run(state, make(state.range(0)), [](const auto& a, const auto& b) { benchmark::DoNotOptimize(vclip(a, b)); });
}
template <Maker make>
void vclip_warm(benchmark::State& state) {
  VClipOptions last;
  std::uint64_t steps = 0, asked = 0;
  run(state, make(state.range(0)), [&](const auto& a, const auto& b) {
    const VClipResult r = vclip(a, b, last);
    last.start = r.at;
    steps += r.steps, ++asked;
    benchmark::DoNotOptimize(r);
  });
  state.counters["steps"] = static_cast<double>(steps) / static_cast<double>(asked);
}
template <Maker make>
void vector_cold(benchmark::State& state) {
  run(state, make(state.range(0)),
      [](const auto& a, const auto& b) { benchmark::DoNotOptimize(separating_vector(a, b)); });
}
template <Maker make>
void vector_warm(benchmark::State& state) {
  SeparatingVectorOptions last;
  run(state, make(state.range(0)), [&](const auto& a, const auto& b) {
    const SeparatingVector v = separating_vector(a, b, last);
    last = {v.direction ? v.direction : last.direction, v.vertices};
    benchmark::DoNotOptimize(v);
  });
}
template <Maker make>
void axis(benchmark::State& state) {
  run(state, make(state.range(0)),
      [](const auto& a, const auto& b) { benchmark::DoNotOptimize(separating_axis(a, b)); });
}

#define PLUMB_BENCH_SIZES Arg(8)->Arg(32)->Arg(128)->Arg(1000)
BENCHMARK(intersects_own<scattered>)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_own<scattered>)->PLUMB_BENCH_SIZES;
BENCHMARK(vclip_cold<scattered>)->PLUMB_BENCH_SIZES;
BENCHMARK(vector_cold<scattered>)->PLUMB_BENCH_SIZES;
BENCHMARK(axis<scattered>)->Arg(8)->Arg(32)->Arg(128);
BENCHMARK(intersects_own<coherent>)->PLUMB_BENCH_SIZES;
BENCHMARK(distance_own<coherent>)->PLUMB_BENCH_SIZES;
BENCHMARK(vclip_cold<coherent>)->PLUMB_BENCH_SIZES;
BENCHMARK(vclip_warm<coherent>)->PLUMB_BENCH_SIZES;
BENCHMARK(vector_cold<coherent>)->PLUMB_BENCH_SIZES;
BENCHMARK(vector_warm<coherent>)->PLUMB_BENCH_SIZES;

}  // namespace
}  // namespace plumb::bench

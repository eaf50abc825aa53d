// How long do oriented boxes take?  Overlap beside the same test in plain doubles, for boxes that are spread more and
// more; fits and the smallest box beside CGAL's.  `volume` is that of the box, `hits` the share of boxes that meet.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/rivals/obb_rival.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/obb/fits.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 4096;

Obb3 turned(Entropy& entropy, double spread) {
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = signed_unit_coordinate(entropy);
    square += x * x;
  }
  for (double& x : q) x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  const auto half = [&] { return 0.1 + unit_coordinate(entropy); };
  const auto at = [&] { return spread * signed_unit_coordinate(entropy); };
  return {{at(), at(), at()},
          {Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           Vector3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}},
          {half(), half(), half()}};
}

template <class Meet>
void overlap(benchmark::State& state, Meet meet) {
  const double spread = static_cast<double>(state.range(0)) / 2;
  Entropy entropy(44);
  std::vector<Obb3> a, b;
  for (std::size_t i = 0; i < pairs; ++i) {
    a.push_back(turned(entropy, spread));
    b.push_back(turned(entropy, spread));
  }
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (std::size_t i = 0; i < pairs; ++i) hits += static_cast<std::size_t>(meet(a[i], b[i]));
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits"] = static_cast<double>(hits) / pairs;
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void overlap_exact(benchmark::State& state) {
  overlap(state, [](const Obb3& a, const Obb3& b) { return intersects(a, b); });
}
void overlap_plain(benchmark::State& state) { overlap(state, boxes_meet_in_doubles); }
BENCHMARK(overlap_exact)->Arg(1)->Arg(2)->Arg(3)->Arg(4)->Arg(8);
BENCHMARK(overlap_plain)->Arg(1)->Arg(2)->Arg(3)->Arg(4)->Arg(8);

// The hard classes of charts.md: the same axes and touching but for rounding; integers along the coordinates; those, one
// axis off by ulps.
Obb3 aligned(Entropy& entropy) {
  Obb3 box{};
  const std::size_t turn = entropy.below(3);
  const auto at = [&] { return static_cast<double>(entropy.within(4)); };
  const auto half = [&] { return static_cast<double>(entropy.below(4)); };
  for (std::size_t k = 0; k < 3; ++k) (&box.axes[k].x)[(k + turn) % 3] = entropy.coin() ? 1 : -1;
  box.center = {at(), at(), at()}, box.half = {half(), half(), half()};
  return box;
}
std::pair<Obb3, Obb3> hard_pair(std::int64_t kind, Entropy& entropy) {
  if (kind == 0) {
    const Obb3 a = turned(entropy, 2);
    Obb3 b = turned(entropy, 2);
    const std::size_t i = entropy.below(3);
    const double reach = (&a.half.x)[i] + (&b.half.x)[i];
    b.axes = a.axes;
    b.center = {a.center.x + a.axes[i].x * reach, a.center.y + a.axes[i].y * reach, a.center.z + a.axes[i].z * reach};
    return {a, b};
  }
  const Obb3 a = aligned(entropy);
  Obb3 b = aligned(entropy);
  if (kind == 2) (&b.axes[entropy.below(3)].x)[entropy.below(3)] += static_cast<double>(entropy.within(8)) * 0x1p-53;
  return {a, b};
}
template <class Meet>
void hard(benchmark::State& state, Meet meet) {
  Entropy entropy(46);
  std::vector<std::pair<Obb3, Obb3>> boxes;
  for (std::size_t i = 0; i < pairs; ++i) boxes.push_back(hard_pair(state.range(0), entropy));
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (const auto& [a, b] : boxes) hits += static_cast<std::size_t>(meet(a, b));
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits"] = static_cast<double>(hits) / pairs;
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void hard_exact(benchmark::State& state) {
  hard(state, [](const Obb3& a, const Obb3& b) { return intersects(a, b); });
}
void hard_plain(benchmark::State& state) { hard(state, boxes_meet_in_doubles); }
BENCHMARK(hard_exact)->Arg(0)->Arg(1)->Arg(2);
BENCHMARK(hard_plain)->Arg(0)->Arg(1)->Arg(2);

template <class Volume>
void fit(benchmark::State& state, Volume volume_of) {
  Entropy entropy(45);
  const auto points = cloud3(Cloud::ball, static_cast<std::size_t>(state.range(0)), entropy);
  double size = 0;
  for (auto _ : state) {
    size = volume_of(points);
    benchmark::DoNotOptimize(size);
  }
  state.counters["volume"] = size;
}
using Points = std::vector<Point3>;
void smallest(benchmark::State& state) {
  fit(state, [](const Points& p) { return volume(minimum_obb(p)); });
}
void smallest_of_cgal(benchmark::State& state) {
  fit(state, [](const Points& p) { return cgal_box_volume(p); });
}
void principal(benchmark::State& state) {
  fit(state, [](const Points& p) { return volume(fit_obb_principal(p)); });
}
void hull_surface(benchmark::State& state) {
  fit(state, [](const Points& p) { return volume(fit_obb_hull_surface(p)); });
}
void around_principal(benchmark::State& state) {
  fit(state, [](const Points& p) { return volume(fit_obb_around_principal(p)); });
}
void brute_force(benchmark::State& state) {
  fit(state, [](const Points& p) { return volume(fit_obb_brute_force(p)); });
}
BENCHMARK(smallest)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(smallest_of_cgal)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(principal)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(hull_surface)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(around_principal)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(brute_force)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb::bench

// How do indexes of many things grow?  Time and memory from a thousand boxes or points to ten million; one thread.
//
// `pairs_growth/N/METHOD`: all overlapping pairs of N boxes, uniform with some 8 pairs a box, by each method of the broad
// phase, in ns a box, with the most bytes a box that the process held meanwhile, boxes and pairs included.
// `points_growth/N/WHAT`: of N uniform points, ns a point to build (with the bytes a point that the index keeps) and ns
// a query.  tests/bench/report/growth.py draws both.  --benchmark_filter='growth/.{1,6}/' leaves a million and more out.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bench/report/growth_counters.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/space/octree/point_octree.hpp"

namespace plumb::bench {
namespace {

double part(Entropy& e) { return static_cast<double>(e.bits(53)) * 0x1p-53; }

Point3 point_of(Entropy& e) {
  const double x = part(e), y = part(e), z = part(e);
  return {x, y, z};
}

/// One size at a time, in memory that is given back before the next is made.
template <class Thing, class Make>
const std::vector<Thing>& things(std::size_t n, Make&& make) {
  static std::vector<Thing> now;
  if (now.size() != n) {
    now = {};
    now.reserve(n);
    Entropy e(1);
    while (now.size() < n) now.push_back(make(e));
  }
  return now;
}

const std::vector<Aabb3>& boxes(std::size_t n) {
  const double length = std::cbrt(2 / static_cast<double>(n));
  return things<Aabb3>(n, [=](Entropy& e) {
    const Point3 p = point_of(e);
    const double x = length * (0.5 + part(e)), y = length * (0.5 + part(e)), z = length * (0.5 + part(e));
    return Aabb3{p, {p.x + x, p.y + y, p.z + z}};
  });
}
const std::vector<Point3>& points(std::size_t n) { return things<Point3>(n, point_of); }

void find_pairs(benchmark::State& state, std::size_t n, BroadPhaseMethod method) {
  const std::vector<Aabb3>& all = boxes(n);
  forget_peak();
  for (auto _ : state) {
    benchmark::DoNotOptimize(overlapping_pairs(all, {.execution = Execution::serial, .method = method}));
  }
  state.counters["ns"] = ns_for_each(n);
  state.counters["peak"] = peak_bytes();
}

constexpr std::size_t queries = 4096;

void build_kd(benchmark::State& state, std::size_t n) {
  const std::vector<Point3>& all = points(n);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = memory_of(build_kd_tree(all, {.execution = Execution::serial}));
  state.counters["ns"] = ns_for_each(n);
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(n);
}

void ask_nearest(benchmark::State& state, std::size_t n, std::size_t k) {
  const auto tree = build_kd_tree(points(n), {.execution = Execution::serial});
  Entropy e(2);
  std::vector<Point3> asked;
  for (std::size_t i = 0; i < queries; ++i) asked.push_back(point_of(e));
  for (auto _ : state) {
    for (const Point3& p : asked) benchmark::DoNotOptimize(nearest(tree, p, k));
  }
  state.counters["ns"] = ns_for_each(queries);
}

void build_octree(benchmark::State& state, std::size_t n) {
  const std::vector<Point3>& all = points(n);
  for (auto _ : state) benchmark::DoNotOptimize(build_octree(all, {.execution = Execution::serial}));
  state.counters["ns"] = ns_for_each(n);
}

/// A minute or so for each method: those that grow faster than the boxes end earlier.
std::size_t most_boxes(BroadPhaseMethod method) {
  switch (method) {
    case BroadPhaseMethod::swept_columns:
    case BroadPhaseMethod::static_grid:
    case BroadPhaseMethod::hashed_grid:
    case BroadPhaseMethod::box_tree:
      return 10'000'000;
    case BroadPhaseMethod::implicit_grid:
    case BroadPhaseMethod::row_column_grid:
      return 100'000;
    case BroadPhaseMethod::brute_force:
    case BroadPhaseMethod::lists_along_one:
    case BroadPhaseMethod::lists_along_two:
    case BroadPhaseMethod::lists_along_three:
      return 10'000;
    default:
      return 1'000'000;
  }
}

const bool added = [] {
  for (const std::size_t n : {1'000U, 10'000U, 100'000U, 1'000'000U, 10'000'000U}) {
    const auto add = [n](const std::string& family, const std::string& what,
                         std::function<void(benchmark::State&)> run) {
      const std::string name = family + "/" + std::to_string(n) + "/" + what;
      benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run)](benchmark::State& state) {
        run(state);
      })->Unit(benchmark::kMillisecond);
    };
    using State = benchmark::State;
    for (const BroadPhaseMethod m : broad_phase_methods) {
      if (m == BroadPhaseMethod::automatic || n > most_boxes(m)) continue;
      add("pairs_growth", std::string(name_of(m)), [=](State& s) { find_pairs(s, n, m); });
    }
    add("points_growth", "build_kd_tree", [=](State& s) { build_kd(s, n); });
    add("points_growth", "nearest", [=](State& s) { ask_nearest(s, n, 1); });
    add("points_growth", "nearest_8", [=](State& s) { ask_nearest(s, n, 8); });
    add("points_growth", "build_octree", [=](State& s) { build_octree(s, n); });
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

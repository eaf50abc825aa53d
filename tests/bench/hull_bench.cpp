// How long do hulls in space take, beside Qhull's and CGAL's?  The same points, in the same run:
// `bench_hull --benchmark_repetitions=5 --benchmark_report_aggregates_only --benchmark_out=hull.json` gives medians;
// the names are hull/points/count/method.
//
// ball, cube: uniform.  sphere: nearly all are vertices.  grid: all integers of a cube, shuffled, with 8 vertices.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "bench/rivals/hull_rival.hpp"
#include "bench/rivals/qhull_rival.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::bench {
namespace {

std::vector<Point3> points_of(const std::string& name, std::size_t count) {
  Entropy entropy(2026);
  if (name == "ball") return cloud3(Cloud::ball, count, entropy);
  if (name == "sphere") return cloud3(Cloud::sphere, count, entropy);
  if (name == "grid") return cloud3(Cloud::lattice, count, entropy);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {unit_coordinate(entropy), unit_coordinate(entropy), unit_coordinate(entropy)};
  return points;
}

/// Points are made when first asked for; those of one class and count stay for the next method.
struct Given {
  std::string name;
  std::vector<Point3> points;
};

const std::vector<Point3>& given(const std::string& name, std::size_t count) {
  static Given last;
  if (last.name != name || last.points.size() != count) last = {name, points_of(name, count)};
  return last.points;
}

using Method = std::function<std::size_t(const std::vector<Point3>&)>;

Method ours(HullOptions options) {
  return [options](const std::vector<Point3>& points) { return convex_hull(points, options).vertices.size(); };
}

void add(const std::string& name, std::size_t count, const std::string& method, const Method& run) {
  const std::string full = "hull/" + name + "/" + std::to_string(count) + "/" + method;
  benchmark::RegisterBenchmark(full.c_str(),
                               [=](benchmark::State& state) {
                                 const auto& points = given(name, count);
                                 std::size_t vertices = 0;
                                 for (auto _ : state) vertices = run(points);
                                 state.counters["vertices"] = static_cast<double>(vertices);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

const bool registered = [] {
  for (const std::string name : {"ball", "cube", "grid", "sphere"}) {
    for (const std::size_t count : {10'000, 100'000, 1'000'000}) {
      add(name, count, "plumb", ours({}));
      add(name, count, "plumb_all_points", ours({.all_boundary_points = true}));
      add(name, count, "plumb_incremental", ours({.method = HullMethod::incremental}));
      add(name, count, "qhull", [](const std::vector<Point3>& points) { return qhull_vertices(points); });
      const std::string full = "hull/" + name + "/" + std::to_string(count) + "/cgal_epick";
      benchmark::RegisterBenchmark(full.c_str(),
                                   [=](benchmark::State& state) {
                                     const CgalPoints points(given(name, count));
                                     std::size_t vertices = 0;
                                     for (auto _ : state) vertices = points.hull_vertices();
                                     state.counters["vertices"] = static_cast<double>(vertices);
                                   })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

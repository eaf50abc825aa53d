// How long do hulls in the plane take, beside Qhull's and CGAL's?  The same points, in the same run; the names are
// hull2/points/count/method.
//
// disk, square: uniform.  circle: nearly all are vertices.  grid: all integers of a square, in a scrambled order.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "bench/rivals/hull2_rival.hpp"
#include "bench/rivals/qhull_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/hull/hull2.hpp"

namespace plumb::bench {
namespace {

std::vector<Point2> points_of(const std::string& name, std::size_t count) {
  Entropy entropy(2026);
  std::vector<Point2> points;
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  for (std::size_t i = 0; points.size() < (name == "grid" ? side * side : count); ++i) {
    const std::size_t mixed = i * 7919 % (side * side);
    Point2 p{signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)};
    const double r = std::hypot(p.x, p.y);
    if (name == "grid") p = {static_cast<double>(mixed % side), static_cast<double>(mixed / side)};
    if ((name == "disk" || name == "circle") && !(r > 0x1p-10 && r <= 1)) continue;
    if (name == "circle") p = {p.x / r, p.y / r};
    points.push_back(p);
  }
  return points;
}

/// Points are made when first asked for; those of one class and count stay for the next method.
const std::vector<Point2>& given(const std::string& name, std::size_t count) {
  static std::string of;
  static std::vector<Point2> last;
  const std::string wanted = name + std::to_string(count);
  if (of != wanted) {
    last = points_of(name, count);
    of = wanted;
  }
  return last;
}

using Run = std::function<std::size_t()>;

/// `prepare` makes of the points what is measured.
void add(const std::string& name, std::size_t count, const std::string& method,
         const std::function<Run(const std::vector<Point2>&)>& prepare) {
  const std::string full = "hull2/" + name + "/" + std::to_string(count) + "/" + method;
  benchmark::RegisterBenchmark(full.c_str(),
                               [=](benchmark::State& state) {
                                 const Run run = prepare(given(name, count));
                                 std::size_t vertices = 0;
                                 for (auto _ : state) vertices = run();
                                 state.counters["vertices"] = static_cast<double>(vertices);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

std::function<Run(const std::vector<Point2>&)> ours(Hull2Options options) {
  return [options](const std::vector<Point2>& points) -> Run {
    return [&points, options] { return convex_hull(points, options).vertices.size(); };
  };
}

const bool registered = [] {
  for (const std::string name : {"disk", "square", "grid", "circle"}) {
    for (const std::size_t count : std::initializer_list<std::size_t>{10'000, 1'000'000}) {
      add(name, count, "chain", ours({}));
      add(name, count, "chain_parallel", ours({.execution = Execution::parallel}));
      add(name, count, "chain_all_points", ours({.all_boundary_points = true}));
      add(name, count, "chain_unfiltered", ours({.prefilter = false}));
      add(name, count, "quickhull", ours({.method = Hull2Method::quickhull}));
      add(name, count, "qhull",
          [](const std::vector<Point2>& points) -> Run { return [&points] { return qhull_vertices(points); }; });
      add(name, count, "cgal_epick", [](const std::vector<Point2>& points) -> Run {
        return [held = CgalPoints2(points)] { return held.hull_vertices(); };
      });
    }
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

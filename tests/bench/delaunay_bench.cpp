// How long do CGAL's triangulations and hulls take on our signs, beside Epick's?  The same points, in the same run:
// `bench_delaunay --benchmark_repetitions=5 --benchmark_report_aggregates_only` gives medians; the names are
// algorithm/points/count/kernel.
//
// uniform: doubles in [0, 1).  grid20: random points of the grid of 20-bit integers.  lattice: all points of a cube of
// integers, where nearly every sphere has more points on it than it needs.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/certify/cgal_kernel.hpp"
#include "plumb/degenerate/coordinates.hpp"

namespace plumb::bench {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<Point3> random_points(std::size_t count, bool grid) {
  Entropy entropy(2026);
  const auto coordinate = [&] { return grid ? static_cast<double>(entropy.bits(20)) : unit_coordinate(entropy); };
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

std::vector<Point3> lattice_points(std::size_t count, int dimension) {
  const auto edge = static_cast<int>(std::lround(std::pow(static_cast<double>(count), 1.0 / dimension)));
  std::vector<Point3> points;
  for (int i = 0; i < edge; ++i) {
    for (int j = 0; j < edge; ++j) {
      for (int k = 0; k < (dimension == 3 ? edge : 1); ++k) {
        points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
      }
    }
  }
  return points;
}

std::vector<Point3> points_named(const std::string& name, std::size_t count, int dimension) {
  return name == "lattice" ? lattice_points(count, dimension) : random_points(count, name == "grid20");
}

struct Delaunay2 {
  static constexpr const char* name = "delaunay_2";
  static constexpr int dimension = 2;
  template <class Kernel>
  static std::size_t run(const std::vector<typename Kernel::Point_2>& p) {
    return CGAL::Delaunay_triangulation_2<Kernel>(p.begin(), p.end()).number_of_faces();
  }
};

struct Delaunay3 {
  static constexpr const char* name = "delaunay_3";
  static constexpr int dimension = 3;
  template <class Kernel>
  static std::size_t run(const std::vector<typename Kernel::Point_3>& p) {
    return CGAL::Delaunay_triangulation_3<Kernel>(p.begin(), p.end()).number_of_cells();
  }
};

struct ConvexHull3 {
  static constexpr const char* name = "convex_hull_3";
  static constexpr int dimension = 3;
  template <class Kernel>
  static std::size_t run(const std::vector<typename Kernel::Point_3>& p) {
    CGAL::Surface_mesh<typename Kernel::Point_3> hull;
    CGAL::convex_hull_3(p.begin(), p.end(), hull);
    return hull.number_of_faces();
  }
};

template <class Algorithm, class Kernel>
void measure(benchmark::State& state, const std::string& name, std::size_t count) {
  using Point = std::conditional_t<Algorithm::dimension == 2, typename Kernel::Point_2, typename Kernel::Point_3>;
  std::vector<Point> points;
  for (const Point3& p : points_named(name, count, Algorithm::dimension)) {
    if constexpr (Algorithm::dimension == 2) {
      points.emplace_back(p.x, p.y);
    } else {
      points.emplace_back(p.x, p.y, p.z);
    }
  }
  for (auto _ : state) benchmark::DoNotOptimize(Algorithm::template run<Kernel>(points));
  state.counters["ns_per_point"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(points.size()) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Algorithm>
void add() {
  for (const std::size_t count : {100'000U, 1'000'000U}) {
    for (const std::string name : {"uniform", "grid20", "lattice"}) {
      const std::string place = std::string(Algorithm::name) + "/" + name + "/" + std::to_string(count) + "/";
      const auto with = [&](const std::string& kernel, auto run) {
        benchmark::RegisterBenchmark((place + kernel).c_str(), run, name, count)->Unit(benchmark::kMillisecond);
      };
      with("epick", measure<Algorithm, Epick>);
      with("plumb", measure<Algorithm, CgalKernel>);
    }
  }
}

[[maybe_unused]] const bool registered = [] {
  add<Delaunay2>();
  add<Delaunay3>();
  add<ConvexHull3>();
  return true;
}();

}  // namespace
}  // namespace plumb::bench

// What do bounding spheres cost, and how tight are they?  Names are fit/points/count/method; beside CGAL's
// Min_sphere_of_spheres_d in doubles on the same points, and overlap tests beside the same test in plain doubles.
//
// ball: uniform in a ball.  long: uniform in a box of 8 : 2 : 1, turned.  grid: integers of 10 bits.  sphere: on a
// sphere but for roundings.  Counter `radius`: over the least radius.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/rivals/sphere_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/sphere/fits.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb::bench {
namespace {

std::vector<Point3> points_of(const std::string& kind, std::size_t count) {
  Entropy entropy(2026);
  std::vector<Point3> points;
  while (points.size() < count) {
    const double x = signed_unit_coordinate(entropy), y = signed_unit_coordinate(entropy),
                 z = signed_unit_coordinate(entropy), d = x * x + y * y + z * z;
    if (kind == "ball" && d <= 1) points.push_back({x, y, z});
    if (kind == "long") points.push_back({8 * x + 2 * y, 8 * x - 2 * y + z, 4 * x - z});
    if (kind == "grid") points.push_back({std::floor(x * 512), std::floor(y * 512), std::floor(z * 512)});
    if (kind == "sphere" && d > 0.01) points.push_back({x / std::sqrt(d), y / std::sqrt(d), z / std::sqrt(d)});
  }
  return points;
}

std::span<const double> numbers(const std::vector<Point3>& points) { return {&points[0].x, 3 * points.size()}; }

std::span<const double> numbers(const std::vector<Sphere3>& balls) { return {&balls[0].center.x, 4 * balls.size()}; }

using Fit = Sphere3 (*)(std::span<const Point3>);

void fit(benchmark::State& state, const std::string& kind, Fit method) {
  const std::vector<Point3> points = points_of(kind, static_cast<std::size_t>(state.range(0)));
  Sphere3 s{};
  for (auto _ : state) {
    const Sphere3 found = method(points);
    benchmark::DoNotOptimize(found);
    s = found;
  }
  state.counters["radius"] = s.radius / minimum_sphere(points).sphere.radius;
}

void cgal(benchmark::State& state, const std::string& kind) {
  const std::vector<Point3> points = points_of(kind, static_cast<std::size_t>(state.range(0)));
  const auto find = cgal_minimum_sphere(numbers(points));
  double r = 0;
  for (auto _ : state) {
    const double found = find();
    benchmark::DoNotOptimize(found);
    r = found;
  }
  state.counters["radius"] = r / minimum_sphere(points).sphere.radius;
}

/// Balls that meet in half of the cases.
std::vector<Sphere3> balls_of(std::size_t count) {
  Entropy entropy(2027);
  std::vector<Sphere3> balls;
  for (std::size_t i = 0; i < count; ++i) {
    balls.push_back({{unit_coordinate(entropy), unit_coordinate(entropy), unit_coordinate(entropy)},
                     0.2 + 0.25 * unit_coordinate(entropy)});
  }
  return balls;
}

void of_balls(benchmark::State& state, bool ours) {
  const std::vector<Sphere3> balls = balls_of(static_cast<std::size_t>(state.range(0)));
  const auto find = cgal_minimum_sphere_of_balls(numbers(balls));
  double r = 0;
  for (auto _ : state) {
    const double found = ours ? minimum_sphere(balls).sphere.radius : find();
    benchmark::DoNotOptimize(found);
    r = found;
  }
  state.counters["radius"] = r / minimum_sphere(balls).sphere.radius;
}

bool plain_overlap(const Sphere3& a, const Sphere3& b) {
  const double x = a.center.x - b.center.x, y = a.center.y - b.center.y, z = a.center.z - b.center.z;
  const double r = a.radius + b.radius;
  return x * x + y * y + z * z <= r * r;
}

template <class Test>
void overlap(benchmark::State& state, Test test) {
  const std::vector<Sphere3> balls = balls_of(8192);
  int hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) hits += test(balls[i], balls[i + 1]) ? 1 : 0;
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(balls.size() - 1);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(balls.size() - 1));
}

void add(const std::string& name, std::int64_t count, void (*run)(benchmark::State&, const std::string&, Fit),
         const std::string& kind, Fit method) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run(state, kind, method); })
      ->Arg(count)
      ->Unit(benchmark::kMicrosecond);
}

[[maybe_unused]] const bool registered = [] {
  const std::vector<std::pair<std::string, Fit>> fits = {
      {"minimum_sphere", [](std::span<const Point3> p) { return minimum_sphere(p).sphere; }},
      {"fit_sphere_box", fit_sphere_box},
      {"fit_sphere_ritter", fit_sphere_ritter},
      {"fit_sphere_principal", fit_sphere_principal},
      {"fit_sphere_iterated_ritter", [](std::span<const Point3> p) { return fit_sphere_iterated_ritter(p); }}};
  for (const std::string kind : {"ball", "long", "grid", "sphere"}) {
    for (const std::int64_t count : {10000, 100000, 1000000}) {
      if (kind != "ball" && count != 10000) continue;
      for (const auto& [name, method] : fits) add(name + "/" + kind, count, fit, kind, method);
      benchmark::RegisterBenchmark(("cgal_minimum_sphere/" + kind).c_str(),
                                   [=](benchmark::State& state) { cgal(state, kind); })
          ->Arg(count)
          ->Unit(benchmark::kMicrosecond);
    }
  }
  for (const bool ours : {true, false}) {
    const char* name = ours ? "minimum_sphere_of_spheres" : "cgal_minimum_sphere_of_spheres";
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { of_balls(state, ours); })
        ->Arg(100)
        ->Arg(10000)
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::RegisterBenchmark("overlap/plain", [](benchmark::State& s) { overlap(s, plain_overlap); });
  benchmark::RegisterBenchmark("overlap/intersects", [](benchmark::State& s) {
    overlap(s, [](const Sphere3& a, const Sphere3& b) { return intersects(a, b); });
  });
  benchmark::RegisterBenchmark("overlap/relate", [](benchmark::State& s) {
    overlap(s, [](const Sphere3& a, const Sphere3& b) { return relate(a, b) != Relation::disjoint; });
  });
  benchmark::RegisterBenchmark("merge/two", [](benchmark::State& s) {
    overlap(s, [](const Sphere3& a, const Sphere3& b) { return merge(a, b).radius > 0.5; });
  });
  benchmark::RegisterBenchmark("transform/turned", [](benchmark::State& s) {
    const double c = std::cos(1.0), t = std::sin(1.0);
    const Pose pose{{Vector3{c, t, 0}, {-t, c, 0}, {0, 0, 1}}, {1, 2, 3}};
    overlap(s, [&](const Sphere3& a, const Sphere3&) { return transform(a, pose).radius > 0.3; });
  });
  return true;
}();

}  // namespace
}  // namespace plumb::bench

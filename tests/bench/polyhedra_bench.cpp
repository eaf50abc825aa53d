// What does it cost to relate convex polyhedra and k-DOPs that touch, overlap or lie apart?  Names are
// pair/case/vertices of the polyhedron.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb::bench {
namespace {

ConvexPolyhedron3 prism(std::int64_t vertices, double radius, const Point2& center, double bottom) {
  std::vector<Point3> points;
  for (std::int64_t i = 0; i < vertices / 2; ++i) {
    const double angle = 4 * 3.141592653589793 * static_cast<double>(i) / static_cast<double>(vertices);
    const double x = center.x + radius * std::cos(angle), y = center.y + radius * std::sin(angle);
    points.push_back({x, y, bottom});
    points.push_back({x, y, bottom + 1});
  }
  return convex_polyhedron(convex_hull(points), points);
}

/// Runs for prisms of 8, 50 and 200 vertices, the first of which has its top at height 1.
template <class Make>
void add(const char* name, Make other) {
  for (const std::int64_t vertices : {8, 50, 200}) {
    benchmark::RegisterBenchmark(name, [other](benchmark::State& state) {
      const ConvexPolyhedron3 a = prism(state.range(0), 1, {0, 0}, 0);
      const auto b = other(state.range(0));
      for (auto _ : state) benchmark::DoNotOptimize(relate(a, b));
    })->Arg(vertices);
  }
}
template <class Make>
void add_k_dop(const char* name, Make other) {
  benchmark::RegisterBenchmark(name, [other](benchmark::State& state) {
    const KDop3 a = fit_k_dop(prism(16, 0.7, {0.3, 0.2}, 1).mesh.vertices, 26);
    const auto b = other();
    for (auto _ : state) benchmark::DoNotOptimize(relate(a, b));
  });
}

[[maybe_unused]] const bool registered = [] {
  add("polyhedra/apart", [](std::int64_t n) { return prism(n, 1, {5, 5}, 0); });
  add("polyhedra/overlapping", [](std::int64_t n) { return prism(n, 0.7, {0.3, 0.2}, 0.5); });
  add("polyhedra/face_on_face", [](std::int64_t n) { return prism(n, 0.7, {0.3, 0.2}, 1); });
  add("polyhedra/an_ulp_apart", [](std::int64_t n) { return prism(n, 0.7, {0.3, 0.2}, 0x1.0000000000001p0); });
  add("polyhedra/themselves", [](std::int64_t n) { return prism(n, 1, {0, 0}, 0); });
  add("polyhedron_triangle/on_face", [](std::int64_t) {
    return Triangle3{{-0.2, 0.1, 1}, {0.3, 0.2, 1}, {0, 0.5, 1}};
  });
  add("polyhedron_aabb/face_on_face", [](std::int64_t) { return Aabb3{{-2, -2, 1}, {2, 2, 3}}; });
  add("polyhedron_plane/on_face", [](std::int64_t) { return Plane3{{0, 0, 3}, 3}; });
  add("polyhedron_k_dop/face_on_face", [](std::int64_t n) {
    return fit_k_dop(prism(n, 0.7, {0.3, 0.2}, 1).mesh.vertices, 26);
  });
  add_k_dop("k_dop_triangle/overlapping", [] { return Triangle3{{-1, -1, 1}, {2, 0, 1.5}, {0, 2, 3}}; });
  add_k_dop("k_dop_triangle/touching", [] { return Triangle3{{-1, -1, 1}, {2, 0, 1}, {0, 2, 1}}; });
  add_k_dop("k_dop_aabb/overlapping", [] { return Aabb3{{0, 0, 1.5}, {2, 2, 3}}; });
  add_k_dop("k_dop_obb/touching", [] { return Obb3{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 1, 1}}; });
  return true;
}();

}  // namespace
}  // namespace plumb::bench

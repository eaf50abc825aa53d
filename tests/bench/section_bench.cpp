// How long do sections take?  One plane, and many of one axis, beside a slicer in plain doubles on the same meshes.
//
// The plain slicer sorts triangles to heights in the same way, computes each segment's ends in doubles and joins ends
// that agree in their edge; it decides no turn and no nesting, and knows no rule but `<` for what lies in a plane.
// Meshes: a torus of n triangles, flat-faced (its coordinates rounded to a grid, planes at its vertices) and round.
// `s_cut` is the time, in seconds, of each triangle that is cut; `s_triangle` of each of the mesh.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/surface.hpp"

namespace plumb::bench {
namespace {

TriangleMesh mesh_of(std::uint32_t around, bool grid) {
  TriangleMesh mesh = solids::torus(300, 100, around, around / 2);
  if (!grid) return mesh;
  for (Point3& p : mesh.vertices) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
  return mesh;
}

std::vector<double> heights_of(int planes) {
  std::vector<double> heights;
  for (int i = 0; i < planes; ++i) heights.push_back(std::round(-99.0 + 198.0 * (i + 0.5) / planes));
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// The contours' points, joined.
std::vector<std::vector<Point2>> plain_section(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
                                               double z) {
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  };
  std::unordered_map<std::uint64_t, std::pair<std::uint64_t, Point2>> next;
  for (const std::uint32_t t : triangles) {
    const TriangleMesh::Triangle& v = mesh.triangles[t];
    std::uint64_t from = 0, to = 0;
    Point2 at{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &p = mesh.vertices[v[k]], &q = mesh.vertices[v[(k + 1) % 3]];
      if ((p.z < z) == (q.z < z)) continue;
      if (p.z < z) {
        to = key(v[k], v[(k + 1) % 3]);
      } else {
        from = key(v[k], v[(k + 1) % 3]);
        const double s = (z - p.z) / (q.z - p.z);
        at = {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)};
      }
    }
    if (from != to) next[from] = {to, at};
  }
  std::vector<std::vector<Point2>> contours;
  while (!next.empty()) {
    auto& contour = contours.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      contour.push_back(at->second.second);
      const std::uint64_t then = at->second.first;
      next.erase(at);
      at = next.find(then);
    }
  }
  return contours;
}

std::size_t plain_sections(const TriangleMesh& mesh, const std::vector<double>& heights) {
  std::vector<std::vector<std::uint32_t>> at(heights.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& v = mesh.triangles[t];
    const auto [low, high] = std::minmax({mesh.vertices[v[0]].z, mesh.vertices[v[1]].z, mesh.vertices[v[2]].z});
    for (auto h = std::lower_bound(heights.begin(), heights.end(), low); h != heights.end() && *h <= high; ++h)
      at[static_cast<std::size_t>(h - heights.begin())].push_back(static_cast<std::uint32_t>(t));
  }
  std::size_t corners = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    for (const auto& contour : plain_section(mesh, at[i], heights[i])) corners += contour.size();
  }
  return corners;
}

enum class Method { plain, plumb, oblique };

void run(benchmark::State& state, Method method, bool grid) {
  const ThreadLimit one(1);
  const TriangleMesh mesh = mesh_of(static_cast<std::uint32_t>(state.range(0)), grid);
  const std::vector<double> heights = heights_of(static_cast<int>(state.range(1)));
  std::vector<AnyPlane3> planes;
  for (const double h : heights) {
    planes.emplace_back(method == Method::oblique ? Plane3{{0.25, 0.5, 1}, h} : Plane3{{0, 0, 1}, h});
  }
  std::size_t corners = 0;
  for (auto _ : state) {
    if (method == Method::plain) {
      corners = plain_sections(mesh, heights);
    } else {
      corners = 0;
      for (const Section& s : sections(mesh, planes)) {
        for (const Contour& c : s.contours) corners += c.corners.size();
      }
    }
    benchmark::DoNotOptimize(corners);
  }
  std::size_t cut = 0;
  for (const Section& s : sections(mesh, planes)) cut += s.cut_triangles;
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["corners"] = static_cast<double>(corners);
  state.counters["ns_cut"] = benchmark::Counter(
      static_cast<double>(cut) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Pillars through a plate, each a contour in its outline.
void many_contours(benchmark::State& state) {
  const ThreadLimit one(1);
  const auto n = static_cast<std::uint32_t>(state.range(0));
  TriangleMesh mesh = solids::pillars(n);
  solids::append(mesh, solids::box({0, 0, -1}, {double(n), double(n), 1}));
  std::size_t contours = 0;
  for (auto _ : state) contours = section(mesh, Plane3{{0, 0, 1}, 0.5}).contours.size();
  state.counters["ns_contour"] =
      benchmark::Counter(static_cast<double>(contours) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void topology(benchmark::State& state, int what) {
  const TriangleMesh mesh = mesh_of(static_cast<std::uint32_t>(state.range(0)), false);
  for (auto _ : state) {
    if (what == 0) benchmark::DoNotOptimize(find_edges(mesh));
    if (what == 1) benchmark::DoNotOptimize(mesh_statistics(mesh));
    if (what == 2) benchmark::DoNotOptimize(first_equal(mesh.vertices));
  }
  state.counters["ns_triangle"] =
      benchmark::Counter(static_cast<double>(mesh.triangles.size()) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

[[maybe_unused]] const bool registered = [] {
  for (const bool grid : {false, true}) {
    for (const auto& [name, method] : {std::pair("plain", Method::plain), std::pair("plumb", Method::plumb),
                                       std::pair("plumb_oblique", Method::oblique)}) {
      benchmark::RegisterBenchmark((std::string("section/") + name + (grid ? "/grid" : "/round")).c_str(), run, method,
                                   grid)
          ->Args({1000, 1})
          ->Args({1000, 100})
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::RegisterBenchmark("section/pillars", many_contours)
      ->Arg(30)
      ->Arg(100)
      ->Arg(300)
      ->Unit(benchmark::kMillisecond);
  for (const auto& [name, what] :
       {std::pair("find_edges", 0), std::pair("mesh_statistics", 1), std::pair("first_equal", 2)})
    benchmark::RegisterBenchmark(name, topology, what)->Arg(1000)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

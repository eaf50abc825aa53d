// How long does a BSP tree of solid leaves take to be built and asked, and how many polygons does a plane split in a
// second?  Of a wavy ring of 99,856 triangles, beside the Bvh of the same mesh.
//
// Counters: `each`, the time for each point or ray; `splits`, pieces of polygons that were cut in two, a second, of planes
// across the axes and of planes of faces through the middle of all.  One thread.
#include <benchmark/benchmark.h>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bsp/piece_list.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

const TriangleMesh& bsp_ring() {
  static const TriangleMesh mesh = meshes::ring(158);
  return mesh;
}
const BspTree& bsp_of_ring() {
  static const BspTree tree = build_bsp(bsp_ring());
  return tree;
}
const Bvh& bvh_of_ring() {
  static const Bvh bvh = build_bvh(bsp_ring());
  return bvh;
}

std::vector<Point3> places_about_ring() {
  Entropy e(92);
  std::vector<Point3> points(100'000);
  for (Point3& p : points) p = {3 * unit_coordinate(e) - 1.5, 3 * unit_coordinate(e) - 1.5, unit_coordinate(e) - 0.5};
  return points;
}

void each(benchmark::State& state, std::size_t n) {
  state.counters["each"] = benchmark::Counter(
      static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void build(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(build_bsp(bsp_ring()).report.nodes);
  each(state, bsp_ring().triangles.size());
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

template <class Index>
void located(benchmark::State& state, const Index& index) {
  const std::vector<Point3> points = places_about_ring();
  std::size_t inside = 0;
  for (auto _ : state) {
    for (const Point3& p : points) inside += locate(index, p) == Location::inside ? 1 : 0;
  }
  benchmark::DoNotOptimize(inside);
  each(state, points.size());
}
void point_bsp(benchmark::State& state) { located(state, bsp_of_ring()); }
void point_bvh(benchmark::State& state) { located(state, bvh_of_ring()); }
BENCHMARK(point_bsp)->Unit(benchmark::kMillisecond);
BENCHMARK(point_bvh)->Unit(benchmark::kMillisecond);

template <class Index>
void shot(benchmark::State& state, const Index& index) {
  const std::vector<Point3> points = places_about_ring();
  std::size_t hits = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i + 1 < points.size() / 4; ++i) {
      const Point3 &p = points[i], &q = points[i + 1];
      hits += first_hit(index, Ray3{p, {q.x - p.x, q.y - p.y, q.z - p.z}}) ? 1 : 0;
    }
  }
  benchmark::DoNotOptimize(hits);
  each(state, points.size() / 4 - 1);
}
void ray_bsp(benchmark::State& state) { shot(state, bsp_of_ring()); }
void ray_bvh(benchmark::State& state) { shot(state, bvh_of_ring()); }
BENCHMARK(ray_bsp)->Unit(benchmark::kMillisecond);
BENCHMARK(ray_bvh)->Unit(benchmark::kMillisecond);

/// Triangles across the middle, one plane after the other, each cutting what the one before left.
void splits(benchmark::State& state, bool by_axes) {
  Entropy e(93);
  BspTree tree;
  space::PieceList all;
  for (std::uint32_t f = 0; f < 1000; ++f) {
    const auto any = [&] { return 2 * unit_coordinate(e) - 1; };
    for (std::uint32_t k = 0; k < 3; ++k) {
      tree.mesh.corners.push_back(static_cast<std::uint32_t>(tree.mesh.vertices.size()));
      tree.mesh.vertices.push_back({any(), any(), any()});
    }
    tree.mesh.first.push_back(static_cast<std::uint32_t>(tree.mesh.corners.size()));
    tree.planes.push_back({tree.vertex(f, 0), tree.vertex(f, 1), tree.vertex(f, 2)});
    if (f >= 4) space::add_polygon(tree, f, all);
  }
  for (std::uint32_t i = 0; i < 4; ++i) tree.axis_planes.push_back({i % 3, 0.1 * i - 0.15});
  std::size_t cut = 0;
  for (auto _ : state) {
    space::PieceList pieces = all;
    for (std::uint32_t i = 0; i < 4; ++i) {
      space::DividedPieces parts = divided(tree, pieces, (by_axes ? BspCorner::axis_plane : BspCorner::face_plane) | i);
      cut += parts.splits;
      pieces = std::move(parts.front);
      for (const auto& p : parts.back.pieces) pieces.add(p.face, parts.back.corners_of(p), false);
    }
  }
  state.counters["splits"] = benchmark::Counter(static_cast<double>(cut), benchmark::Counter::kIsRate);
}
void splits_by_axes(benchmark::State& state) { splits(state, true); }
void splits_by_faces(benchmark::State& state) { splits(state, false); }
BENCHMARK(splits_by_axes)->Unit(benchmark::kMillisecond);
BENCHMARK(splits_by_faces)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb::bench

// How long does an octree take to be built, asked and walked through?  Beside CGAL's, with as many points in a leaf;
// and a BSP tree of solid leaves?
//
// Points: uniform in a cube, or in a thousand clusters a thousandth as wide; the first argument says how many, the
// second how many there are in a leaf at most.  Boxes: cubes of which each meets some eight others.  Counter: `each`,
// the time for each point, box, place or leaf.  One thread.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/rivals/octree/cgal_octree.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bsp/piece_list.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

enum class Spread { uniform, clustered };

std::vector<Point3> points_of(Spread spread, std::int64_t n) {
  Entropy e(91);
  std::vector<Point3> centers(1000), points;
  for (Point3& c : centers) c = {unit_coordinate(e), unit_coordinate(e), unit_coordinate(e)};
  for (std::int64_t i = 0; i < n; ++i) {
    Point3 p{unit_coordinate(e), unit_coordinate(e), unit_coordinate(e)};
    if (spread == Spread::clustered) {
      const Point3& c = centers[e.below(centers.size())];
      p = {c.x + 1e-3 * p.x, c.y + 1e-3 * p.y, c.z + 1e-3 * p.z};
    }
    points.push_back(p);
  }
  return points;
}

std::vector<Aabb3> boxes_of(std::int64_t n) {
  const double side = 1 / std::cbrt(static_cast<double>(n));
  std::vector<Aabb3> boxes;
  for (const Point3& p : points_of(Spread::uniform, n)) {
    boxes.push_back({p, {p.x + side, p.y + side, p.z + side}});
  }
  return boxes;
}

void count(benchmark::State& state, std::size_t each) {
  state.counters["each"] = benchmark::Counter(static_cast<double>(each) * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

OctreeOptions options_of(const benchmark::State& state) {
  return {.most_in_leaf = static_cast<std::uint32_t>(state.range(1)), .execution = Execution::serial};
}

void build(benchmark::State& state, Spread spread) {
  const auto points = points_of(spread, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(build_octree(points, options_of(state)).cells.nodes.data());
  count(state, points.size());
}
void build_cgal(benchmark::State& state, Spread spread) {
  const auto points = points_of(spread, state.range(0));
  CgalOctree tree(points);
  for (auto _ : state) tree.build(static_cast<std::size_t>(state.range(1)), CellFrame<3>::levels);
  count(state, points.size());
}

void locate_all(benchmark::State& state, Spread spread) {
  const auto points = points_of(spread, state.range(0));
  const PointOctree tree = build_octree(points, options_of(state));
  std::size_t sum = 0;
  for (auto _ : state) {
    for (const Point3& p : points) sum += tree.cells.nodes[locate(tree.cells, p)].count();
  }
  benchmark::DoNotOptimize(sum);
  count(state, points.size());
}
void locate_all_cgal(benchmark::State& state, Spread spread) {
  const auto points = points_of(spread, state.range(0));
  CgalOctree tree(points);
  tree.build(static_cast<std::size_t>(state.range(1)), CellFrame<3>::levels);
  for (auto _ : state) benchmark::DoNotOptimize(tree.located());
  count(state, points.size());
}

void walk(benchmark::State& state, WalkedCells how) {
  const auto points = points_of(Spread::uniform, state.range(0));
  const PointOctree tree = build_octree(points, options_of(state));
  std::size_t leaves = 0, i = 0;
  for (auto _ : state) {
    leaves +=
        cells_along(tree.cells, Segment3{points[i % points.size()], points[(7 * i + 1) % points.size()]}, how).size();
    ++i;
  }
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(leaves), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void pairs(benchmark::State& state, CellRule rule) {
  const auto boxes = boxes_of(state.range(0));
  BoxOctreeOptions options{.most_in_leaf = static_cast<std::uint32_t>(state.range(1)), .execution = Execution::serial};
  options.rule = rule;
  for (auto _ : state) {
    benchmark::DoNotOptimize(overlapping_pairs(build_octree(boxes, options), {.execution = Execution::serial}).data());
  }
  count(state, boxes.size());
}
void loose_pairs(benchmark::State& state) {
  const auto boxes = boxes_of(state.range(0));
  for (auto _ : state) {
    LooseOctree tree({.world = {{0, 0, 0}, {2, 2, 2}}});
    for (const Aabb3& box : boxes) tree.insert(box);
    benchmark::DoNotOptimize(tree.overlapping_pairs({.execution = Execution::serial}).data());
  }
  count(state, boxes.size());
}
/// Each box by a tenth of its side.
void loose_moves(benchmark::State& state) {
  auto boxes = boxes_of(state.range(0));
  LooseOctree tree({.world = {{0, 0, 0}, {2, 2, 2}}});
  std::vector<BoxHandle> handles;
  for (const Aabb3& box : boxes) handles.push_back(tree.insert(box));
  const double by = 0.1 * (boxes[0].max.x - boxes[0].min.x);
  double sign = 1;
  for (auto _ : state) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i].min.x += sign * by, boxes[i].max.x += sign * by;
      tree.move(handles[i], boxes[i]);
    }
    sign = -sign;
  }
  count(state, boxes.size());
}

constexpr std::int64_t many = 100'000;
BENCHMARK_CAPTURE(build, uniform, Spread::uniform)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(build_cgal, uniform, Spread::uniform)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(build, clustered, Spread::clustered)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(build_cgal, clustered, Spread::clustered)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(locate_all, uniform, Spread::uniform)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(locate_all_cgal, uniform, Spread::uniform)->Args({many, 8})->Args({many, 20});
BENCHMARK_CAPTURE(locate_all, clustered, Spread::clustered)->Args({many, 20});
BENCHMARK_CAPTURE(locate_all_cgal, clustered, Spread::clustered)->Args({many, 20});
BENCHMARK_CAPTURE(walk, half_open, WalkedCells::half_open)->Args({many, 8});
BENCHMARK_CAPTURE(walk, closed, WalkedCells::closed)->Args({many, 8});
BENCHMARK_CAPTURE(pairs, smallest_cell, CellRule::smallest_cell)->Args({many, 8});
BENCHMARK_CAPTURE(pairs, every_leaf, CellRule::every_leaf)->Args({many, 8})->Args({many, 20});
BENCHMARK(loose_pairs)->Args({many});
BENCHMARK(loose_moves)->Args({many});

// BSP trees of solid leaves, of a wavy ring of 99,856 triangles, beside the Bvh of the same mesh.  Counter: `splits`, pieces
// of triangles that planes across the axes, or of faces, cut in two, a second.

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

void tell_each(benchmark::State& state, std::size_t n) {
  state.counters["each"] = benchmark::Counter(
      static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void bsp_build(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(build_bsp(bsp_ring()).report.nodes);
  tell_each(state, bsp_ring().triangles.size());
}
BENCHMARK(bsp_build)->Unit(benchmark::kMillisecond);

template <class Index>
void located(benchmark::State& state, const Index& index) {
  const std::vector<Point3> points = places_about_ring();
  std::size_t inside = 0;
  for (auto _ : state) {
    for (const Point3& p : points) inside += locate(index, p) == Location::inside ? 1 : 0;
  }
  benchmark::DoNotOptimize(inside);
  tell_each(state, points.size());
}
void bsp_point(benchmark::State& state) { located(state, bsp_of_ring()); }
void bsp_point_of_bvh(benchmark::State& state) { located(state, bvh_of_ring()); }
BENCHMARK(bsp_point)->Unit(benchmark::kMillisecond);
BENCHMARK(bsp_point_of_bvh)->Unit(benchmark::kMillisecond);

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
  tell_each(state, points.size() / 4 - 1);
}
void bsp_ray(benchmark::State& state) { shot(state, bsp_of_ring()); }
void bsp_ray_of_bvh(benchmark::State& state) { shot(state, bvh_of_ring()); }
BENCHMARK(bsp_ray)->Unit(benchmark::kMillisecond);
BENCHMARK(bsp_ray_of_bvh)->Unit(benchmark::kMillisecond);

/// Triangles across the middle, one plane after the other, each cutting what the one before left.
void bsp_splits(benchmark::State& state, bool by_axes) {
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
void bsp_splits_by_axes(benchmark::State& state) { bsp_splits(state, true); }
void bsp_splits_by_faces(benchmark::State& state) { bsp_splits(state, false); }
BENCHMARK(bsp_splits_by_axes)->Unit(benchmark::kMillisecond);
BENCHMARK(bsp_splits_by_faces)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb::bench

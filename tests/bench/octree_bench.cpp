// How long does an octree take to be built, asked and walked through?  Beside CGAL's, with as many points in a leaf.
//
// Points: uniform in a cube, or in a thousand clusters a thousandth as wide; the first argument says how many, the
// second how many there are in a leaf at most.  Boxes: cubes of which each meets some eight others.  Counter: `each`,
// the time for each point, box, place or leaf.  One thread.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/rivals/octree/cgal_octree.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"

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
    LooseOctree tree(Aabb3{{0, 0, 0}, {2, 2, 2}});
    for (const Aabb3& box : boxes) tree.insert(box);
    benchmark::DoNotOptimize(tree.overlapping_pairs({.execution = Execution::serial}).data());
  }
  count(state, boxes.size());
}
/// Each box by a tenth of its side.
void loose_moves(benchmark::State& state) {
  auto boxes = boxes_of(state.range(0));
  LooseOctree tree(Aabb3{{0, 0, 0}, {2, 2, 2}});
  for (const Aabb3& box : boxes) tree.insert(box);
  const double by = 0.1 * (boxes[0].max.x - boxes[0].min.x);
  double sign = 1;
  for (auto _ : state) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      boxes[i].min.x += sign * by, boxes[i].max.x += sign * by;
      tree.move(i, boxes[i]);
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

}  // namespace
}  // namespace plumb::bench

// What do grids cost: a walk a cell, beside the usual ones in doubles, and all pairs of boxes by each kind?  One
// thread.
//
// walk: 1,000 segments through 256^3 cells of size 0.1, between random places or through the corners of cells.
// `ns_cell` counts what begins a walk, too; `wrong` is how many of the 1,000 visit other cells than exact ones do
// (half open).
// accumulated is the walk of textbooks, which adds up parameters; recomputed divides anew at each wall.
// pairs: `ns_box` of building and asking, `pairs` a box, `bytes` a box.  uniform: boxes of mean extent 1, as many as
// fill space once; clustered: the same extents in 100 clusters; sizes: extents from 1 to 1,000, each octave as often.
// retests: one box at a time, in cells of half a box, where each comes up often; ns a query.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/grid_walk.hpp"
#include "plumb/space/grid/static_grid.hpp"
#include "plumb/space/textbook/box_store.hpp"

namespace plumb::bench {
namespace {

benchmark::Counter nanoseconds_each(std::size_t events) {
  return {static_cast<double>(events) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert};
}

class Numbers {
 public:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double normal() { return std::normal_distribution<double>()(random_); }

 private:
  std::mt19937_64 random_{7420};
};

constexpr std::size_t rays = 1000;
constexpr double cell = 0.1;
constexpr CellGrid3 grid{{0, 0, 0}, {cell, cell, cell}};

/// Between random places; or from one through a corner of a cell, as near as doubles come to it.
std::vector<Segment3> segments(bool corners) {
  Numbers numbers;
  std::vector<Segment3> all(rays);
  const auto place = [&] { return numbers.unit() * 256 * cell; };
  const auto corner = [&] { return (64 + std::floor(numbers.unit() * 128)) * cell; };
  for (Segment3& s : all) {
    s.a = {place(), place(), place()};
    s.b = {place(), place(), place()};
    if (!corners) continue;
    const Point3 c{corner(), corner(), corner()};
    s.b = {c.x + (c.x - s.a.x) / 4, c.y + (c.y - s.a.y) / 4, c.z + (c.z - s.a.z) / 4};
  }
  return all;
}

/// The usual walks, in doubles; visit(cell) is called for each.
template <bool accumulated, class Visit>
void plain_walk(const Segment3& s, const Visit& visit) {
  const double from[3] = {s.a.x, s.a.y, s.a.z}, to[3] = {s.b.x, s.b.y, s.b.z};
  Cell3 at, end;
  std::int64_t step[3];
  double time[3], pace[3], way[3];
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = static_cast<std::int64_t>(std::floor(from[a] / cell));
    end[a] = static_cast<std::int64_t>(std::floor(to[a] / cell));
    way[a] = to[a] - from[a];
    step[a] = way[a] > 0 ? 1 : -1;
    pace[a] = cell / std::abs(way[a]);
    time[a] = (static_cast<double>(at[a] + (way[a] > 0 ? 1 : 0)) * cell - from[a]) / way[a];
  }
  while (true) {
    visit(at);
    const std::size_t x_or_y = time[0] <= time[1] ? 0 : 1, a = time[x_or_y] <= time[2] ? x_or_y : 2;
    if (at[a] == end[a]) return;
    at[a] += step[a];
    if constexpr (accumulated) {
      time[a] += pace[a];
    } else {
      time[a] = (static_cast<double>(at[a] + (step[a] > 0 ? 1 : 0)) * cell - from[a]) / way[a];
    }
  }
}

template <WalkedCells cells, class Visit>
void exact_walk(const Segment3& s, const Visit& visit) {
  GridWalk3 walk(grid, s, {cells, {}});
  while (walk.next()) visit(walk.cell());
}

template <class Walk>
void walks(benchmark::State& state, bool corners, const Walk& walk) {
  const std::vector<Segment3> all = segments(corners);
  std::size_t visited = 0;
  for (auto _ : state) {
    std::int64_t sum = 0;
    for (const Segment3& s : all) {
      walk(s, [&](const Cell3& c) { sum += c[0] ^ c[1] << 8 ^ c[2] << 16, ++visited; });
    }
    benchmark::DoNotOptimize(sum);
  }
  std::size_t wrong = 0;
  for (const Segment3& s : all) {
    std::vector<Cell3> these, exact;
    walk(s, [&](const Cell3& c) { these.push_back(c); });
    exact_walk<WalkedCells::half_open>(s, [&](const Cell3& c) { exact.push_back(c); });
    wrong += these != exact ? 1 : 0;
  }
  state.counters["ns_cell"] = nanoseconds_each(visited);
  state.counters["wrong"] = static_cast<double>(wrong);
}

/// Of a kind of scene; extents are those along each axis.
std::vector<Aabb3> scene(const std::string& kind, std::size_t count) {
  Numbers numbers;
  std::vector<Aabb3> boxes(count);
  const double cube = std::cbrt(static_cast<double>(count));
  std::vector<Point3> clusters(100);
  for (Point3& c : clusters) c = {numbers.unit() * 4 * cube, numbers.unit() * 4 * cube, numbers.unit() * 4 * cube};
  std::size_t i = 0;
  for (Aabb3& b : boxes) {
    double scale = 1;
    Point3 p{numbers.unit() * cube, numbers.unit() * cube, numbers.unit() * cube};
    if (kind == "clustered") {
      const Point3& c = clusters[i++ % clusters.size()];
      const double spread = cube / 16;
      p = {c.x + numbers.normal() * spread, c.y + numbers.normal() * spread, c.z + numbers.normal() * spread};
    } else if (kind == "sizes") {
      scale = std::pow(1000, numbers.unit());
      p = {p.x * 215, p.y * 215, p.z * 215};
    }
    b = {p, p};
    for (double* x : {&b.max.x, &b.max.y, &b.max.z}) *x += scale * (0.5 + numbers.unit());
  }
  return boxes;
}

constexpr BoxPairOptions one_thread{.touching = true, .execution = Execution::serial};

/// build(boxes) makes a grid.
template <class Build>
void all_pairs(benchmark::State& state, const std::string& kind, const Build& build) {
  const std::vector<Aabb3> boxes = scene(kind, static_cast<std::size_t>(state.range(0)));
  std::size_t found = 0, bytes = 0, built = 0;
  for (auto _ : state) {
    const auto made = build(boxes);
    found = made.overlapping_pairs(one_thread).size();
    bytes = made.memory();
    built += boxes.size();
  }
  const auto count = static_cast<double>(boxes.size());
  state.counters["ns_box"] = nanoseconds_each(built);
  state.counters["pairs"] = static_cast<double>(found) / count;
  state.counters["bytes"] = static_cast<double>(bytes) / count;
}

template <class Grid>
Grid filled(Grid made, const std::vector<Aabb3>& boxes) {
  for (const Aabb3& b : boxes) made.insert(b);
  return made;
}
double chosen(const std::vector<Aabb3>& boxes) { return choose_cell_size(std::span(boxes)).size; }
Aabb3 around(const std::vector<Aabb3>& boxes) {
  Aabb3 all = boxes.front();
  for (const Aabb3& b : boxes) {
    all.min = {std::min(all.min.x, b.min.x), std::min(all.min.y, b.min.y), std::min(all.min.z, b.min.z)};
    all.max = {std::max(all.max.x, b.max.x), std::max(all.max.y, b.max.y), std::max(all.max.z, b.max.z)};
  }
  return all;
}

template <class Ask>
void retests(benchmark::State& state, Ask ask) {
  const std::vector<Aabb3> boxes = scene("uniform", 100'000);
  const HashedGrid3 made = filled(HashedGrid3({.cell_size = 0.5}), boxes);
  std::size_t asked = 0, found = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < 10'000; ++i) found += ask(made, boxes[i * 7 % boxes.size()]).size();
    asked += 10'000;
  }
  benchmark::DoNotOptimize(found);
  state.counters["ns"] = nanoseconds_each(asked);
}

void register_all() {
  for (const bool corners : {false, true}) {
    const std::string where = corners ? "walk/corners/" : "walk/random/";
    benchmark::RegisterBenchmark((where + "accumulated").c_str(), [=](benchmark::State& s) {
      walks(s, corners, [](const Segment3& x, const auto& visit) { plain_walk<true>(x, visit); });
    });
    benchmark::RegisterBenchmark((where + "recomputed").c_str(), [=](benchmark::State& s) {
      walks(s, corners, [](const Segment3& x, const auto& visit) { plain_walk<false>(x, visit); });
    });
    benchmark::RegisterBenchmark((where + "half_open").c_str(), [=](benchmark::State& s) {
      walks(s, corners, [](const Segment3& x, const auto& v) { exact_walk<WalkedCells::half_open>(x, v); });
    });
    benchmark::RegisterBenchmark((where + "closed").c_str(), [=](benchmark::State& s) {
      walks(s, corners, [](const Segment3& x, const auto& v) { exact_walk<WalkedCells::closed>(x, v); });
    });
  }
  using Boxes = std::vector<Aabb3>;
  for (const std::string kind : {"uniform", "clustered", "sizes"}) {
    const auto add = [&](const char* name, std::int64_t most, const auto& build) {
      auto* b = benchmark::RegisterBenchmark(("pairs/" + kind + "/" + name).c_str(),
                                             [=](benchmark::State& s) { all_pairs(s, kind, build); });
      for (std::int64_t n = 10'000; n <= most; n *= 10) b->Arg(n);
      b->Unit(benchmark::kMillisecond);
    };
    add("static", 100'000, [](const Boxes& b) { return StaticGrid3(b); });
    add("hierarchical", 100'000, [](const Boxes& b) { return filled(HierarchicalGrid3(), b); });
    add("implicit", 10'000, [](const Boxes& b) { return filled(ImplicitGrid3({.cell_size = chosen(b)}), b); });
    add("row_column", 10'000, [](const Boxes& b) { return filled(RowColumnGrid3(), b); });
    if (kind == "sizes") {  // of which a large box is in very many cells
      add("hashed", 10'000, [](const Boxes& b) { return filled(HashedGrid3({.cell_size = 8 * chosen(b)}), b); });
      continue;
    }
    add("hashed", 100'000, [](const Boxes& b) { return filled(HashedGrid3({.cell_size = chosen(b)}), b); });
    add("linked", 100'000,
        [](const Boxes& b) { return filled(LinkedGrid3({.world = around(b), .cell_size = chosen(b)}), b); });
  }
  benchmark::RegisterBenchmark("retests/lowest_cell", [](benchmark::State& s) {
    retests(s, [](const HashedGrid3& g, const Aabb3& b) { return g.in_box(b); });
  });
  benchmark::RegisterBenchmark("retests/stamps", [](benchmark::State& s) {
    retests(s, [seen = VisitStamps()](const HashedGrid3& g, const Aabb3& b) mutable { return g.in_box(b, seen); });
  });
  benchmark::RegisterBenchmark("retests/bits", [](benchmark::State& s) {
    retests(s, [seen = VisitBits()](const HashedGrid3& g, const Aabb3& b) mutable { return g.in_box(b, seen); });
  });
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  plumb::bench::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

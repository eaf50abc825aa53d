// How long does it take to find all pairs of boxes that overlap?  One thread; beside Embree, CGAL, Bullet, FCL and
// Boost's R-tree where they are there.
//
// Boxes: all over space with 8 pairs a box, in 100 clusters, of sizes from 1 to 1000, on a lattice where all touch; then
// boxes that move.  `ns_box` is the time of each box, `pairs` how many were found (rivals that round find others).
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/space/broad_phase/moving_boxes.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/sort_and_sweep/sweep_array.hpp"
#ifdef PLUMB_BENCH_BOX_PAIRS
#include "bench/rivals/box_pairs/rival.hpp"
#endif

namespace plumb::bench {
namespace {

double part(Entropy& e) { return static_cast<double>(e.bits(53)) * 0x1p-53; }

/// Of a middle length and up to a half more or less.
Aabb3 box_at(Entropy& e, const Point3& p, double length) {
  const auto edge = [&] { return length * (0.5 + part(e)); };
  return {p, {p.x + edge(), p.y + edge(), p.z + edge()}};
}

std::vector<Aabb3> uniform_boxes(std::size_t n, double pairs = 8) {
  Entropy e(1);
  std::vector<Aabb3> boxes;
  const double length = std::cbrt(pairs / 4 / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) boxes.push_back(box_at(e, {part(e), part(e), part(e)}, length));
  return boxes;
}

std::vector<Aabb3> clustered_boxes(std::size_t n) {
  Entropy e(2);
  constexpr double spread = 0.02;
  std::vector<Point3> middles;
  for (int i = 0; i < 100; ++i) middles.push_back({part(e), part(e), part(e)});
  const auto gauss = [&] {
    return spread * std::sqrt(-2 * std::log(1 - part(e))) * std::cos(2 * std::numbers::pi * part(e));
  };
  const double length = std::cbrt(2 * std::pow(4 * std::numbers::pi * spread * spread, 1.5) * 100 / double(n));
  std::vector<Aabb3> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& p = middles[e.below(100)];
    boxes.push_back(box_at(e, {p.x + gauss(), p.y + gauss(), p.z + gauss()}, length));
  }
  return boxes;
}

std::vector<Aabb3> boxes_of_all_sizes(std::size_t n) {
  Entropy e(3);
  std::vector<Aabb3> boxes;
  const double side = 1e4 * std::cbrt(static_cast<double>(n) / 1e5);
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 p{side * part(e), side * part(e), side * part(e)};
    const double length = std::pow(1000.0, part(e));
    boxes.push_back({p, {p.x + length, p.y + length, p.z + length}});
  }
  return boxes;
}

std::vector<Aabb3> touching_boxes(std::size_t n) {
  std::vector<Aabb3> boxes;
  const auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(n)) + 0.5);
  for (std::size_t i = 0; i < side * side * side; ++i) {
    const Point3 p{double(i % side), double(i / side % side), double(i / side / side)};
    boxes.push_back({p, {p.x + 1, p.y + 1, p.z + 1}});
  }
  return boxes;
}

void count_each(benchmark::State& state, std::size_t n, std::size_t pairs) {
  state.counters["ns_box"] = benchmark::Counter(
      static_cast<double>(n) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["pairs"] = static_cast<double>(pairs);
}

using Find = std::function<std::size_t(const std::vector<Aabb3>&)>;

Find by(BroadPhaseMethod method) {
  return [method](const std::vector<Aabb3>& boxes) {
    return overlapping_pairs(boxes, BroadPhaseOptions{.execution = Execution::serial, .method = method}).size();
  };
}

void add_all_at_once() {
  struct Named {
    const char* name;
    Find find;
  };
  static const std::vector<Named> finders = {
      {"plumb", by(BroadPhaseMethod::automatic)},
      {"plumb_sort_and_sweep", by(BroadPhaseMethod::sort_and_sweep)},
#ifdef PLUMB_BENCH_BOX_PAIRS
      {"embree", embree_box_pairs},
      {"cgal", cgal_box_pairs},
      {"bullet", bullet_box_pairs},
      {"fcl", fcl_box_pairs},
      {"boost", boost_box_pairs},
#endif
  };
  struct Scene {
    const char* name;
    std::vector<Aabb3> (*make)(std::size_t n);
    std::size_t n;
  };
  for (const auto& [scene, make, n] :
       {Scene{"uniform", [](std::size_t k) { return uniform_boxes(k); }, 100000},
        Scene{"clustered", clustered_boxes, 100000}, Scene{"sizes", boxes_of_all_sizes, 100000},
        Scene{"touching", touching_boxes, 27000},
        Scene{"uniform_few", [](std::size_t k) { return uniform_boxes(k); }, 3000},
        Scene{"uniform_million", [](std::size_t k) { return uniform_boxes(k); }, 1000000}}) {
    const auto boxes = std::make_shared<std::vector<Aabb3>>();
    for (const auto& [name, find] : finders) {
      benchmark::RegisterBenchmark((std::string(scene) + "/" + name).c_str(), [=, make = make, n = n,
                                                                               find = find](benchmark::State& state) {
        if (boxes->empty()) *boxes = make(n);
        std::size_t pairs = 0;
        for (auto _ : state) pairs = find(*boxes);
        count_each(state, boxes->size(), pairs);
      })->Unit(benchmark::kMillisecond);
    }
  }
}

/// Frames: each `every`th box takes a small step, forth and back by turns.
class Frames {
 public:
  Frames(std::size_t n, std::size_t every, double step) : boxes_(uniform_boxes(n)), every_(every) {
    Entropy e(4);
    const auto by = [&] { return step * (part(e) - 0.5) * std::cbrt(2 / static_cast<double>(n)); };
    for (std::size_t i = 0; i < n; ++i) steps_.push_back({by(), by(), by()});
  }
  const std::vector<Aabb3>& boxes() const { return boxes_; }
  /// The numbers of those that moved.
  const std::vector<std::size_t>& next() {
    moved_.clear();
    const double way = frame_ / 16 % 2 == 0 ? 1 : -1;
    for (std::size_t i = frame_ % every_; i < boxes_.size(); i += every_) {
      auto& [min, max] = boxes_[i];
      const Vector3& v = steps_[i];
      min = {min.x + way * v.x, min.y + way * v.y, min.z + way * v.z};
      max = {max.x + way * v.x, max.y + way * v.y, max.z + way * v.z};
      moved_.push_back(i);
    }
    ++frame_;
    return moved_;
  }

 private:
  std::vector<Aabb3> boxes_;
  std::vector<Vector3> steps_;
  std::vector<std::size_t> moved_;
  std::size_t every_, frame_ = 0;
};

void move_world(benchmark::State& state, std::size_t every, double step) {
  Frames frames(100000, every, step);
  MovingBoxes world;
  const auto handles = world.insert(frames.boxes());
  world.changes();
  std::vector<BoxHandle> of_moved;
  std::vector<Aabb3> boxes;
  std::size_t changed = 0, anew = 0, scratch = 0;
  for (auto _ : state) {
    state.PauseTiming();
    of_moved.clear(), boxes.clear();
    for (const std::size_t i : frames.next()) of_moved.push_back(handles[i]), boxes.push_back(frames.boxes()[i]);
    state.ResumeTiming();
    world.move(of_moved, boxes);
    const BoxPairChanges& changes = world.changes();
    changed += changes.added.size() + changes.lost.size();
    anew += changes.work.made_anew ? 1 : 0;
    scratch += changes.work.from_scratch ? 1 : 0;
  }
  count_each(state, frames.boxes().size(), changed / static_cast<std::size_t>(state.iterations()));
  state.counters["made_anew"] = static_cast<double>(anew) / static_cast<double>(state.iterations());
  state.counters["from_scratch"] = static_cast<double>(scratch) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(move_world, all_move_a_hundredth, 1, 0.02)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(move_world, all_move_a_twentieth, 1, 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(move_world, all_jump, 1, 20.0)->Unit(benchmark::kMillisecond)->Iterations(8);
BENCHMARK_CAPTURE(move_world, one_percent_moves_a_twentieth, 100, 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(move_world, one_percent_jumps, 100, 20.0)->Unit(benchmark::kMillisecond);

void move_sweep(benchmark::State& state) {
  Frames frames(3000, 1, 0.1);
  SweepArray sweep;
  sweep.overlapping_pairs(frames.boxes());
  std::size_t pairs = 0;
  for (auto _ : state) {
    state.PauseTiming();
    frames.next();
    state.ResumeTiming();
    pairs = sweep.overlapping_pairs(frames.boxes()).size();
  }
  count_each(state, frames.boxes().size(), pairs);
}
BENCHMARK(move_sweep)->Unit(benchmark::kMicrosecond);

#ifdef PLUMB_BENCH_BOX_PAIRS
template <class Rival>
void move_rival(benchmark::State& state, std::size_t n) {
  Frames frames(n, 1, 0.1);
  Rival rival(frames.boxes());
  std::size_t pairs = 0;
  for (auto _ : state) {
    state.PauseTiming();
    frames.next();
    state.ResumeTiming();
    pairs = rival.move(frames.boxes());
  }
  count_each(state, n, pairs);
}
void move_bullet_sweep(benchmark::State& state) { move_rival<BulletSweep>(state, 3000); }
void move_bullet_tree(benchmark::State& state) { move_rival<BulletTree>(state, 100000); }
BENCHMARK(move_bullet_sweep)->Unit(benchmark::kMicrosecond);
BENCHMARK(move_bullet_tree)->Unit(benchmark::kMillisecond)->Iterations(5);
#endif

const int registered = (add_all_at_once(), 0);

}  // namespace
}  // namespace plumb::bench

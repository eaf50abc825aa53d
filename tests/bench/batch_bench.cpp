// How long does a sign take in a batch?  For each instruction set: what the compiler makes of the bare formula and of
// the filter alone, then our batches over arrays of points, over arrays of coordinates, and over points against one
// line, plane, circle or sphere; every sign of ours is exact.  Cases fit the second-level cache.  Then single points
// against one of these, by the function and by the object, and a million cases on one thread and on all.
// `bench_batch --benchmark_format=json | python3 tests/bench/report/table.py` prints the table of docs/batches.md.
#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/rivals/batch_rival.hpp"
#include "certify/batch/take_instruction_set.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/side.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t in_cache = 4096;
constexpr std::size_t most = 15;

/// Uniform points: `point[p]` of case i is at p, i; `at[k]` has coordinate k of all cases.
struct Data {
  std::array<std::vector<Point2>, 5> flat;
  std::array<std::vector<Point3>, 5> solid;
  std::array<std::vector<double>, most> column;
  std::array<const double*, most> at{};
  std::vector<Sign> out = std::vector<Sign>(in_cache);

  Data() {
    Entropy entropy(2026);
    for (std::size_t p = 0; p < 5; ++p) {
      flat[p] = points2(Family::uniform, Degeneracy::cocircular, in_cache, entropy);
      solid[p] = points3(Family::uniform, Degeneracy::cospherical, in_cache, entropy);
    }
    for (std::size_t k = 0; k < most; ++k) {
      for (std::size_t i = 0; i < in_cache; ++i) {
        const Point3& q = solid[k / 3][i];
        column[k].push_back(k % 3 == 0 ? q.x : k % 3 == 1 ? q.y : q.z);
      }
      at[k] = column[k].data();
    }
  }
  [[nodiscard]] Points2View flat_view(std::size_t p) const { return {column[2 * p], column[2 * p + 1]}; }
  [[nodiscard]] Points3View solid_view(std::size_t p) const {
    return {column[3 * p], column[3 * p + 1], column[3 * p + 2]};
  }
};

const Data& data() {
  static const Data all;
  return all;
}

void add(std::string_view predicate, std::string_view set, const char* method, std::string_view taken,
         const std::function<void(std::vector<Sign>&)>& run) {
  const std::string name = std::string(predicate) + "/" + std::string(set) + "/" + method;
  benchmark::RegisterBenchmark(name.c_str(), [run, taken](benchmark::State& state) {
    certify::batch::take_instruction_set(taken);
    std::vector<Sign> out(in_cache);
    for (auto _ : state) {
      run(out);
      benchmark::DoNotOptimize(out.data());
      benchmark::ClobberMemory();
    }
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * in_cache * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    certify::batch::take_instruction_set({});
  });
}

std::string_view taken_for(std::string_view set) {
  return set == "AVX-512" ? "avx512" : set == "AVX2" ? "avx2" : set == "SSE" ? "ssse3" : "neon";
}

void add_ours(std::string_view predicate, std::string_view set, std::string_view taken) {
  using Out = std::vector<Sign>;
  const Data& d = data();
  const auto& f = d.flat;
  const auto& s = d.solid;
  const auto ours = [&](const char* method, const std::function<void(Out&)>& run) {
    add(predicate, set, method, taken, run);
  };
  if (predicate == "orient2d") {
    ours("points", [&](Out& out) { orient2d(f[0], f[1], f[2], out); });
    ours("arrays", [&](Out& out) { orient2d(d.flat_view(0), d.flat_view(1), d.flat_view(2), out); });
    const LineSide side{f[0][0], f[1][0]};
    ours("one, points", [&, side](Out& out) { side(f[2], out); });
    ours("one, arrays", [&, side](Out& out) { side(d.flat_view(2), out); });
  } else if (predicate == "orient3d") {
    ours("points", [&](Out& out) { orient3d(s[0], s[1], s[2], s[3], out); });
    ours("arrays",
         [&](Out& out) { orient3d(d.solid_view(0), d.solid_view(1), d.solid_view(2), d.solid_view(3), out); });
    const PlaneSide side{s[0][0], s[1][0], s[2][0]};
    ours("one, points", [&, side](Out& out) { side(s[3], out); });
    ours("one, arrays", [&, side](Out& out) { side(d.solid_view(3), out); });
  } else if (predicate == "incircle") {
    ours("points", [&](Out& out) { incircle(f[0], f[1], f[2], f[3], out); });
    ours("arrays", [&](Out& out) { incircle(d.flat_view(0), d.flat_view(1), d.flat_view(2), d.flat_view(3), out); });
    const CircleSide side{f[0][0], f[1][0], f[2][0]};
    ours("one, points", [&, side](Out& out) { side(f[3], out); });
    ours("one, arrays", [&, side](Out& out) { side(d.flat_view(3), out); });
  } else {
    ours("points", [&](Out& out) { insphere(s[0], s[1], s[2], s[3], s[4], out); });
    ours("arrays", [&](Out& out) {
      insphere(d.solid_view(0), d.solid_view(1), d.solid_view(2), d.solid_view(3), d.solid_view(4), out);
    });
    const SphereSide side{s[0][0], s[1][0], s[2][0], s[3][0]};
    ours("one, points", [&, side](Out& out) { side(s[4], out); });
    ours("one, arrays", [&, side](Out& out) { side(d.solid_view(4), out); });
  }
}

/// One case after the other.
template <class Function>
void add_singly(std::string_view predicate, const char* method, Function sign_of_case) {
  add(predicate, "single", method, {}, [sign_of_case](std::vector<Sign>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign_of_case(i);
  });
}

void add_single_points() {
  const auto& f = data().flat;
  const auto& s = data().solid;
  add_singly("orient2d", "function", [&](std::size_t i) { return orient2d(f[0][0], f[1][0], f[2][i]); });
  add_singly("orient2d", "side", [&, line = LineSide{f[0][0], f[1][0]}](std::size_t i) { return line(f[2][i]); });
  add_singly("orient3d", "function", [&](std::size_t i) { return orient3d(s[0][0], s[1][0], s[2][0], s[3][i]); });
  add_singly("orient3d", "side",
             [&, plane = PlaneSide{s[0][0], s[1][0], s[2][0]}](std::size_t i) { return plane(s[3][i]); });
  add_singly("incircle", "function", [&](std::size_t i) { return incircle(f[0][0], f[1][0], f[2][0], f[3][i]); });
  add_singly("incircle", "side",
             [&, circle = CircleSide{f[0][0], f[1][0], f[2][0]}](std::size_t i) { return circle(f[3][i]); });
  add_singly("insphere", "function",
             [&](std::size_t i) { return insphere(s[0][0], s[1][0], s[2][0], s[3][0], s[4][i]); });
  add_singly("insphere", "side",
             [&, sphere = SphereSide{s[0][0], s[1][0], s[2][0], s[3][0]}](std::size_t i) { return sphere(s[4][i]); });
}

// A user's own: three points of the plane, seven operations, and the classics as if they were a user's.
constexpr auto in_diametral_circle = [](auto ax, auto ay, auto bx, auto by, auto cx, auto cy) {
  return (ax - cx) * (cx - bx) + (ay - cy) * (cy - by);
};

void add_own_formulas() {
  const Data& d = data();
  const auto& f = d.flat;
  const auto& s = d.solid;
  add_singly("own", "function", [&](std::size_t i) { return sign_of(in_diametral_circle, f[0][i], f[1][i], f[2][i]); });
  add_singly("own insphere", "function", [&](std::size_t i) {
    return sign_of(predicates::InSphere{}, s[0][i], s[1][i], s[2][i], s[3][i], s[4][i]);
  });
  for (const std::string_view taken : batch_instruction_sets()) {
    add("own", taken, "points", taken,
        [&](std::vector<Sign>& out) { plumb::signs_of(in_diametral_circle, f[0], f[1], f[2], out); });
    add("own", taken, "arrays", taken, [&](std::vector<Sign>& out) {
      plumb::signs_of(in_diametral_circle, d.flat_view(0), d.flat_view(1), d.flat_view(2), out);
    });
    add("own insphere", taken, "points", taken,
        [&](std::vector<Sign>& out) { plumb::signs_of(predicates::InSphere{}, s[0], s[1], s[2], s[3], s[4], out); });
  }
}

/// By the clock on the wall: the time of a single thread says nothing here.
void add_million(const char* method, Execution execution) {
  const std::string name = std::string("insphere/million/") + method;
  benchmark::RegisterBenchmark(name.c_str(), [execution](benchmark::State& state) {
    constexpr std::size_t count = 1 << 20;
    std::array<std::vector<Point3>, 5> p;
    for (std::size_t k = 0; k < p.size(); ++k) {
      while (p[k].size() < count) p[k].insert(p[k].end(), data().solid[k].begin(), data().solid[k].end());
    }
    std::vector<Sign> out(count);
    const auto began = std::chrono::steady_clock::now();
    for (auto _ : state) insphere(p[0], p[1], p[2], p[3], p[4], out, execution);
    const std::chrono::duration<double, std::nano> lasted = std::chrono::steady_clock::now() - began;
    state.counters["ns"] = lasted.count() / static_cast<double>(state.iterations()) / count;
  });
}

[[maybe_unused]] const bool registered = [] {
  for (const Loop& loop : compiled_loops()) {
    const auto over = [](auto function) {
      return [function](std::vector<Sign>& out) {
        function(data().at.data(), out.size(), reinterpret_cast<signed char*>(out.data()));
      };
    };
    add(loop.predicate, loop.instruction_set, "bare loop", {}, over(loop.bare));
    add(loop.predicate, loop.instruction_set, "filter loop", {}, over(loop.filtered));
    add_ours(loop.predicate, loop.instruction_set, taken_for(loop.instruction_set));
  }
  add_single_points();
  add_own_formulas();
  add_million("serial", Execution::serial);
  add_million("parallel", Execution::parallel);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

// How long does a continuous collision query take, and is its answer true?  The queries of ../shared/ccd by scene,
// beside the plain double test; the counters say what is false.  And hard motions, with what they allocate: those of
// tool/trial/moving_cases.hpp, as they are, moved off their lattice, and far from the origin.
#include <benchmark/benchmark.h>
#include <gmp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>

#include "bench/rivals/ccd_rival.hpp"
#include "lab/stability/ccd_queries.hpp"
#include "lab/trial/moving_cases.hpp"

namespace {
double allocations = 0;  // by new, and by GMP
}
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace plumb::bench {
namespace {

using lab::ccd::Query;

bool plain(const Query& q) { return plain_contact(q.vertex_face, q.at_0, q.at_1); }

/// ns of each query in ascending order, each asked many times over.
std::vector<double> times_of(const std::vector<Query>& queries, bool (*answer)(const Query&)) {
  constexpr int times = 32;
  std::vector<double> all;
  for (const Query& q : queries) {
    double least = 1e9;
    for (int repeat = 0; repeat < 3; ++repeat) {
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < times; ++i) benchmark::DoNotOptimize(answer(q));
      const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
      least = std::min(least, took.count() / times);
    }
    all.push_back(least);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void run(benchmark::State& state, const std::vector<Query>& queries, bool (*answer)(const Query&),
         bool asks_for_contact) {
  for (auto _ : state) {
    for (const Query& q : queries) benchmark::DoNotOptimize(answer(q));
  }
  const auto falsely = [&](bool meets) {
    return static_cast<double>(std::count_if(queries.begin(), queries.end(),
                                             [&](const Query& q) { return q.meets == meets && answer(q) != meets; }));
  };
  const auto size = static_cast<double>(queries.size());
  state.counters["queries"] = size;
  state.counters["mean_ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * size * 1e-9,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  const std::vector<double> times = times_of(queries, answer);
  state.counters["median_ns"] = times[times.size() / 2];
  state.counters["p99_ns"] = times[times.size() * 99 / 100];
  state.counters["max_ns"] = times.back();
  if (!asks_for_contact) return;
  state.counters["false_positives"] = falsely(false);
  state.counters["false_negatives"] = falsely(true);
}

/// A hundredth of the motion's size, or so.
ContactOptions separation_of(const Query& q) {
  double size = 0;
  for (const auto* points : {&q.at_0, &q.at_1}) {
    for (const Point3& p : *points) {
      for (const double x : {p.x - q.at_0[0].x, p.y - q.at_0[0].y, p.z - q.at_0[0].z})
        size = std::fmax(size, std::fabs(x));
    }
  }
  return {size / 128};
}
bool comes_near(const Query& q) {
  const ContactOptions options = separation_of(q);
  return q.vertex_face ? intersects(q.vertex(), q.triangle(), options) : intersects(q.edge(0), q.edge(1), options);
}
bool first_comes_near(const Query& q) {
  const ContactOptions options = separation_of(q);
  return q.vertex_face ? first_contact(q.vertex(), q.triangle(), options).has_value()
                       : first_contact(q.edge(0), q.edge(1), options).has_value();
}

void add(const std::string& name, const std::vector<Query>& queries) {
  const auto one = [&](const char* method, bool (*answer)(const Query&), bool asks_for_contact = true) {
    benchmark::RegisterBenchmark((name + "/" + method).c_str(),
                                 [=](benchmark::State& state) { run(state, queries, answer, asks_for_contact); });
  };
  one("plumb", [](const Query& q) { return lab::ccd::intersects(q); });
  one("plumb_first_contact", [](const Query& q) { return lab::ccd::first_contact(q).has_value(); });
  one("plumb_separation", comes_near, false);
  one("plumb_first_contact_separation", first_comes_near, false);
  one("plain", plain);
}

enum class Place { lattice, off_lattice, far };

std::vector<Query> hard_motions(lab::moving_cases::Kind kind, bool vertex_face, Place place) {
  constexpr std::uint64_t count = 300;
  std::vector<Query> all;
  for (std::uint64_t i = 0; i < count; ++i) {
    Entropy entropy(2031, i);
    const lab::moving_cases::Case c = lab::moving_cases::make(kind, vertex_face, entropy);
    Query q{};
    q.vertex_face = vertex_face, q.at_0 = c.at_0, q.at_1 = c.at_1;
    for (auto* points : {&q.at_0, &q.at_1}) {
      for (Point3& p : *points) {
        if (place == Place::off_lattice) p = {p.x / 3, p.y / 5 + 1, p.z * 0x1p-40};
        if (place == Place::far) p = {p.x + 0x1p40, p.y - 0x1p41, p.z + 0x1p42};
      }
    }
    all.push_back(q);
  }
  return all;
}

void run_hard(benchmark::State& state, const std::vector<Query>& queries, bool (*answer)(const Query&)) {
  double most = 0;
  const double before = allocations;
  for (const Query& q : queries) {
    const double start = allocations;
    benchmark::DoNotOptimize(answer(q));
    most = std::max(most, allocations - start);
  }
  const auto size = static_cast<double>(queries.size());
  state.counters["allocations"] = (allocations - before) / size;
  state.counters["most_allocations"] = most;
  for (auto _ : state) {
    for (const Query& q : queries) benchmark::DoNotOptimize(answer(q));
  }
  state.counters["mean_ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * size * 1e-9,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add_hard_motions() {
  mp_set_memory_functions([](std::size_t n) { return ++allocations, std::malloc(n); },
                          [](void* p, std::size_t, std::size_t n) { return ++allocations, std::realloc(p, n); },
                          [](void* p, std::size_t) { std::free(p); });
  constexpr std::array places{Place::lattice, Place::off_lattice, Place::far};
  constexpr std::array place_names{"", "_off_lattice", "_far"};
  for (const lab::moving_cases::Kind kind : lab::moving_cases::kinds) {
    for (std::size_t place = 0; place < places.size(); ++place) {
      if (kind == lab::moving_cases::Kind::family && place != 0) continue;
      for (const bool vertex_face : {true, false}) {
        const std::vector<Query> queries = hard_motions(kind, vertex_face, places[place]);
        const std::string name =
            "hard/" + std::string(name_of(kind)) + place_names[place] + (vertex_face ? "/vertex_face" : "/edge_edge");
        const auto one = [&](const char* method, bool (*answer)(const Query&)) {
          benchmark::RegisterBenchmark((name + "/" + method).c_str(),
                                       [=](benchmark::State& state) { run_hard(state, queries, answer); });
        };
        one("plumb", [](const Query& q) { return lab::ccd::intersects(q); });
        one("plumb_first_contact", [](const Query& q) { return lab::ccd::first_contact(q).has_value(); });
        one("plain", plain);
      }
    }
  }
}

const bool registered = [] {
  add_hard_motions();
  std::map<std::string, std::vector<Query>> scenes;
  for (const Query& q : lab::ccd::all_queries(PLUMB_SOURCE_DIR "/../shared/ccd")) {
    scenes[q.scene + (q.vertex_face ? "/vertex_face" : "/edge_edge")].push_back(q);
    scenes["all"].push_back(q);
  }
  for (const auto& [name, queries] : scenes) add("ccd/" + name, queries);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

// How long does a continuous collision query take, and is its answer true?  The queries of ../shared/ccd by scene,
// beside the plain double test; the counters say what is false.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "bench/rivals/ccd_rival.hpp"
#include "tool/stability/ccd_queries.hpp"

namespace plumb::bench {
namespace {

using tool::ccd::Query;

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
  one("plumb", [](const Query& q) { return tool::ccd::intersects(q); });
  one("plumb_first_contact", [](const Query& q) { return tool::ccd::first_contact(q).has_value(); });
  one("plumb_separation", comes_near, false);
  one("plumb_first_contact_separation", first_comes_near, false);
  one("plain", plain);
}

const bool registered = [] {
  std::map<std::string, std::vector<Query>> scenes;
  for (const Query& q : tool::ccd::all_queries(PLUMB_SOURCE_DIR "/../shared/ccd")) {
    scenes[q.scene + (q.vertex_face ? "/vertex_face" : "/edge_edge")].push_back(q);
    scenes["all"].push_back(q);
  }
  for (const auto& [name, queries] : scenes) add("ccd/" + name, queries);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

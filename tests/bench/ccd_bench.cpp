// How long does a continuous collision query take, and is its answer true?  The queries of ../shared/ccd by scene,
// beside the plain double test; the counters say what is false.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "bench/ccd_rival.hpp"
#include "query/ccd_queries.hpp"

namespace plumb::bench {
namespace {

using ccd::Query;

bool plain(const Query& q) { return plain_contact(q.vertex_face, q.at_0, q.at_1); }

/// ns a query in the middle of the order, each asked many times over.
double median_time(const std::vector<Query>& queries, bool (*answer)(const Query&)) {
  constexpr int times = 64;
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
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

void run(benchmark::State& state, const std::vector<Query>& queries, bool (*answer)(const Query&)) {
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
  state.counters["median_ns"] = median_time(queries, answer);
  state.counters["false_positives"] = falsely(false);
  state.counters["false_negatives"] = falsely(true);
}

void add(const std::string& name, const std::vector<Query>& queries) {
  const auto one = [&](const char* method, bool (*answer)(const Query&)) {
    benchmark::RegisterBenchmark((name + "/" + method).c_str(),
                                 [queries, answer](benchmark::State& state) { run(state, queries, answer); });
  };
  one("plumb", [](const Query& q) { return ccd::intersects(q); });
  one("plumb_first_contact", [](const Query& q) { return ccd::first_contact(q).has_value(); });
  one("plain", plain);
}

const bool registered = [] {
  std::map<std::string, std::vector<Query>> scenes;
  for (const Query& q : ccd::all_queries()) {
    scenes[q.scene + (q.vertex_face ? "/vertex_face" : "/edge_edge")].push_back(q);
    scenes["all"].push_back(q);
  }
  for (const auto& [name, queries] : scenes) add("ccd/" + name, queries);
  return true;
}();

}  // namespace
}  // namespace plumb::bench

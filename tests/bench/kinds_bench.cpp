// How many cases a second does a check take, beside the function that is asked?  Of every kind, all generators in turn:
// making a case, and making and judging it.
#include <benchmark/benchmark.h>

#include <string>

#include "plumb/degenerate/check.hpp"
#include "plumb/query/kinds/kinds.hpp"

namespace plumb::bench {
namespace {

using degenerate::Kind;

void make_or_judge(benchmark::State& state, const Kind& kind, bool judged) {
  std::uint64_t i = 0;
  for (auto _ : state) {
    const auto& generator = kind.generators[i % kind.generators.size()];
    const degenerate::Numbers numbers = degenerate::case_of(kind, generator.name, 2026, i++ % 65536);
    benchmark::DoNotOptimize(numbers.data());
    if (judged) benchmark::DoNotOptimize(degenerate::judge(kind, numbers, kind.exact(numbers), {}).verdict);
  }
  state.SetItemsProcessed(state.iterations());
}

const bool registered = [] {
  for (const Kind& kind : degenerate::kinds()) {
    for (const bool judged : {false, true}) {
      const std::string name = std::string(kind.name).append(judged ? "/made_and_judged" : "/made");
      benchmark::RegisterBenchmark(name.c_str(),
                                   [&kind, judged](benchmark::State& state) { make_or_judge(state, kind, judged); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench

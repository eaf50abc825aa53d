// How long does a sign take?  The bare double formula, the exact predicate and CGAL's Epick on the same inputs, in the
// same run: `bench_predicates --benchmark_format=json | python3 tests/bench/table.py` prints the table of
// docs/measurements.md.
#include <benchmark/benchmark.h>

#include <memory>

#include "bench/cgal_rival.hpp"
#include "bench/inputs.hpp"
#include "plumb/predicates.hpp"

namespace plumb::bench {
namespace {

template <Formula F>
std::vector<Coordinates<F>> sets_of(const std::vector<double>& all) {
  std::vector<Coordinates<F>> sets(cases);
  for (std::size_t i = 0; i < cases; ++i) std::copy_n(&all[i * arity<F>], arity<F>, sets[i].begin());
  return sets;
}

void report(benchmark::State& state) {
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * cases * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class F, class Take>
[[gnu::noinline]] long sum_over(const std::vector<Coordinates<F>>& sets, Take take) {
  long sum = 0;
  for (const Coordinates<F>& p : sets) sum += take(p);
  return sum;
}

template <Formula F>
void register_class(const std::string& name) {
  const auto all = std::make_shared<std::vector<double>>(inputs(F::name, arity<F>, F::dimension, name));
  const auto sets = std::make_shared<std::vector<Coordinates<F>>>(sets_of<F>(*all));
  const std::string prefix = std::string(F::name) + "/" + name;
  const auto add = [&](const char* method, std::function<long()> run) {
    benchmark::RegisterBenchmark((prefix + "/" + method).c_str(), [run](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(run());
      report(state);
    });
  };
  add("bare", [sets] {
    return sum_over<F>(*sets, [](const Coordinates<F>& p) { return static_cast<int>(sign_of_number(F{}(p))); });
  });
  add("plumb",
      [sets] { return sum_over<F>(*sets, [](const Coordinates<F>& p) { return static_cast<int>(decide<F>(p)); }); });
  add("epick", epick(F::name, *all));
}

template <Formula F>
void register_predicate() {
  for (const std::string& name : input_classes()) register_class<F>(name);
}

[[maybe_unused]] const bool registered = [] {
#define PLUMB_REGISTER(formula) register_predicate<predicates::formula>();
  PLUMB_PREDICATES(PLUMB_REGISTER)
#undef PLUMB_REGISTER
  return true;
}();

}  // namespace
}  // namespace plumb::bench

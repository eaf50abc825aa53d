// How long does a sign take?  The bare double formula, the exact predicate and CGAL's Epick on the same inputs, in the
// same run: `bench_predicates --benchmark_format=json | python3 tests/bench/report/table.py` prints the table of
// docs/measurements.md.
#include <benchmark/benchmark.h>

#include <memory>

#include "bench/measure.hpp"
#include "bench/rivals/cgal_rival.hpp"
#include "plumb/predicates.hpp"

namespace plumb::bench {
namespace {

template <class F, class Take>
[[gnu::noinline]] long sum_over(const std::vector<Coordinates<F>>& sets, Take take) {
  long sum = 0;
  for (const Coordinates<F>& p : sets) sum += take(p);
  return sum;
}

template <Formula F>
void register_class(const std::string& name) {
  const auto all = std::make_shared<std::vector<double>>(inputs<F>(name));
  const auto sets = std::make_shared<std::vector<Coordinates<F>>>(sets_of<F>(*all));
  add(F::name, name, "bare", [sets] {
    return sum_over<F>(*sets, [](const Coordinates<F>& p) { return static_cast<int>(sign_of_number(F{}(p))); });
  });
  add(F::name, name, "plumb",
      [sets] { return sum_over<F>(*sets, [](const Coordinates<F>& p) { return static_cast<int>(decide<F>(p)); }); });
  add(F::name, name, "epick", epick(F::name, *all));
}

template <Formula F>
void register_predicate() {
  for (const std::string& name : input_classes()) register_class<F>(name);
}

[[maybe_unused]] const bool registered = register_classics([]<Formula F>(F) { register_predicate<F>(); });

}  // namespace
}  // namespace plumb::bench

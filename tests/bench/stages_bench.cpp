// What does each stage cost by itself?  Both filters on uniform points, the exact stages on exactly degenerate ones.
#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::bench {
namespace {

template <Formula F, class Take>
void add_stage(const char* stage, const std::string& name, Take take) {
  add_each<F>(name, stage, sets_of<F>(inputs<F>(name)), take);
}

template <Formula F>
void register_predicate() {
  using C = Coordinates<F>;
  add_stage<F>("magnitude-filter", "uniform", [](const C& p) { return magnitude_filter<F>(p); });
  add_stage<F>("largest-filter", "uniform", [](const C& p) { return largest_filter<F>(p); });
  for (const char* name : {"lattice20", "degenerate_long"}) {
    const std::string class_name = name;
    add_stage<F>("structural-zero", class_name, [](const C& p) { return answer(structural_zero_sign<F>(p)); });
    add_stage<F>("integer", class_name, [](const C& p) { return answer(integer_sign<F>(p)); });
    add_stage<F>("interval", class_name, [](const C& p) { return answer(interval_sign<F>(p)); });
    add_stage<F>("wide-integer", class_name, [](const C& p) { return answer(wide_integer_sign<F>(p)); });
    add_stage<F>("big-integer", class_name,
                 [](const C& p) { return answer(Unsure{big_integer_sign(certify::tape::program<F>(), p)}); });
  }
}

[[maybe_unused]] const bool registered = register_classics([]<Formula F>(F) { register_predicate<F>(); });

}  // namespace
}  // namespace plumb::bench

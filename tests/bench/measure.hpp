// On which inputs is speed measured, and how?  The same classes everywhere: every family of degenerate/, aimed at the
// question of the predicate, and the exactly degenerate lattice of 20-bit coordinates.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/sign.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb::bench {

constexpr std::size_t cases = 8192;  // fits the second-level cache, and is too long for branch predictors to learn

constexpr Degeneracy question_of(std::string_view predicate) {
  if (predicate == "orient2d") return Degeneracy::collinear;
  if (predicate == "orient3d") return Degeneracy::coplanar;
  return predicate == "incircle" ? Degeneracy::cocircular : Degeneracy::cospherical;
}

inline std::vector<std::string> input_classes() {
  std::vector<std::string> names{"lattice20"};
  for (const FamilyInfo& f : families) names.emplace_back(f.name);
  return names;
}

/// `cases` sets of arity coordinates each, one after the other.
inline std::vector<double> inputs(std::string_view predicate, std::size_t arity, int dimension,
                                  const std::string& name) {
  std::vector<double> all(cases * arity);
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(2026, i);
    const std::span<double> one(&all[i * arity], arity);
    if (name == "lattice20") {
      fill_exact(question_of(predicate), dimension, 20, one, entropy);
    } else {
      fill_points(*family_named(name), question_of(predicate), dimension, one, entropy);
    }
  }
  return all;
}

/// The same, as many coordinates as F takes.
template <Formula F>
std::vector<double> inputs(const std::string& name) {
  return inputs(F::name, arity<F>, F::dimension, name);
}

template <Formula F>
std::vector<Coordinates<F>> sets_of(const std::vector<double>& all) {
  std::vector<Coordinates<F>> sets(cases);
  for (std::size_t i = 0; i < cases; ++i) std::copy_n(&all[i * arity<F>], arity<F>, sets[i].begin());
  return sets;
}

/// Registers "predicate/class/method": `run` goes through all cases once.  Reports ns for a case.
inline void add(std::string_view predicate, const std::string& inputs_name, const std::string& method,
                std::function<long()> run) {
  const std::string name = std::string(predicate) + "/" + inputs_name + "/" + method;
  benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run)](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run());
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * cases * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

/// Registers a method that is asked of each set of coordinates by itself.
template <Formula F, class Take>
void add_each(const std::string& inputs_name, const std::string& method, std::vector<Coordinates<F>> sets, Take take) {
  add(F::name, inputs_name, method, [sets = std::make_shared<std::vector<Coordinates<F>>>(std::move(sets)), take] {
    long sum = 0;
    for (const Coordinates<F>& p : *sets) sum += static_cast<long>(take(p));
    return sum;
  });
}

/// Calls register_one with each of the four.
template <class Register>
bool register_classics(Register register_one) {
#define PLUMB_REGISTER(formula) register_one(predicates::formula{});
  PLUMB_CLASSICS(PLUMB_REGISTER)
#undef PLUMB_REGISTER
  return true;
}

/// The sign itself, so that no stage's last operations are left out as unused.
inline int answer(Unsure<Sign> s) { return s.certain() ? static_cast<int>(s.value()) : 2; }

}  // namespace plumb::bench

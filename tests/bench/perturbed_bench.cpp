// How long does a perturbed sign take where the exact one is zero?  The exact sign alone, the perturbed one, and the
// same by nothing but the expansion, on the same inputs, in the same run.
//
// The inputs are exactly degenerate: the classes of the other benchmarks without the cases that are not zero, a small
// grid as a mesher meets it, and all points in one place.
#include <benchmark/benchmark.h>

#include <memory>

#include "bench/measure.hpp"
#include "plumb/certify/perturbed.hpp"

namespace plumb::bench {
namespace {

template <Formula F>
struct Question {
  Coordinates<F> p;
  Indices<F> indices;
};

template <Formula F>
Coordinates<F> any_coordinates(const std::string& name, Entropy& e) {
  Coordinates<F> p{};
  if (name == "lattice20") {
    fill_exact(question_of(F::name), F::dimension, 20, p, e);
  } else if (name == "grid10") {
    for (double& x : p) x = static_cast<double>(e.below(10));
  } else if (name == "level") {  // the last axis plays no part
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = (i + 1) % static_cast<std::size_t>(F::dimension) == 0 ? 7 : static_cast<double>(e.below(1000));
    }
  } else if (name == "one_place") {
    p.fill(static_cast<double>(e.below(1000)));
  } else {
    fill_points(*family_named(name), question_of(F::name), F::dimension, p, e);
  }
  return p;
}

template <Formula F>
std::vector<Question<F>> zeros(const std::string& name) {
  std::vector<Question<F>> all;
  for (std::uint64_t number = 0; all.size() < cases; ++number) {
    Entropy e(2026, number);
    Question<F> q{any_coordinates<F>(name, e), {}};
    for (std::size_t i = 0; i < q.indices.size(); ++i) q.indices[i] = e.below(1'000'000) * 8 + i;
    if (decide<F>(q.p) == Sign::zero) all.push_back(q);
  }
  return all;
}

template <Formula F>
void register_class(const std::string& name) {
  const auto all = std::make_shared<std::vector<Question<F>>>(zeros<F>(name));
  const auto sum_over = [all](auto take) {
    return [all, take] {
      long sum = 0;
      for (const Question<F>& q : *all) sum += static_cast<int>(take(q));
      return sum;
    };
  };
  add(F::name, name, "exact", sum_over([](const Question<F>& q) { return decide<F>(q.p); }));
  add(F::name, name, "perturbed", sum_over([](const Question<F>& q) { return decide<F>(perturbed, q.p, q.indices); }));
  add(F::name, name, "expansion", sum_over([](const Question<F>& q) {
        std::array<std::uint16_t, arity<F>> order{};
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint16_t>(i);
        return certify::perturbation::expanded_sign(certify::tape::program<F>(), true, q.p, order);
      }));
}

template <Formula F>
void register_predicate() {
  for (const char* name : {"lattice20", "grid10", "level", "degenerate_long", "repeated", "wide", "one_place"}) {
    register_class<F>(name);
  }
}

[[maybe_unused]] const bool registered = [] {
  register_predicate<predicates::Orient2d>();
  register_predicate<predicates::Orient3d>();
  register_predicate<predicates::InCircle>();
  register_predicate<predicates::InSphere>();
  return true;
}();

}  // namespace
}  // namespace plumb::bench

// What does a plan save?  The bare formula, the default chain, the kernel of the scene's lattice and the filter of its
// box, on lattices of 8 to 53 bits, random and exactly degenerate: `bench_plan --benchmark_format=json | python3
// tests/bench/report/table.py` prints the table of docs/plans.md.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "bench/measure.hpp"
#include "plumb/certify/bounded_points.hpp"
#include "plumb/certify/kernel.hpp"

namespace plumb::bench {
namespace {

constexpr std::array lattice_bits{8, 12, 16, 20, 26, 31, 40, 53};

// Integers below 2^bits in magnitude.
template <Formula F>
std::vector<Coordinates<F>> lattice_sets(int bits, bool degenerate) {
  std::vector<Coordinates<F>> sets(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(2026, i);
    if (degenerate) {
      fill_exact(question_of(F::name), F::dimension, bits, sets[i], entropy);
    } else {
      for (double& x : sets[i]) {
        const auto m = static_cast<double>(entropy.bits(bits));
        x = entropy.coin() ? m : -m;
      }
    }
  }
  return sets;
}

template <Formula F, class Set, class Take>
void add_method(const std::string& inputs_name, const char* method, const std::vector<Set>& sets, Take take) {
  add(F::name, inputs_name, method, [all = std::make_shared<std::vector<Set>>(sets), take] {
    benchmark::ClobberMemory();  // or all is computed once, before the loop over repetitions
    long sum = 0;
    for (const Set& p : *all) sum += static_cast<long>(take(p));
    return sum;
  });
}

template <Formula F>
void register_lattice(int bits, bool degenerate) {
  using C = Coordinates<F>;
  constexpr auto dimension = static_cast<std::size_t>(F::dimension), count = static_cast<std::size_t>(F::points);
  const std::string name = (degenerate ? "degenerate-" : "random-") + std::to_string(bits);
  const std::vector<C> sets = lattice_sets<F>(bits, degenerate);
  add_method<F>(name, "bare", sets, [](const C& p) { return sign_of_number(F{}(p)); });
  add_method<F>(name, "decide", sets, [](const C& p) { return decide<F>(p); });

  const Kernel kernel(plan(Lattice{0, bits}));
  std::vector<std::array<LatticePoint<dimension>, count>> taken(cases);
  using Point = std::conditional_t<dimension == 2, Point2, Point3>;
  std::vector<Point> points;
  for (std::size_t i = 0; i < cases; ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      std::array<double, dimension> x{};
      std::copy_n(sets[i].begin() + static_cast<std::ptrdiff_t>(k * dimension), dimension, x.begin());
      taken[i][k] = kernel.point(x);
      points.push_back(std::apply([](auto... c) { return Point{c...}; }, x));
    }
  }
  add(F::name, name, "plan", [all = std::make_shared<decltype(taken)>(taken), kernel] {
    benchmark::ClobberMemory();
    return kernel.with<F>([&](const auto& sign) {
      long sum = 0;
      for (const auto& p : *all) sum += static_cast<long>(std::apply(sign, p));
      return sum;
    });
  });
  add_method<F>(name, "plan-chosen-each-time", taken, [kernel](const auto& p) {
    return std::apply([&](const auto&... point) { return kernel.sign<F>(point...); }, p);
  });
  add_method<F>(name, "per-call", sets, [kernel](const C& p) { return kernel.sign<F>(p); });

  const auto scene = std::make_shared<BoundedPoints<Point>>(points);
  std::vector<std::array<std::size_t, count>> numbers(cases);
  for (std::size_t i = 0; i < cases * count; ++i) numbers[i / count][i % count] = i;
  add_method<F>(name, "bounded", numbers, [scene, predicate = scene->template predicate<F>()](const auto& n) {
    return std::apply(predicate, n);
  });
}

[[maybe_unused]] const bool registered = [] {
  const auto register_predicate = []<Formula F>(F) {
    for (const bool degenerate : {false, true}) {
      for (const int bits : lattice_bits) register_lattice<F>(bits, degenerate);
    }
  };
  register_predicate(predicates::Orient2d{});
  register_predicate(predicates::Orient3d{});
  register_predicate(predicates::InCircle{});
  register_predicate(predicates::InSphere{});
  return true;
}();

}  // namespace
}  // namespace plumb::bench

// How long does a linear program in space take?  Seidel's algorithm over exact signs, the simplex method in rationals,
// and CGAL's exact solver.
//
// Classes: planes tangent to a sphere; the same with redundant ones behind them; infeasible by opposite ones; planes of
// whole numbers through one point, all of which an optimum there meets with equality; unbounded.
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "plumb/query/lp/linear_program.hpp"
#include "plumb/query/lp/nearest_feasible.hpp"
#include "plumb/query/lp/simplex.hpp"

namespace plumb {
namespace {

enum class Class { tangent, redundant, infeasible, one_point, unbounded };
constexpr std::array<const char*, 5> class_names{"tangent", "redundant", "infeasible", "one_point", "unbounded"};

struct Program {
  Vector3 direction;
  std::vector<Halfspace3> halfspaces;
};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  Vector3 unit() {
    for (;;) {
      const Vector3 v{(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)};
      const double r = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      if (r > 0.1 && r < 1) return {v.x / r, v.y / r, v.z / r};
    }
  }
  double whole(double most) { return std::floor((*this)(-most, most + 1)); }

 private:
  std::mt19937_64 random_;
};

Program make(Class c, std::size_t size, Numbers& n) {
  Program p{n.unit(), {}};
  for (std::size_t i = 0; i < size; ++i) {
    Halfspace3 h{n.unit(), 1};
    if (c == Class::redundant && i % 2 == 0) h.offset = n(1, 3);
    if (c == Class::infeasible) h.offset = n(-0.5, 1);
    if (c == Class::unbounded &&
        h.normal.x * p.direction.x + h.normal.y * p.direction.y + h.normal.z * p.direction.z > 0)
      h.normal = {-h.normal.x, -h.normal.y, -h.normal.z};
    if (c == Class::one_point) {
      h.normal = {n.whole(1000), n.whole(1000), n.whole(1000)};
      h.offset = 5 * h.normal.x + 7 * h.normal.y - 11 * h.normal.z;
    }
    p.halfspaces.push_back(h);
  }
  if (c == Class::one_point) p.direction = {1, 2, 3};
  if (c == Class::one_point) {  // of which the direction is a sum, so that the point is an optimum
    for (Halfspace3& h : p.halfspaces) {
      if (h.normal.x + 2 * h.normal.y + 3 * h.normal.z < 0) h = {{-h.normal.x, -h.normal.y, -h.normal.z}, -h.offset};
    }
  }
  return p;
}

std::vector<Program> programs(const benchmark::State& state) {
  Numbers n(9);
  std::vector<Program> all;
  for (int i = 0; i < 64; ++i)
    all.push_back(make(static_cast<Class>(state.range(0)), static_cast<std::size_t>(state.range(1)), n));
  return all;
}
void name(benchmark::State& state) { state.SetLabel(class_names[static_cast<std::size_t>(state.range(0))]); }

void of_all(benchmark::internal::Benchmark* b) {
  for (int c = 0; c < static_cast<int>(class_names.size()); ++c) {
    for (const int size : {10, 100, 1000}) b->Args({c, size});
  }
}

void BM_Seidel(benchmark::State& state) {
  name(state);
  const std::vector<Program> all = programs(state);
  std::vector<NamedHalfspace3> scratch;
  std::size_t i = 0;
  std::array<double, 3> kinds{};
  for (auto _ : state) {
    const Program& p = all[i++ % all.size()];
    const LinearAnswer3 answer = maximize(p.direction, p.halfspaces, scratch);
    kinds[static_cast<std::size_t>(answer.kind)] += 1;
    benchmark::DoNotOptimize(answer);
  }
  state.counters["optimal"] = kinds[0] / static_cast<double>(i);
  state.counters["infeasible"] = kinds[1] / static_cast<double>(i);
}
BENCHMARK(BM_Seidel)->Apply(of_all);

void BM_Nearest(benchmark::State& state) {
  name(state);
  const std::vector<Program> all = programs(state);
  std::size_t i = 0;
  for (auto _ : state) {
    const Program& p = all[i++ % all.size()];
    benchmark::DoNotOptimize(nearest_feasible(Point3{3 * p.direction.x, p.direction.y, p.direction.z}, p.halfspaces));
  }
}
BENCHMARK(BM_Nearest)->Apply(of_all);

void BM_Simplex(benchmark::State& state) {
  name(state);
  const std::vector<Program> all = programs(state);
  std::vector<LinearSystem> systems;
  for (const Program& p : all) systems.push_back(linear_system(p.halfspaces));
  std::size_t i = 0;
  for (auto _ : state) {
    const Vector3& d = all[i % all.size()].direction;
    benchmark::DoNotOptimize(maximize(std::vector<Rational>{d.x, d.y, d.z}, systems[i % all.size()]));
    ++i;
  }
}
BENCHMARK(BM_Simplex)->Apply(of_all);

/// CGAL's exact solver as its users call it.
class CgalLinearProgram {
 public:
  explicit CgalLinearProgram(const Program& p) : program_(CGAL::SMALLER, false, CGAL::Gmpq(0), false, CGAL::Gmpq(0)) {
    const std::array<double, 3> d{p.direction.x, p.direction.y, p.direction.z};
    for (int i = 0; i < 3; ++i) program_.set_c(i, -CGAL::Gmpq(d[static_cast<std::size_t>(i)]));
    int row = 0;
    for (const Halfspace3& h : p.halfspaces) {
      const std::array<double, 3> n{h.normal.x, h.normal.y, h.normal.z};
      for (int i = 0; i < 3; ++i) program_.set_a(i, row, CGAL::Gmpq(n[static_cast<std::size_t>(i)]));
      program_.set_b(row++, CGAL::Gmpq(h.offset));
    }
  }
  [[nodiscard]] bool is_infeasible() const {
    return CGAL::solve_linear_program(program_, CGAL::Gmpq()).is_infeasible();
  }

 private:
  CGAL::Quadratic_program<CGAL::Gmpq> program_;
};

void BM_Cgal(benchmark::State& state) {
  name(state);
  std::vector<CgalLinearProgram> all;
  for (const Program& p : programs(state)) all.emplace_back(p);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(all[i++ % all.size()].is_infeasible());
}
BENCHMARK(BM_Cgal)->Apply(of_all);

}  // namespace
}  // namespace plumb

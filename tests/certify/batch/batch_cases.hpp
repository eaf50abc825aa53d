// Which batches must be right?  Cases in both layouts, asked in every way, on every instruction set of this machine.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/case_line.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/side.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates.hpp"

namespace plumb::batches {

/// Runs `test` with the batches limited to each instruction set that this machine has.
inline void on_each_instruction_set(const std::function<void()>& test) {
  for (const std::string_view name : batch_instruction_sets()) {
    SCOPED_TRACE(name);
    certify::batch::take_instruction_set(name);
    test();
  }
  certify::batch::take_instruction_set({});
}

template <class F>
using Point = certify::side::PointOf<F>;
template <class F>
using View = certify::side::PointsViewOf<F>;

/// Cases as arrays: of points, and of coordinates.
template <class F>
class Arrays {
 public:
  static constexpr std::size_t points = certify::side::points<F>, dimension = certify::side::dimension<F>;

  explicit Arrays(const std::vector<Coordinates<F>>& cases) {
    for (const Coordinates<F>& c : cases) {
      for (std::size_t k = 0; k < arity<F>; ++k) coordinate_[k].push_back(c[k]);
      for (std::size_t p = 0; p < points; ++p) point_[p].push_back(point_of(&c[p * dimension]));
    }
  }

  static Point<F> point_of(const double* x) {
    if constexpr (dimension == 2) {
      return {x[0], x[1]};
    } else {
      return {x[0], x[1], x[2]};
    }
  }

  /// Points number p of n cases from the first on.
  [[nodiscard]] std::span<const Point<F>> points_at(std::size_t p, std::size_t first, std::size_t n) const {
    return std::span(point_[p]).subspan(first, n);
  }
  [[nodiscard]] View<F> view_at(std::size_t p, std::size_t first, std::size_t n) const {
    const auto axis = [&](std::size_t a) { return std::span(coordinate_[p * dimension + a]).subspan(first, n); };
    if constexpr (dimension == 2) {
      return {axis(0), axis(1)};
    } else {
      return {axis(0), axis(1), axis(2)};
    }
  }

 private:
  std::array<std::vector<double>, arity<F>> coordinate_;
  std::array<std::vector<Point<F>>, points> point_;
};

/// The batch function of a formula, over points or views.
template <class F, class... Arguments>
void batch_of(Arguments&&... arguments) {
  if constexpr (std::is_same_v<F, predicates::Orient2d>) {
    orient2d(arguments...);
  } else if constexpr (std::is_same_v<F, predicates::Orient3d>) {
    orient3d(arguments...);
  } else if constexpr (std::is_same_v<F, predicates::InCircle>) {
    incircle(arguments...);
  } else {
    insphere(arguments...);
  }
}

template <class F>
void ask_points(const Arrays<F>& all, std::size_t first, std::size_t n, std::span<Sign> out,
                Execution execution = Execution::serial) {
  [&]<std::size_t... P>(std::index_sequence<P...>) { batch_of<F>(all.points_at(P, first, n)..., out, execution); }
  (std::make_index_sequence<certify::side::points<F>>());
}

template <class F>
void ask_views(const Arrays<F>& all, std::size_t first, std::size_t n, std::span<Sign> out,
               Execution execution = Execution::serial) {
  [&]<std::size_t... P>(std::index_sequence<P...>) { batch_of<F>(all.view_at(P, first, n)..., out, execution); }
  (std::make_index_sequence<certify::side::points<F>>());
}

/// What makes the predicate zero.
template <class F>
constexpr Degeneracy zero_set() {
  if constexpr (std::is_same_v<F, predicates::Orient2d>) {
    return Degeneracy::collinear;
  } else if constexpr (std::is_same_v<F, predicates::Orient3d>) {
    return Degeneracy::coplanar;
  } else {
    return certify::side::dimension<F> == 2 ? Degeneracy::cocircular : Degeneracy::cospherical;
  }
}

template <class F>
std::vector<Coordinates<F>> cases_of(Family family, std::size_t count) {
  std::vector<Coordinates<F>> cases(count);
  for (std::size_t i = 0; i < count; ++i) {
    Entropy entropy(static_cast<std::uint64_t>(77 + F::points), i);
    fill_points(family, zero_set<F>(), F::dimension, cases[i], entropy);
  }
  return cases;
}

template <class F>
std::vector<Sign> signs_of(const std::vector<Coordinates<F>>& cases) {
  std::vector<Sign> signs;
  for (const Coordinates<F>& c : cases) signs.push_back(decide<F>(c));
  return signs;
}

/// Empty when out[i] is truth[first + i] for all, else the line that replays the first difference.
template <class F>
std::string difference(const std::vector<Coordinates<F>>& cases, const std::vector<Sign>& truth, std::size_t first,
                       std::span<const Sign> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Sign expected = truth[first + i];
    if (out[i] == expected) continue;
    const Coordinates<F>& c = cases[first + i];
    std::string text = "item " + std::to_string(i) + " says ";
    text.push_back(to_char(out[i]));
    return text + "\n" + to_string(CaseLine{std::string(F::name), {c.begin(), c.end()}, Unsure{expected}});
  }
  return {};
}

template <class F>
class EveryFormula : public testing::Test {};
using Formulas = testing::Types<predicates::Orient2d, predicates::Orient3d, predicates::InCircle, predicates::InSphere>;
struct FormulaNames {
  template <class F>
  static std::string GetName(int) {
    return std::string(F::name);
  }
};
TYPED_TEST_SUITE(EveryFormula, Formulas, FormulaNames);

}  // namespace plumb::batches

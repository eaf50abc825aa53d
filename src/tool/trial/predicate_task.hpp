// A predicate as a task: its formula put to every method, on every family of hard inputs, judged by rationals.
//
// Law: swapping the first two points flips the sign, turning the first three in a circle keeps it, for each of the
// classics; so methods are held against themselves.
// Source: RTCD 3.1.6.
// Cost: compile time for each formula.
#pragma once

#include <numeric>

#include "plumb/certify/batch.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/points.hpp"
#include "tool/trial/formula_methods.hpp"
#include "tool/trial/task.hpp"

namespace plumb::tool::trial {

/// Every family, aimed at the degeneracy, and a lattice of 20 bits, whose inputs are exactly degenerate.
std::vector<InputClass> point_classes(Degeneracy degeneracy, int dimension);

/// The batch over spans: one span an argument.
template <Formula F, class Point, class Batch>
class BatchRound final : public Round {
 public:
  BatchRound(std::span<const double> questions, Batch batch) : batch_(batch), signs_(questions.size() / arity<F>) {
    for (std::size_t i = 0; i < questions.size(); i += arity<F>) {
      for (std::size_t k = 0; k < points_.size(); ++k) {
        const double* const x = &questions[i + k * static_cast<std::size_t>(F::dimension)];
        if constexpr (F::dimension == 2)
          points_[k].push_back(Point{x[0], x[1]});
        else
          points_[k].push_back(Point{x[0], x[1], x[2]});
      }
    }
  }
  void answer() override {
    std::apply([&](const auto&... p) { batch_(std::span<const Point>(p)..., std::span<Sign>(signs_)); }, points_);
  }
  [[nodiscard]] double given(std::size_t i) const override { return as_answer(signs_[i]); }

 private:
  const Batch batch_;
  std::array<std::vector<Point>, static_cast<std::size_t>(F::points)> points_;
  std::vector<Sign> signs_;
};

/// Points k of the changed question are points `order[k]` of the question.
template <Formula F>
Symmetry points_in_order(std::array<std::size_t, 3> order, double factor) {
  Symmetry s{std::vector<std::uint8_t>(arity<F>), factor};
  std::iota(s.from.begin(), s.from.end(), std::uint8_t{0});
  constexpr auto dimension = static_cast<std::size_t>(F::dimension);
  for (std::size_t i = 0; i < 3 * dimension; ++i) {
    s.from[i] = static_cast<std::uint8_t>(order[i / dimension] * dimension + i % dimension);
  }
  return s;
}

template <Formula F, class Batch>
Task predicate_task(std::string asked, Degeneracy degeneracy, Batch batch) {
  using Point = std::conditional_t<F::dimension == 2, Point2, Point3>;
  Task task{std::string(F::name), std::move(asked), arity<F>, AnswerKind::decision, {}, {}, {}, {}};
  task.classes = point_classes(degeneracy, F::dimension);
  task.symmetries = {points_in_order<F>({1, 0, 2}, -1), points_in_order<F>({1, 2, 0}, 1)};
  task.methods = formula_methods<F>();
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [batch](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            return std::make_unique<BatchRound<F, Point, Batch>>(questions, batch);
                          }});
  task.judge = [](std::span<const double> question) {
    return as_answer(evaluate<F>([&](std::size_t i) { return big_rational(question[i]); }).sign());
  };
  return task;
}

}  // namespace plumb::tool::trial

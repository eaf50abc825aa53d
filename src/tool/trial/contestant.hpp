// Who answers, and how is an answer written?  A method made ready for many questions.
//
// A question is an array of doubles, an answer one double: a sign, 1 or 0 for yes or no, a number; NaN where the
// method knows that it does not know.
// Laws: (1) preparing turns the questions into the method's own numbers, and is not measured, as software keeps its
// points in the numbers it computes with; answering is. (2) Answering twice gives the same answers.
// Cost: one virtual call for all questions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/arith/lattice.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::tool::trial {

/// The epsilon that is on trial.
inline constexpr double customary_epsilon = 1e-9;

inline constexpr double unsure = std::numeric_limits<double>::quiet_NaN();

inline double as_answer(Sign s) { return static_cast<int>(s); }
inline double as_answer(const Unsure<Sign>& s) { return s.certain() ? as_answer(s.value()) : unsure; }
inline double as_answer(bool yes) { return yes ? 1 : 0; }
inline double as_answer(double x) { return x; }

/// Pairs of numbers, as an answer that is too long for a double.
using Pairs = std::vector<std::array<std::uint32_t, 2>>;
/// A number that tells sets of pairs apart, but for one chance in 2^53; their order does not count.
double as_answer(const Pairs& pairs);

/// What a method may know of all questions before the first is asked: the lattice of their coordinates, and a bound of
/// their magnitudes.
struct Scene {
  Lattice lattice;
  double largest;
};
Scene scene_of(std::span<const double> coordinates);

class Round {
 public:
  Round() = default;
  Round(const Round&) = delete;
  Round& operator=(const Round&) = delete;
  virtual ~Round() = default;
  virtual void answer() = 0;  // all questions; this is what is measured
  [[nodiscard]] virtual double given(std::size_t question) const = 0;
  /// The answer in full, where it is pairs.
  [[nodiscard]] virtual Pairs given_pairs(std::size_t) const { return {}; }
};

/// A question after the other: `ask` answers all.
template <class Question, class Answer, class Ask>
class OneByOne final : public Round {
 public:
  OneByOne(std::vector<Question> questions, Ask ask)
      : questions_(std::move(questions)), ask_(ask), answers_(new Answer[questions_.size()]{}) {}

  void answer() override { ask_(questions_.data(), answers_.get(), questions_.size()); }
  [[nodiscard]] double given(std::size_t i) const override { return as_answer(answers_[i]); }
  [[nodiscard]] Pairs given_pairs(std::size_t i) const override {
    if constexpr (std::is_same_v<Answer, Pairs>) return answers_[i];
    return {};
  }

 private:
  std::vector<Question> questions_;
  const Ask ask_;
  std::unique_ptr<Answer[]> answers_;
};

/// Of a type that alone says all: what is compiled once for each of hundreds of methods is then the loop alone.
template <class Take>
inline constexpr bool stateless = std::is_empty_v<Take>&& std::is_default_constructible_v<Take>;

template <class Question, class Take, class Answer>
[[gnu::noinline]] void answer_all(const Take& take, const Question* questions, Answer* answers, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) answers[i] = take(questions[i]);
}

template <class Question, class Answer, class Ask>
[[gnu::noinline]] std::unique_ptr<Round> asked_by(std::vector<Question> questions, Ask ask) {
  return std::make_unique<OneByOne<Question, Answer, Ask>>(std::move(questions), ask);
}

/// Each answered by `take`.
template <class Question, class Take>
std::unique_ptr<Round> one_by_one(std::vector<Question> questions, Take take) {
  using Answer = std::remove_cvref_t<std::invoke_result_t<const Take&, const Question&>>;
  if constexpr (stateless<Take>) {
    using Ask = void (*)(const Question*, Answer*, std::size_t);
    return asked_by<Question, Answer, Ask>(
        std::move(questions), [](const Question* q, Answer* a, std::size_t n) { answer_all(Take{}, q, a, n); });
  } else {
    return asked_by<Question, Answer>(
        std::move(questions), [take](const Question* q, Answer* a, std::size_t n) { answer_all(take, q, a, n); });
  }
}

/// What prepares nothing is not asked of the class: a batch, where questions have nothing in common.
struct Method {
  std::string name, about;
  std::function<std::unique_ptr<Round>(std::span<const double> questions, const Scene& scene)> prepare;
  /// The number of which it takes the sign, where that is one in floating point; 0 within an epsilon.
  std::function<long double(std::span<const double> question)> value = {};
};

/// Where `prepare` is stateless, by a plain function: no wrapper of its own is compiled.
using Prepare = std::unique_ptr<Round>(std::span<const double> questions, const Scene& scene);
Method prepared_by(std::string_view name, std::string_view about, Prepare* prepare);
template <class Prepared>
Method method(std::string_view name, std::string_view about, Prepared prepare) {
  if constexpr (stateless<Prepared>) {
    return prepared_by(name, about, prepare);
  } else {
    return {std::string(name), std::string(about), std::move(prepare)};
  }
}

}  // namespace plumb::tool::trial

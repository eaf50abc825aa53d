// How does software answer by branching code, in numbers that know more than a double does?  The same algorithms as
// float_methods.hpp, over pairs of doubles, intervals, expansions, integers and rationals.
//
// Laws: those of branching_numbers.hpp; a question in doubt is answered unsure.  What is asked for a number has neither
// intervals, which hold many doubles, nor expansions, whose roots are no sums of doubles.
// Source: RTCD 11.4, 11.5; Shewchuk 1997; cost: what is measured.
#pragma once

#include "tool/trial/branching_numbers.hpp"
#include "tool/trial/compensated.hpp"
#include "tool/trial/expansion.hpp"
#include "tool/trial/float_methods.hpp"

namespace plumb::tool::trial {

/// The algorithm's answer in another number, or unsure.
template <class T, std::size_t N, class Algorithm>
double answer_in(const std::array<double, N>& q, const Algorithm& algorithm) {
  in_doubt = false;
  std::array<T, N> numbers;
  std::ranges::transform(q, numbers.begin(), [](double x) { return T(x); });
  const double answer = as_answer(algorithm(numbers, T(0)));
  return in_doubt ? unsure : answer;
}

template <std::size_t N, class Algorithm>
Method compensated_method(Algorithm algorithm) {
  return each_of<double, N>("compensated", "pairs of doubles that keep each rounding's error",
                            [=](const std::array<double, N>& q) { return answer_in<Compensated>(q, algorithm); });
}

template <std::size_t N, class Algorithm>
double adaptive_answer(const std::array<double, N>& q, const Algorithm& algorithm) {
  const double answer = answer_in<Enclosed>(q, algorithm);
  if (!in_doubt) return answer;
  Expansion::reset();
  try {
    return answer_in<Fraction<Expansion>>(q, algorithm);
  } catch (const std::length_error&) {
    return unsure;
  }
}

template <AnswerKind kind, std::size_t N, class Algorithm>
std::vector<Method> branching_methods(Algorithm algorithm) {
  using Numbers = std::array<double, N>;
  std::vector<Method> all = float_methods<N>(algorithm);
  const auto add = [&](std::string name, std::string about, auto take) {
    all.push_back(each_of<double, N>(std::move(name), std::move(about), take));
  };
  all.push_back(compensated_method<N>(algorithm));
  if constexpr (kind == AnswerKind::decision) {
    add("interval", "interval arithmetic alone; unsure where a branch is not told",
        [=](const Numbers& q) { return answer_in<Enclosed>(q, algorithm); });
    add("adaptive", "intervals, then fractions of expansions of doubles",
        [=](const Numbers& q) { return adaptive_answer(q, algorithm); });
  }
  add("integers", "fractions of integers of any length, always",
      [=](const Numbers& q) { return answer_in<IntegerFraction>(q, algorithm); });
  add("rationals", "GMP's rationals, always", [=](const Numbers& q) { return answer_in<GmpRational>(q, algorithm); });
  return all;
}

}  // namespace plumb::tool::trial

// How does software answer by branching code, in numbers that know more than a double does?  The same algorithms as
// float_methods.hpp, over pairs of doubles, intervals, doubles with static bounds, expansions, integers and rationals.
//
// Laws: those of branching_numbers.hpp; a question in doubt is answered unsure.  What is asked for a number has neither
// intervals and bounds, which hold many doubles, nor expansions, whose roots are no sums of doubles.
// Source: RTCD 11.4, 11.5; Shewchuk 1997.
// Cost: what is measured.
#pragma once

#include <cmath>

#include "lab/trial/bounded_number.hpp"
#include "lab/trial/branching_numbers.hpp"
#include "lab/trial/float_methods.hpp"
#include "tool/trial/compensated.hpp"
#include "tool/trial/expansion.hpp"

namespace plumb::lab::trial {

/// The algorithm's answer to a question of another number, or unsure.
template <class T, std::size_t N, class Algorithm>
double answer_of(const std::array<T, N>& q, const Algorithm& algorithm) {
  in_doubt = false;
  const double answer = as_answer(algorithm(q, T(0)));
  return in_doubt ? unsure : answer;
}

/// The same of doubles, which are turned into that number on the way by make(x).
template <class T, std::size_t N, class Algorithm, class Make>
double answer_in(const std::array<double, N>& q, const Algorithm& algorithm, Make make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return answer_of(std::array<T, N>{make(q[I])...}, algorithm);
  }
  (std::make_index_sequence<N>{});
}
template <class T, std::size_t N, class Algorithm>
double answer_in(const std::array<double, N>& q, const Algorithm& algorithm) {
  return answer_in<T>(q, algorithm, [](double x) { return T(x); });
}

/// Double against errors that one bound of all inputs bounds.
template <std::size_t N, class Algorithm>
Method static_filter(Algorithm) {
  return method("static-filter", "double against bounds for all inputs; unsure within them",
                [](std::span<const double> questions, const Scene& scene) -> std::unique_ptr<Round> {
                  // In units of a power of two, so that the bound is a constant.
                  int shift = scene.largest == 0 ? 0 : BoundedNumber::input_exponent - 1 - std::ilogb(scene.largest);
                  if constexpr (requires { Algorithm::axes_are_no_lengths; }) {  // which would be scaled as well
                    if (shift < 0) return nullptr;
                    shift = 0;
                  }
                  std::vector<double> scaled(questions.begin(), questions.end());
                  for (double& x : scaled) {
                    const double in_units = std::scalbn(x, shift);
                    if (std::scalbn(in_units, -shift) != x) return nullptr;  // it would lose digits
                    x = in_units;
                  }
                  const auto take = [](const std::array<double, N>& q) __attribute__((flatten)) {
                    return answer_in<BoundedNumber>(q, Algorithm{}, BoundedNumber::input);
                  };
                  return one_by_one(questions_in<double, N>(scaled), take);
                });
}

/// A number that memory is taken for is made of the double beforehand.
template <class T, std::size_t N, class Algorithm>
Method kept_in(std::string_view name, std::string_view about, Algorithm) {
  return each_of<T, N>(name, about, [](const std::array<T, N>& q) { return answer_of(q, Algorithm{}); });
}

template <std::size_t N, class Algorithm>
Method compensated_method(Algorithm) {
  return each_of<double, N>("compensated", "pairs of doubles that keep each rounding's error",
                            [](const std::array<double, N>& q) { return answer_in<Compensated>(q, Algorithm{}); });
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
  const auto add = [&](std::string_view name, std::string_view about, auto take) {
    all.push_back(each_of<double, N>(name, about, take));
  };
  all.push_back(compensated_method<N>(algorithm));
  if constexpr (kind != AnswerKind::number) {
    add("interval", "interval arithmetic alone; unsure where a branch is not told",
        [](const Numbers& q) { return answer_in<Enclosed>(q, Algorithm{}); });
    all.push_back(static_filter<N>(algorithm));
    add("adaptive", "intervals, then fractions of expansions of doubles",
        [](const Numbers& q) { return adaptive_answer(q, Algorithm{}); });
  }
  all.push_back(kept_in<IntegerFraction, N>("integers", "fractions of integers of any length, always", algorithm));
  all.push_back(kept_in<GmpRational, N>("rationals", "GMP's rationals, always", algorithm));
  return all;
}

}  // namespace plumb::lab::trial

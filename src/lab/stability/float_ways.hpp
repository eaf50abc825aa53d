// How do the usual numbers answer a question of shapes?  An algorithm of src/lab/trial over each of them, beside ours.
//
//   auto ways = float_ways<15>(trial::RayAgainstTriangle<false>{});
//   ways.push_back(exact_way<15>([](const std::array<double, 15>& q) { return hits(ray_of(q), triangle_of(q)); }));
//
// Laws: (1) every way is handed the same doubles; float32 rounds them to floats first, as software that stores floats
// does.  (2) The epsilon is that of `plumb-lab chart`: as it is, and times the question's largest coordinate.
// Source: RTCD 11.3.1.
// Cost: that of the algorithm, and a call through a function object.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lab/stability/experiment.hpp"
#include "lab/trial/terms.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::stability {

template <std::size_t N, class Answer = bool>
using Ask = std::function<Answer(const std::array<double, N>& question)>;

template <std::size_t N, class Answer = bool>
struct Way {
  std::string name;
  Ask<N, Answer> ask;
  bool exact = false;
};

/// The algorithm over T with an epsilon, which grows with the question's largest coordinate or not.
template <class T, std::size_t N, class Answer = bool, class Algorithm>
Ask<N, Answer> asked_in(Algorithm algorithm, double epsilon = 0, bool relative = false) {
  return [=](const std::array<double, N>& question) -> Answer {
    std::array<T, N> q{};
    double largest = 1;
    for (std::size_t i = 0; i < N; ++i) q[i] = static_cast<T>(question[i]);
    if (relative) {
      largest = 0;
      for (const double x : question) largest = std::max(largest, std::fabs(x));
    }
    return static_cast<Answer>(algorithm(q, static_cast<T>(epsilon * largest)));
  };
}

template <std::size_t N, class Answer = bool, class Algorithm>
std::vector<Way<N, Answer>> float_ways(Algorithm algorithm) {
  constexpr double epsilon = trial::customary_epsilon;
  return {{"float32", asked_in<float, N, Answer>(algorithm)},
          {"double", asked_in<double, N, Answer>(algorithm)},
          {"absolute", asked_in<double, N, Answer>(algorithm, epsilon)},
          {"relative", asked_in<double, N, Answer>(algorithm, epsilon, true)},
          {"long-double", asked_in<long double, N, Answer>(algorithm)}};
}

template <std::size_t N, class Answer = bool, class Algorithm>
Way<N, Answer> exact_way(Algorithm ours, std::string name = "exact") {
  return {std::move(name), std::move(ours), true};
}

/// What every way fails at, as `count` counts it.
template <std::size_t N, class Answer, class CountFailures>
std::vector<MethodOutcome> outcomes_of(const std::vector<Way<N, Answer>>& ways, CountFailures count) {
  std::vector<MethodOutcome> outcomes;
  for (const Way<N, Answer>& way : ways) outcomes.push_back({way.name, count(way), way.exact});
  return outcomes;
}

}  // namespace plumb::lab::stability

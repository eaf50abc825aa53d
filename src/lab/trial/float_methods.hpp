// How does software answer by branching code?  An algorithm as it is commonly written, run over the usual numbers.
//
// An algorithm is a type with a call operator over std::array<T, N> and an epsilon of T, which answers bool or double.
// What an epsilon means is the algorithm's affair; 0 is none.
// Laws: as formula_methods.hpp.
// Source: RTCD 11.3.1.
// Cost: what is measured.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "lab/trial/tasks.hpp"
#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

template <class T, std::size_t N>
std::vector<std::array<T, N>> questions_in(std::span<const double> questions) {
  std::vector<std::array<T, N>> all(questions.size() / N);
  for (std::size_t i = 0; i < questions.size(); ++i) all[i / N][i % N] = static_cast<T>(questions[i]);
  return all;
}

/// A method that asks `take` of each question, an array of T.
template <class T, std::size_t N, class Take>
Method each_of(std::string_view name, std::string_view about, Take take) {
  if constexpr (stateless<Take>) {
    return method(name, about, [](std::span<const double> questions, const Scene&) {
      return one_by_one(questions_in<T, N>(questions), Take{});
    });
  } else {
    return method(name, about, [take](std::span<const double> questions, const Scene&) {
      return one_by_one(questions_in<T, N>(questions), take);
    });
  }
}

/// A method whose questions are shapes of its own, made beforehand from the numbers.
template <std::size_t N, class Make, class Take>
Method each_made(std::string_view name, std::string_view about, Make make, Take take) {
  return method(name, about, [make, take](std::span<const double> questions, const Scene&) {
    std::vector<std::invoke_result_t<Make, const std::array<double, N>&>> made;
    for (const auto& q : questions_in<double, N>(questions)) made.push_back(make(q));
    return one_by_one(std::move(made), take);
  });
}

/// Ours, asked of two shapes, which are the numbers that they consist of.
template <class A, class B, class Ask>
Method exact_method(Ask) {
  struct Question {
    A a;
    B b;
  };
  using Numbers = std::array<double, sizeof(Question) / sizeof(double)>;
  return each_made<std::tuple_size_v<Numbers>>(
      "exact", "ours, one at a time", [](const Numbers& q) { return std::bit_cast<Question>(q); },
      [](const Question& q) { return Ask{}(q.a, q.b); });
}

/// What most pairs of shapes are asked.
inline constexpr auto meet_exactly = [](const auto& a, const auto& b) { return intersects(a, b); };

template <std::size_t N>
double largest_of(const std::array<double, N>& q) {
  double largest = 0;
  for (const double x : q) largest = std::max(largest, magnitude(x));
  return largest;
}

template <std::size_t N, class Algorithm>
std::vector<Method> float_methods(Algorithm) {
  std::vector<Method> all;
  all.push_back(each_of<float, N>("float32", "single precision, of coordinates rounded to it",
                                  [](const std::array<float, N>& q) { return Algorithm{}(q, 0.0F); }));
  all.push_back(each_of<double, N>("double", "as commonly written, no epsilon",
                                   [](const std::array<double, N>& q) { return Algorithm{}(q, 0.0); }));
  all.push_back(each_of<double, N>("absolute", "double, with an epsilon of 1e-9",
                                   [](const std::array<double, N>& q) { return Algorithm{}(q, customary_epsilon); }));
  all.push_back(each_of<double, N>(
      "relative", "double, with an epsilon of 1e-9 of the largest coordinate",
      [](const std::array<double, N>& q) { return Algorithm{}(q, customary_epsilon * largest_of(q)); }));
  all.push_back(each_of<long double, N>("long-double", "the compiler's long double",
                                        [](const std::array<long double, N>& q) { return Algorithm{}(q, 0.0L); }));
#ifdef __SIZEOF_FLOAT128__
  __extension__ using Float128 = __float128;
  all.push_back(each_of<Float128, N>("float128", "quadruple precision in software",
                                     [](const std::array<Float128, N>& q) { return Algorithm{}(q, Float128(0)); }));
#endif
  return all;
}

/// Points of three numbers (or two) each, in another order; of two shapes that change places, or of one.
Symmetry reordered(std::size_t dimension, const std::vector<std::size_t>& order);

/// What is asked of shapes of `points` points: uniform and hard ones, and small integers, which often touch.
std::vector<InputClass> shape_classes(std::size_t dimension);

/// The classes with each question changed after it was filled, into one that the task allows.
std::vector<InputClass> refilled(std::vector<InputClass> classes, void (*change)(std::span<double> question));

}  // namespace plumb::lab::trial

// What is asked, and what is true of it?  Questions of a task of src/lab/trial with their true answers.
//
// Law: the same task, seed and number give the same questions; the judge computes in GMP's rationals.
// Source: none.
// Cost: the judge's, 1 to 100 us a question.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lab/trial/tasks.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb::lab::stability {

template <std::size_t N>
struct Judged {
  std::array<double, N> question;
  double truth;  // as trial::Task has it: 1 or 0 for yes or no, the nearest double
};

/// Question i is filled by fill(question, entropy) from the choices of seed and i.
template <std::size_t N, class Fill>
std::vector<Judged<N>> judged(const trial::Task& task, std::size_t count, std::uint64_t seed, const Fill& fill) {
  std::vector<Judged<N>> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    Entropy entropy(seed, i);
    fill(all[i].question, entropy);
    all[i].truth = task.judge(all[i].question);
  }
  return all;
}

/// How the task fills questions of a class of inputs; throws Error where there is no such class.
inline auto filled(const trial::Task& task, std::string_view input) {
  const auto found = std::ranges::find(task.classes, input, &trial::InputClass::name);
  if (found == task.classes.end()) throw Error(task.name + " has no class " + std::string(input));
  return found->fill;
}

}  // namespace plumb::lab::stability

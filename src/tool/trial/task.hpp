// What is put to the methods?  A question, the kinds of inputs that it is asked of, its true answer, and who answers.
//
// Laws: (1) `judge` computes in GMP's numbers, or compares doubles as given, and shares no stage with the methods of ours; (2) each symmetry says
// how the true answer changes when the arguments change places, so that a method can be held against itself; (3)
// classes are named as the families of plumb/degenerate are, where they are those.
// Source: RTCD 11.2 (what rounding does to decisions).
// Cost: none, a description.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::tool::trial {

struct InputClass {
  std::string name, about;
  std::function<void(std::span<double> question, Entropy& entropy)> fill;
};

/// Number i of the changed question is number from[i] of the question; its answer is `factor` times the answer.
struct Symmetry {
  std::vector<std::uint8_t> from;
  double factor;
};

/// A sign, or yes or no; which ones of several, as bits or as pairs; a number, which may be more or less far off; which
/// one of many, by its number, of which several may be right.
enum class AnswerKind : std::uint8_t { decision, set, number, item };

/// What is counted beside the wrong answers: how bad they are.  Answers that are unsure do not count.
struct Tally {
  std::string name, about;
  std::function<std::uint64_t(std::span<const double> question, double truth, const Round& round, std::size_t number)>
      count;
};

struct Task {
  std::string name, question;
  std::size_t numbers;  // of a question
  AnswerKind kind;
  std::vector<InputClass> classes;
  std::vector<Symmetry> symmetries;
  std::vector<Method> methods;
  std::function<double(std::span<const double> question)> judge;
  std::uint64_t fewer = 1;  // divides the cases that are asked, where the judge takes its time
  /// Is what was said right, too, though it is not what the judge said?  Where there is none, it is not.
  std::function<bool(std::span<const double> question, double truth, double said)> accepts = {};
  std::vector<Tally> tallies = {};

  [[nodiscard]] bool is_right(std::span<const double> asked, double truth, double said) const {
    return said == truth || (accepts && accepts(asked, truth, said));
  }
};

Task orient2d_task();
Task orient3d_task();
Task incircle_task();
Task insphere_task();

}  // namespace plumb::tool::trial

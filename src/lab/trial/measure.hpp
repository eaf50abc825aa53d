// How did each method do on one class of inputs?  Wrong, unsure and inconsistent answers, time and memory.
//
// Laws: (1) all counts depend on the seed and the number of cases alone, not on the machine's speed; (2) an answer
// that the method knows it does not have, or that is not a number, is unsure, never wrong; (3) inconsistent are those
// of two sure answers to one question, asked with its arguments in another order, that contradict each other, be they
// right or wrong; that two answers are right does not contradict.
// Source: RTCD 11.2.
// Cost: as the methods take, every case asked once for each order and a few times for the clock.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "lab/trial/tasks.hpp"

namespace plumb::lab::trial {

struct Settings {
  std::uint64_t seed = 2026;
  std::uint64_t cases = 8192;   // of a class; fewer where the task says so; too many for branch predictors to learn
  double long_ns = 50'000'000;  // what takes longer is timed once: a disturbance is a small part of it
};

struct Score {
  std::string method;
  std::uint64_t asked = 0, wrong = 0, unsure = 0, inconsistent = 0;
  double ns = 0;           // a question; the least of some repetitions
  double allocations = 0;  // a question
  // Of numbers: how many doubles lie between the answer and the nearest one.
  double largest_ulps = 0, mean_ulps = 0;
  std::vector<std::uint64_t> tallied = {};  // what each of the task's tallies counts

  [[nodiscard]] double share(std::uint64_t count) const {
    return asked == 0 ? 0 : static_cast<double>(count) / static_cast<double>(asked);
  }
};

/// One task on one class.
struct Trial {
  std::string task, question, input, about;
  AnswerKind kind{};
  std::array<std::uint64_t, 3> truths{};  // of decisions: negative, zero (no), positive (yes)
  std::vector<Score> scores;
  struct Counted {
    std::string name, about;
  };
  std::vector<Counted> tallies = {};  // the task's
};

/// The number of doubles between two finite ones; from zero to zero none, whatever the signs.
double doubles_apart(double a, double b);

/// `tried` is called after each method, and so as often as the task has methods.
Trial measure(const Task& task, const InputClass& input, const Settings& settings, const std::function<void()>& tried);

}  // namespace plumb::lab::trial

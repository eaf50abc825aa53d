// Does each world tell of a statement what is so?  Doubles where they are certain, rational numbers, and the question
// itself, which asks one world after another.
//
// Law: a failure names the statement's input by what the caller says about it.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "plumb/certify/certainly.hpp"

namespace plumb::query {

/// Whether doubles are certain: 0 or 1, for counting.
template <class Statement, class Answer>
int told(const Statement& statement, const Answer& truth, const std::string& about, const auto&... input) {
  using namespace certify::one_lane;
  const auto floats = told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, statement, input...);
  const auto rationals = told_by_worlds<RationalWorld>(NoWorldRecorder{}, statement, input...);
  EXPECT_EQ(rationals, std::optional(truth)) << about;
  EXPECT_TRUE(!floats || *floats == truth) << about;
  EXPECT_EQ(certainly(statement, input...), truth) << about;
  return floats ? 1 : 0;
}

}  // namespace plumb::query

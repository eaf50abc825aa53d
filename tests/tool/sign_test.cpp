// `plumb sign` as a user meets it: by arguments and by lines, negative and hexadecimal numbers, bad cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "certify/sanitized.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
}

TEST(Sign, TakesNegativeNumbersAsNumbers) {
  EXPECT_EQ(run("$PLUMB sign orient2d -1 0 1 0 0 -1").out, "- filter\n");
  EXPECT_EQ(run("$PLUMB sign orient2d -1 -0 1 -.5 0 -5e-1").out, "- filter\n");
  EXPECT_EQ(run("$PLUMB sign orient2d -0x1p0 0 0x1p0 0 0 0x1.8p-3").out, "+ filter\n");
  EXPECT_EQ(run("$PLUMB sign orient3d -1 -1 -1 1 -1 -1 -1 1 -1 -1 -1 -2").out, "+ filter\n");
  EXPECT_EQ(run("$PLUMB sign -- orient2d -1 0 1 0 0 -1").out, "- filter\n");
}

TEST(Sign, ReadsDecimalsToTheNearestDouble) {
  // The double nearest to 0.1 lies above it, that nearest to 0.3 below: (0.1, 0.3) is off the line through (1, 3).
  EXPECT_THAT(run("$PLUMB sign orient2d 0 0 0.1 0.1 0.3 0.3").out, StartsWith("0 "));
  EXPECT_THAT(run("$PLUMB sign orient2d 0 0 1 3 0.1 0.3").out, StartsWith("- "));
  EXPECT_THAT(run("$PLUMB sign orient2d 0 0 1 3 0x1.999999999999ap-4 0x1.3333333333333p-2").out, StartsWith("- "));
}

TEST(Sign, IsExactWhereDoublesAreNot) {
  EXPECT_EQ(run("$PLUMB sign incircle 0 0 1 0 1 1 0 1").out.substr(0, 2), "0 ");
  const std::string far = "0x1p52 0x1p52 0x1.0000000000001p52 0x1.0000000000001p52 ";
  EXPECT_EQ(run("$PLUMB sign orient2d " + far + "1 1").out.substr(0, 2), "0 ");
  EXPECT_EQ(run("$PLUMB sign orient2d " + far + "1 0x1.0000000000001p0").out.substr(0, 2), "+ ");
  EXPECT_EQ(run("$PLUMB sign orient2d 1e300 1e300 -1e300 -1e300 1e-300 1e-300").out.substr(0, 2), "0 ");
  EXPECT_EQ(run("$PLUMB sign orient2d 1e300 1e300 -1e300 -1e300 1e-300 2e-300").out.substr(0, 2), "- ");
}

TEST(Sign, NamesTheStageThatTheLibraryNames) {
  std::string lines, expected;
  int alone = 0;  // some also as arguments, each a run of the program
  for (const CatalogEntry& e : catalog()) {
    for (const double step : {1.0, 0.1, 0x1p-40}) {
      CaseLine c{std::string(e.name), {}, {}};
      for (std::size_t i = 0; i < e.arity(); ++i) c.coordinates.push_back(static_cast<double>(i * i % 7) * step);
      const Decision d = e.decide(c.coordinates);
      const std::string answer = std::string(1, to_char(d.sign)) + " " + std::string(to_string(d.stage)) + "\n";
      if (alone++ % (battery::sanitized ? 24 : 3) == 0) {
        EXPECT_EQ(run("$PLUMB sign " + to_string(c)).out, answer);
      }
      lines += to_string(c) + "\n";
      expected += answer;
    }
  }
  const Outcome o = run("$PLUMB sign", lines);
  EXPECT_EQ(o.out, expected);
  EXPECT_EQ(o.code, 0);
}

TEST(Sign, PassesOverBlankLinesAndRemarks) {
  const Outcome o = run("$PLUMB sign", "\n# remark\n  \t\norient2d 0 0 1 0 0 1 # turn\r\norient2d 0 0 1 0 0 -1 = -");
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.out, "+ filter\n- filter\n");
  EXPECT_EQ(run("$PLUMB sign").out, "");
  EXPECT_EQ(run("$PLUMB sign").code, 0);
}

TEST(Sign, ReportsAnExpectedSignThatIsNotTheTrueOne) {
  const Outcome o = run("$PLUMB sign", "orient2d 0 0 1 0 0 1 = -\norient2d 0 0 1 0 0 1 = +\n");
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(o.out, "+ filter  expected -\n+ filter\n");
  EXPECT_EQ(run("$PLUMB sign orient2d 0 0 1 0 0 1 = 0").code, 1);
  EXPECT_EQ(run("$PLUMB sign orient2d 0 0 1 0 0 1 = +").code, 0);
}

TEST(Sign, RefusesEachBadCaseInItsOwnWords) {
  expect_refusal(run("$PLUMB sign orient2d 0 0 1 0 0"), "6 numbers in all, not 5");
  expect_refusal(run("$PLUMB sign orient2d 0 0 1 0 0 1 2"), "6 numbers in all, not 7");
  expect_refusal(run("$PLUMB sign orient2d"), "6 numbers in all, not 0");
  expect_refusal(run("$PLUMB sign orient9 0 0"), "no predicate 'orient9'; there are orient2d");
  expect_refusal(run("$PLUMB sign orient2d nan 0 1 0 0 1"), "'nan' is not a real number");
  expect_refusal(run("$PLUMB sign orient2d -inf 0 1 0 0 1"), "'-inf' is not a real number");
  expect_refusal(run("$PLUMB sign orient2d 1e999 0 1 0 0 1"), "'1e999' is beyond");
  expect_refusal(run("$PLUMB sign orient2d 1,5 0 1 0 0 1"), "'1,5' is not a number");
  expect_refusal(run("$PLUMB sign orient2d '' '' '' ''"), "not 0");
  expect_refusal(run("$PLUMB sign ''"), "a predicate and its coordinates");
  expect_refusal(run("$PLUMB sign orient2d 0 0 1 0 0 1 = up"), "'up'");
}

TEST(Sign, NamesTheBadLineAndKeepsTheAnswersBeforeIt) {
  const Outcome o = run("$PLUMB sign", "orient2d 0 0 1 0 0 1\n\norient2d 0 0 1 0 0\norient2d 0 0 1 0 0 1\n");
  EXPECT_EQ(o.code, 2);
  EXPECT_EQ(o.out, "+ filter\n");
  EXPECT_THAT(o.err, StartsWith("plumb: standard input, line 3: "));
}

TEST(Sign, RefusesInputThatCannotBeRead) {
  expect_refusal(run("$PLUMB sign <&-"), "cannot read standard input: Bad file descriptor");
  expect_refusal(run("$PLUMB sign </"), "cannot read standard input: Is a directory");
}

}  // namespace
}  // namespace plumb::tool

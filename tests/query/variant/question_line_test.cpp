// Are questions written, read and asked again as they were asked, of every kind and every form; and does what cannot be
// read say why?
#include "plumb/query/variant/question_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "plumb/query.hpp"
#include "query/variant/all_kinds.hpp"
#include "query/variant/question_lines.hpp"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string answered(std::string_view line) { return answer_of(*parse_question_line(line)); }

TEST(QuestionLine, AnswersAsSchoolbooksDo) {
  EXPECT_EQ(answered("distance | point3 0 0 0 | point3 0 3 4"), "0x1.4p+2");
  EXPECT_EQ(answered("exact_distance | ball3 0 0 0 1 | point3 0 3 4"), "25 1");
  EXPECT_EQ(answered("squared_distance_exact | point2 0 0 | segment2 1 0 0 1"), "1/2 0");
  EXPECT_EQ(answered("relate | ball3 0 0 0 1 | ball3 2 0 0 1"), "touching");
  EXPECT_EQ(answered("relate|ball3 0 0 0 1|ball3 2 0 0 1 rigid 1 0 0 0 0x1p-1074 0 0  # twice a ball"), "disjoint");
  EXPECT_EQ(answered("intersects | ball3 0 0 0 1 | ball3 5 0 0 1 | 2 0 0 -1 0 0"), "yes");
  EXPECT_EQ(answered("first_contact_time | ball3 0 0 0 1 | ball3 4 0 0 1 | 4 0 0 0 0 0"), "0x1p-1");
  EXPECT_EQ(answered("first_contact | point3 0 0 1 | point3 0 0 -1 | triangle3 -4 -4 0 4 -4 0 0 4 0 | "
                     "triangle3 -4 -4 0 4 -4 0 0 4 0 | 0"),
            "0x1p-1 vertex 0 face 0");
  EXPECT_EQ(answered("contains | aabb3 0 0 0 2 2 2 | ball3 1 1 1 1"), "yes");
  EXPECT_EQ(answered("locate | aabb3 0 0 0 2 2 2 | point3 1 1 2"), "boundary");
  EXPECT_EQ(answered("hits | ray3 0 0 0 0 0 1 | triangle3 -1 -1 1 1 -1 1 0 1 1"), "yes");
  EXPECT_EQ(answered("first_hit_parameter | ray3 0 0 0 0 0 1 | triangle3 -1 -1 1 1 -1 1 0 1 1"), "0x1p+0");
  EXPECT_EQ(answered("intersection | segment2 0 0 2 2 | segment2 0 2 2 0"), "point 0x1p+0 0x1p+0 0x0p+0");
  EXPECT_EQ(answered("fit_aabb | triangle2 0 0 1 0 0 1"), "0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0");
  EXPECT_EQ(answered("support_value | ball3 0 0 0 1 | 0 0 2 0"), "0x1p+1");
  EXPECT_THAT(answered("penetration | aabb3 0 0 0 2 2 2 | aabb3 1 0 0 3 2 2"), StartsWith("0x1p+0 "));
  EXPECT_THAT(answered("contact | aabb3 0 0 0 2 2 2 | aabb3 0 0 2 2 2 4 | 0 1"),
              StartsWith("touching 0x0p+0 0x0p+0 0x0p+0 0x1p+0 corner "));
  EXPECT_EQ(answered("contact | aabb3 0 0 0 2 2 2 | aabb3 0 0 4 2 2 6 | 1 0"), "nothing");
}

TEST(QuestionLine, WhatRefusesIsAnAnswer) {
  EXPECT_THAT(answered("distance | ball3 0 0 0 1 | cylinder3 0 0 0 1 0 0 1"), StartsWith("refused: distance has no"));
  EXPECT_THAT(answered("locate | ball3 0 0 0 1 | ball3 0 0 0 1"), HasSubstr("the second figure is a point"));
  EXPECT_THAT(answered("contact | aabb3 0 0 0 2 2 2 | aabb3 0 0 4 2 2 6 | 1 0.5"), HasSubstr("no whole number"));
  EXPECT_THAT(answered("support_value | ball3 0 0 0 1 | 0 0 2 3"), HasSubstr("no whole number"));
}

// Every form, of figures of every kind at each place: what is read is what was written, and its answer is one line
// that stays behind the question.
TEST(QuestionLine, IsReadAsItWasWritten) {
  std::map<std::string, int> answers, refusals;
  for (const QuestionLine& asked : question_lines(7)) {
    QuestionLine told = asked;
    told.answer = answer_of(asked);
    ASSERT_FALSE(told.answer.empty()) << to_string(asked);
    const std::string line = to_string(told);
    ASSERT_EQ(line.find('\n'), line.npos) << line;
    const std::optional<QuestionLine> read = parse_question_line(line + "   # as it was");
    ASSERT_TRUE(read.has_value()) << line;
    EXPECT_EQ(*read, told) << line;
    EXPECT_EQ(answer_of(*read), told.answer) << line;
    ++(told.answer.starts_with("refused: ") ? refusals : answers)[told.question];
  }
  for (const QuestionForm& form : question_forms()) EXPECT_GT(answers[std::string(form.name)], 5) << form.name;
  EXPECT_GT(refusals.size(), 12U);
}

TEST(QuestionLine, IsNoneOfABlankLineOrARemark) {
  EXPECT_EQ(parse_question_line(""), std::nullopt);
  EXPECT_EQ(parse_question_line(" \t\r"), std::nullopt);
  EXPECT_EQ(parse_question_line("# relate | point3 0 0 0 | point3 0 0 0"), std::nullopt);
}

TEST(QuestionLine, WhatCannotBeReadSaysWhy) {
  const auto why = [](std::string_view line) {
    try {
      (void)parse_question_line(line);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("read");
  };
  EXPECT_THAT(why("touch | point3 0 0 0"), HasSubstr("there is no question 'touch'; there are relate, intersects"));
  EXPECT_THAT(why("relate | point3 0 0 0"), HasSubstr("relate takes two figures; here are 1 figures and 0 numbers"));
  EXPECT_THAT(why("intersects | point3 0 0 0 | point3 0 0 0 | 1"), HasSubstr("how far each moves"));
  EXPECT_THAT(why("contact | 1 0 | point3 0 0 0 | point3 0 0 0"), HasSubstr("numbers stand behind all figures"));
  EXPECT_THAT(why("relate | | point3 0 0 0"), HasSubstr("nothing stands between two bars"));
  EXPECT_THAT(why("relate | points3 0 0 0 | point3 0 0 0"), HasSubstr("there is no figure 'points3'"));
  EXPECT_THAT(why("relate | point3 0 0 x | point3 0 0 0"), HasSubstr("'x' is not a number"));
  EXPECT_THAT(why("relate | point3 0 0 | point3 0 0 0"), HasSubstr("2 numbers are no point"));
  EXPECT_THAT(why("relate | point3 0 0 inf | point3 0 0 0"), HasSubstr("'inf' is not a real number"));
  EXPECT_THROW(answer_of(QuestionLine{"relate", {}, {}, ""}), Error);
}

}  // namespace
}  // namespace plumb

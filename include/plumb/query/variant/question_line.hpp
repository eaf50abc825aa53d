// How is a question of figures written down with its answer, so that it can be asked again elsewhere?  One line:
//
//   relate | ball3 0x0p+0 0x0p+0 0x0p+0 0x1p+0 | segment3 0x1p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0 0x0p+0 = touching
//   contact | aabb3 ... | obb3 ... rigid ... | 0.5 4 = ...            margin, and how many corners at most
//
// its name, the figures as to_string(AnyFigure) writes them, numbers where the question takes any, and behind '=' the
// answer, if it is told.  Decimals are read too; '#' begins a remark.
//
//   answer_of(*parse_question_line("distance | point3 0 0 0 | point3 0 3 4")) == "0x1.4p+2"
//
// Laws: (1) parse_question_line(to_string(q)) == q.  (2) An answer is one text, the same on every machine and by every
// build: numbers are hexadecimal, exact ones fractions.  (3) What refuses the figures is an answer as well:
// `refused: ` and why.
// Source: RTCD 2.7.1.
// Cost: that of the question, and linear in the numbers.  Nothing is searched.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/query/body/any_figure.hpp"

namespace plumb {

struct QuestionLine {
  std::string question;
  std::vector<AnyFigure> figures;
  std::vector<double> numbers;
  std::string answer;  // empty: none is told
  friend bool operator==(const QuestionLine&, const QuestionLine&) = default;
};

struct QuestionForm {
  std::string_view name;
  std::size_t figures;
  std::size_t numbers;
  std::string_view arguments;  // in words, in order
};

/// All there are.  One name may stand for two forms, which their figures tell apart.
std::span<const QuestionForm> question_forms();

std::string to_string(const QuestionLine& line);

/// Nothing for a blank line or a remark.  Throws Error for what is no question, or not as many figures and numbers as
/// it takes, and names what it takes; what parse_figure throws for what is no figure.
std::optional<QuestionLine> parse_question_line(std::string_view line);

/// Whatever answer the line tells is not looked at.  Throws Error for a question that there is not.
std::string answer_of(const QuestionLine& line);

}  // namespace plumb

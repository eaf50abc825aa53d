#include "tool/fuzz/foreign_judge.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "certify/case_line.hpp"
#include "degenerate/words.hpp"
#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

using degenerate::Answer;
using degenerate::Kind;
using degenerate::Numbers;
using degenerate::Outcome;

class Judge {
 public:
  Judge(Kind kind, const std::string& library, const std::string& symbol, std::uint64_t memory_mib,
        ForeignLimits limits)
      : kind_(std::move(kind)), symbol_(symbol), process_({library, symbol, kind_, memory_mib}, limits) {}

  Answer answer(std::span<const double> numbers) {
    const Numbers asked(numbers.begin(), numbers.end());
    if (asked == last_ && !last_.empty()) return answer_;  // zeros of either sign are the same numbers
    Answer given(Outcome::crashed);
    const bool any = process_.ask({&asked, 1}, {&given, 1}) == 1;
    if (!any || given.outcome != Outcome::answered || given.numbers.empty()) {
      throw Error(fmt::format("fuzz: the judge {} has no answer: {}; the case is '{} {}'", printable(symbol_),
                              printable(words(kind_, given)), kind_.name, degenerate::joined(asked, " ", hexadecimal)));
    }
    last_ = asked;
    answer_ = given;
    return given;
  }

 private:
  const Kind kind_;
  const std::string symbol_;
  ForeignProcess process_;
  Numbers last_;
  Answer answer_;
};

}  // namespace

Kind judged_by(const Kind& kind, const std::string& library, const std::string& symbol, std::uint64_t memory_mib,
               ForeignLimits limits) {
  if (kind.form == degenerate::AnswerForm::triangles)
    throw Error(fmt::format("fuzz: --judge: many answers of {} are right, and a function has one", kind.name));
  const auto judge = std::make_shared<Judge>(kind, library, symbol, memory_mib, limits);
  Kind made = kind;
  made.exact = [judge](std::span<const double> numbers) { return judge->answer(numbers); };
  made.judge = {};
  made.also_right.clear();
  made.has_boundary = made.has_ends = false;
  made.exact_under = {};
  if (kind.form == degenerate::AnswerForm::sign)
    made.special = [judge](std::span<const double> numbers) { return judge->answer(numbers).numbers[0] == 0; };
  made.convention += fmt::format("; right is what {} answers", printable(symbol));
  return made;
}

}  // namespace plumb::tool

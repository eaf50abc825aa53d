#include <algorithm>
#include <array>
#include <cmath>

#include "arith/shortest_decimal.hpp"
#include "degenerate/fields.hpp"
#include "degenerate/known_answer.hpp"
#include "degenerate/words.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace plumb::degenerate {

namespace {

Judgment judged_sign(double given, double exact) {
  constexpr std::array<std::array<std::string_view, 3>, 3> sorts = {
      {{"", "- for 0", "- for +"}, {"0 for -", "", "0 for +"}, {"+ for -", "+ for 0", ""}}};
  const auto place = [](double x) { return x < 0 ? 0u : x > 0 ? 2u : 1u; };
  const std::string_view sort = sorts[place(given)][place(exact)];
  return {sort.empty() ? Verdict::right : Verdict::wrong, sort};
}

Judgment judged_yes_no(double given, double exact) {
  if ((given != 0) == (exact != 0)) return {};
  return {Verdict::wrong, given != 0 ? "yes for no" : "no for yes"};
}

// The distance of two doubles against what is allowed, in rational numbers.
bool within(double given, double exact, std::span<const double> lengths, const Tolerance& tolerance) {
  if (given == exact) return true;
  if (!std::isfinite(given) || !std::isfinite(exact)) return false;
  const auto apart = static_cast<std::uint64_t>(place_of(std::max(given, exact))) -
                     static_cast<std::uint64_t>(place_of(std::min(given, exact)));
  if (apart <= tolerance.ulps) return true;
  if (tolerance.relative == 0) return false;
  double largest = 0;
  for (const double x : lengths) largest = std::max(largest, std::fabs(x));
  const Rational off = Rational(std::max(given, exact)) - Rational(std::min(given, exact));
  return off <= Rational(tolerance.relative) * Rational(largest);
}

Judgment judged_number(double given, double exact, std::span<const double> lengths, const Tolerance& tolerance) {
  if (within(given, exact, lengths, tolerance)) return {};
  return {Verdict::wrong, given > exact ? "too large" : "too small"};
}

Judgment judged_hit(const Answer& given, const Answer& exact, const Tolerance& tolerance) {
  const Judgment hit = judged_yes_no(given.numbers[0], exact.numbers[0]);
  if (hit.verdict != Verdict::right || exact.numbers[0] == 0 || given.numbers.size() < 2) return hit;
  const double t = given.numbers[1];
  if (std::isnan(t)) return {Verdict::wrong, "hit without a parameter"};
  if (!knows_parameter(exact)) return {};
  if (within(t, exact.numbers[1], std::span(exact.numbers).subspan(1), tolerance)) return {};
  return {Verdict::wrong, t > exact.numbers[1] ? "parameter too large" : "parameter too small"};
}

Judgment judged_by(const Answer& exact, const Kind& kind, std::span<const double> numbers, const Answer& given,
                   const Tolerance& tolerance) {
  if (!is_known(kind, exact)) return {};
  switch (kind.form) {
    case AnswerForm::sign:
      return judged_sign(given.numbers[0], exact.numbers[0]);
    case AnswerForm::yes_no:
      return judged_yes_no(given.numbers[0], exact.numbers[0]);
    case AnswerForm::number:
      return judged_number(given.numbers[0], exact.numbers[0], gathered(numbers, lengths_of(kind, numbers)), tolerance);
    case AnswerForm::hit:
      return judged_hit(given, exact, tolerance);
    case AnswerForm::triangles:
      break;
  }
  return given.numbers == exact.numbers ? Judgment{} : Judgment{Verdict::wrong, "other triangles"};
}

}  // namespace

Judgment judge(const Kind& kind, std::span<const double> numbers, const Answer& given, const Tolerance& tolerance) {
  if (given.outcome != Outcome::answered) return {Verdict::failed, name_of(given.outcome)};
  if (given.numbers.size() == 1 && std::isnan(given.numbers[0])) return {Verdict::unsure, "NaN"};
  if (kind.judge) return kind.judge(numbers, given);
  if (given.numbers.empty()) return {Verdict::failed, "no answer"};
  const Judgment first = judged_by(kind.exact(numbers), kind, numbers, given, tolerance);
  if (first.verdict == Verdict::right) return first;
  for (const Exact& other : kind.also_right) {
    if (judged_by(other(numbers), kind, numbers, given, tolerance).verdict == Verdict::right) return {};
  }
  return first;
}

std::string decimal(double x) { return arith::shortest_decimal(x); }

std::string words(const Kind& kind, const Answer& answer) {
  if (answer.outcome != Outcome::answered) {
    std::string text(name_of(answer.outcome));
    return answer.note.empty() ? text : text.append(" (").append(answer.note).append(")");
  }
  if (kind.form == AnswerForm::triangles && (answer.numbers.empty() || !std::isnan(answer.numbers[0]))) {
    std::string text = std::to_string(answer.numbers.size() / 3).append(" triangles");
    for (std::size_t i = 0; i < answer.numbers.size(); ++i) {
      text.append(i % 3 != 0 ? " " : i == 0 ? ": (" : " (").append(decimal(answer.numbers[i]));
      if (i % 3 == 2) text.append(")");
    }
    return text;
  }
  if (answer.numbers.empty()) return "no answer";
  const double x = answer.numbers[0];
  if (std::isnan(x)) return "NaN";
  switch (kind.form) {
    case AnswerForm::sign:
      return x < 0 ? "-" : x > 0 ? "+" : "0";
    case AnswerForm::yes_no:
      return x != 0 ? "yes" : "no";
    case AnswerForm::hit:
      if (x == 0) return "no";
      return answer.numbers.size() < 2 ? "yes" : std::string("yes at ").append(decimal(answer.numbers[1]));
    default:
      return decimal(x);
  }
}

}  // namespace plumb::degenerate

#include <fmt/format.h>

#include "lab/chart/trial_report.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::lab {
namespace {

std::string row(const trial::Score& s, const trial::Trial& t, const Style& style) {
  std::string line = fmt::format("  {:<16}{:>9}{:>9}{:>14}{:>11}{:>12}", s.method, percent(s.wrong, s.asked),
                                 percent(s.unsure, s.asked), percent(s.inconsistent, s.asked), three_digits(s.ns),
                                 three_digits(s.allocations));
  if (t.kind == trial::AnswerKind::number) line += fmt::format("{:>12.3g}{:>12.3g}", s.mean_ulps, s.largest_ulps);
  for (const std::uint64_t counted : s.tallied) line += fmt::format("{:>13}", counted);
  line += "\n";
  return s.wrong != 0 ? style.red(line) : s.unsure == 0 ? style.green(line) : line;
}

}  // namespace

std::string trial_text(const trial::Trial& t, const Style& style) {
  const std::uint64_t cases = t.scores.empty() ? 0 : t.scores[0].asked;
  std::string text = style.bold(fmt::format("{}, {}", t.task, t.input)) +
                     fmt::format(": {} ({}: {})\n", t.question, plural(cases, "case", "cases"), t.about);
  if (t.kind == trial::AnswerKind::decision) {
    text += fmt::format("  true answers: {} negative, {} zero or no, {} positive or yes\n", t.truths[0], t.truths[1],
                        t.truths[2]);
  }
  for (const auto& [name, about] : t.tallies) text += fmt::format("  {}: {}\n", name, about);
  std::string head = fmt::format("  {:<16}{:>9}{:>9}{:>14}{:>11}{:>12}", "method", "wrong", "unsure", "inconsistent",
                                 "ns", "allocations");
  if (t.kind == trial::AnswerKind::number) head += fmt::format("{:>12}{:>12}", "mean ulps", "most ulps");
  for (const auto& tally : t.tallies) head += fmt::format("{:>13}", tally.name);
  text += style.bold(head) + "\n";
  for (const trial::Score& s : t.scores) text += row(s, t, style);
  return text;
}

}  // namespace plumb::lab

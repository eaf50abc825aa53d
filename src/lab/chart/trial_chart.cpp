#include <fmt/format.h>

#include "lab/chart/trial_report.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::lab {
namespace {

std::string hint_of(const trial::Score& s, const trial::Trial& t) {
  std::string hint =
      fmt::format("{}: {} of {} wrong, {} unsure, {} inconsistent; {} ns, {} allocations", s.method, s.wrong, s.asked,
                  s.unsure, s.inconsistent, three_digits(s.ns), three_digits(s.allocations));
  if (t.kind == trial::AnswerKind::number)
    hint += fmt::format("; off by {:.3g} ulps in the mean, {:.3g} at most", s.mean_ulps, s.largest_ulps);
  for (std::size_t k = 0; k < t.tallies.size(); ++k) hint += fmt::format("; {} {}", s.tallied[k], t.tallies[k].name);
  return hint;
}

}  // namespace

std::string trial_chart(const trial::Trial& t) {
  const bool number = t.kind == trial::AnswerKind::number;
  std::vector<ChartPoint> points;
  for (const trial::Score& s : t.scores) {
    const double part = 100 * s.share(s.unsure);
    const std::string label =
        s.unsure == 0 ? s.method : fmt::format("{} ({:.{}f}% unsure)", s.method, part, part < 1 ? 1 : 0);
    points.push_back({label, s.ns, number ? s.mean_ulps : s.share(s.wrong), s.unsure == 0, s.method, hint_of(s, t),
                      number ? s.largest_ulps : 0});
  }
  const std::uint64_t cases = t.scores.empty() ? 0 : t.scores[0].asked;
  return scatter_chart(
      {fmt::format("{}, {}", t.task, t.input),
       fmt::format("{}: {}, one thread", t.about, plural(cases, "case", "cases")), "nanoseconds per question",
       number ? "error in ulps: the mean, and a thin line up to the largest" : "share of wrong answers", true},
      points);
}

}  // namespace plumb::lab

// The table that the page opens with: tasks by methods, the worst of all classes.
#include <fmt/format.h>

#include <algorithm>

#include "lab/chart/trial_report.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::lab {
namespace {

using trial::Score;
using trial::Trial;

/// A method's scores on all classes of a task.
struct Seen {
  const Trial* trial;
  const Score* score;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::string cell(const std::string& method, const std::vector<Seen>& seen) {
  if (seen.empty()) return fmt::format("<td data-key=\"{}\"></td>", escaped(method));
  std::vector<double> times;
  for (const Seen& s : seen) times.push_back(s.score->ns);
  const auto [least, most] = std::ranges::minmax(times);
  const Seen worst = *std::ranges::max_element(seen, {}, [](const Seen& s) { return s.score->share(s.score->wrong); });
  const Score& w = *worst.score;
  const bool wrong = w.wrong > 0;
  const bool unsure = std::ranges::any_of(seen, [](const Seen& s) { return s.score->unsure > 0; });
  const std::string worst_of =
      wrong ? fmt::format("on {} {} of {} wrong", worst.trial->input, w.wrong, w.asked) : "never wrong";
  return fmt::format("<td data-key=\"{}\" title=\"{}: {}{}; {} to {} ns\"><span{}>{}</span><br><small>{}</small></td>",
                     escaped(method), escaped(method), escaped(worst_of), unsure ? "; not always sure" : "",
                     three_digits(least), three_digits(most), wrong ? " class=\"fails\"" : "",
                     wrong    ? percent(w.wrong, w.asked)
                     : unsure ? "0 or ?"
                              : "0",
                     three_digits(median(times)));
}

}  // namespace

bool is_all_right(const Trial& t) {
  return std::ranges::all_of(t.scores, [](const Score& s) { return s.wrong == 0 && s.inconsistent == 0; });
}

std::string trials_summary(std::span<const Trial> trials, std::span<const std::string> tasks,
                           std::span<const std::string> methods) {
  std::string html =
      "<section>\n<h2>Summary</h2>\n<article class=\"wide\">\n<p>The worst share of wrong answers over all classes of "
      "inputs, and the "
      "median time of a question in ns; ?: not always sure. Point at a cell for the class that is worst, and for how "
      "the "
      "times differ.</p>\n"
      "<div class=\"counts\"><table class=\"summary\">\n<thead><tr><th scope=\"col\">task</th>";
  for (const std::string& m : methods) html += fmt::format("<th scope=\"col\" data-key=\"{0}\">{0}</th>", escaped(m));
  html += "</tr></thead>\n";
  for (const std::string& task : tasks) {
    html += fmt::format("<tr data-task=\"{0}\"><th scope=\"row\"><a href=\"#{0}\">{0}</a></th>", escaped(task));
    for (const std::string& method : methods) {
      std::vector<Seen> seen;
      for (const Trial& t : trials) {
        if (t.task != task) continue;
        for (const Score& s : t.scores) {
          if (s.method == method) seen.push_back({&t, &s});
        }
      }
      html += cell(method, seen);
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n</article>\n</section>\n";
}

}  // namespace plumb::lab

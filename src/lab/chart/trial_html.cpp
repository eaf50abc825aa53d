// The report as one page: every chart and table, to be filtered.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/chart/trial_report.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::lab {
namespace {

/// Those of `all` in the order in which they first come.
template <class Name>
std::vector<std::string> distinct(std::span<const trial::Trial> trials, Name names_of) {
  std::vector<std::string> names;
  for (const trial::Trial& t : trials) {
    for (const std::string& name : names_of(t)) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::string table(const trial::Trial& t) {
  const bool number = t.kind == trial::AnswerKind::number;
  std::string tallies;
  for (const auto& [name, about] : t.tallies)
    tallies += fmt::format("<th scope=\"col\" title=\"{}\">{}</th>", escaped(about), escaped(name));
  std::string text = fmt::format(
      "<details><summary>Figures</summary><div><table>\n<tr><th scope=\"col\">method</th><th scope=\"col\">wrong</th>"
      "<th scope=\"col\">unsure</th><th scope=\"col\">inconsistent</th><th scope=\"col\">of</th>"
      "<th scope=\"col\">ns</th><th scope=\"col\">allocations</th>{}{}</tr>\n",
      number ? "<th scope=\"col\">mean ulps</th><th scope=\"col\">most ulps</th>" : "", tallies);
  for (const trial::Score& s : t.scores) {
    text += fmt::format(
        "<tr data-key=\"{0}\"><td>{0}</td><td>{1}</td><td>{2}</td><td>{3}</td><td>{4}</td><td>{5}</td><td>{6}</td>",
        escaped(s.method), s.wrong, s.unsure, s.inconsistent, s.asked, three_digits(s.ns), three_digits(s.allocations));
    if (number) text += fmt::format("<td>{:.3g}</td><td>{:.3g}</td>", s.mean_ulps, s.largest_ulps);
    for (const std::uint64_t counted : s.tallied) text += fmt::format("<td>{}</td>", counted);
    text += "</tr>\n";
  }
  return text + "</table></div></details>\n";
}

}  // namespace

std::string trials_html(std::span<const trial::Trial> trials, const nlohmann::json& raw) {
  using Names = std::vector<std::string>;
  const Names tasks = distinct(trials, [](const trial::Trial& t) { return Names{t.task}; });
  ReportPage page{
      "Methods against each other",
      "What exactness costs, and what it buys",
      fmt::format("{} cases a class, seed {}", raw.at("cases").get<std::uint64_t>(),
                  raw.at("seed").get<std::uint64_t>()),
      "The summary tells of each task and method how often it is wrong at the worst, and how long it takes. Below, "
      "each chart holds the methods against each other on one class of inputs; charts without a wrong answer are "
      "folded. "
      "What is never wrong stands in the band marked 0; a faint mark does not answer every question; the "
      "dashed line joins the methods that none beats in both. Point at a mark, or move to it by the tabulator, for its "
      "figures.",
      {},
      ""};
  page.filters.push_back({"task", "Tasks", tasks});
  page.filters.push_back(
      {"class", "Classes of inputs", distinct(trials, [](const trial::Trial& t) { return Names{t.input}; })});
  const Names methods = distinct(trials, [](const trial::Trial& t) {
    Names names;
    for (const trial::Score& s : t.scores) names.push_back(s.method);
    return names;
  });
  page.filters.push_back({"method", "Methods", methods});
  page.opening = trials_summary(trials, tasks, methods);
  for (const std::string& task : tasks) {
    std::string question, wrong, right, names;
    std::size_t folded = 0;
    for (const trial::Trial& t : trials) {
      if (t.task != task) continue;
      question = t.question;
      std::string article = fmt::format("<article data-task=\"{}\" data-class=\"{}\">\n{}{}</article>\n",
                                        escaped(t.task), escaped(t.input), inline_picture(trial_chart(t)), table(t));
      if (!is_all_right(t)) {
        wrong += article;
        continue;
      }
      right += article;
      names.append(names.empty() ? "" : ", ").append(t.input);
      ++folded;
    }
    page.body += fmt::format("<section id=\"{0}\">\n<h2>{0}: {1}</h2>\n{2}", escaped(task), escaped(question), wrong);
    if (folded > 0) {
      page.body += fmt::format("<details class=\"fold\"><summary>Nothing is wrong on {}</summary>\n{}</details>\n",
                               escaped(names), right);
    }
    page.body += "</section>\n";
  }
  return report_page(page, raw);
}

}  // namespace plumb::lab

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/stability/report.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/report_page.hpp"

namespace plumb::lab {
namespace {

using stability::Count;
using stability::MethodOutcome;

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

std::string table(const stability::Findings& findings) {
  if (findings.outcomes.empty()) return "";
  std::string html = "<div class=\"counts\"><table>\n<tr><th scope=\"col\">method</th>";
  for (const Count& c : findings.outcomes.front().counts) {
    html += fmt::format("<th scope=\"col\">{}</th>", escaped(c.failure));
  }
  html += "</tr>\n";
  for (const MethodOutcome& o : findings.outcomes) {
    html += fmt::format("<tr data-key=\"{0}\"><td>{0}</td>", escaped(o.method));
    for (const Count& c : o.counts) {
      html += fmt::format("<td{}>{} of {}</td>", c.failures == 0 ? "" : " class=\"fails\"", c.failures, c.of);
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string article(const SceneReport& r) {
  std::string html = fmt::format("<article data-experiment=\"{}\">\n<h3>{}</h3>\n<p>{}</p>\n{}", escaped(r.experiment),
                                 escaped(r.scene), escaped(r.about), table(r.findings));
  for (const stability::Picture& p : r.findings.pictures) {
    html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", inline_picture(p.svg), escaped(p.caption));
  }
  return html + "</article>\n";
}

}  // namespace

std::string scenes_html(std::span<const SceneReport> reports, const nlohmann::json& raw) {
  ReportPage page{
      "The stability laboratory",
      "Where methods fail",
      fmt::format("{}seed {}", raw.at("quick").get<bool>() ? "quick, " : "", raw.at("seed").get<std::uint64_t>()),
      "Each table counts how often a method failed, in the terms of who uses it, out of how many trials in "
      "which it could have. What is told exactly from the points as they are fails nothing anywhere: that is tested.",
      {},
      ""};
  std::vector<std::string> experiments, methods;
  for (const SceneReport& r : reports) {
    add_once(experiments, r.experiment);
    for (const MethodOutcome& o : r.findings.outcomes) add_once(methods, o.method);
  }
  page.filters = {{"experiment", "Experiments", experiments}, {"method", "Methods", methods}};
  for (const std::string& experiment : experiments) {
    const auto first = std::ranges::find(reports, experiment, &SceneReport::experiment);
    page.body += fmt::format("<section>\n<h2>{}: {}</h2>\n<p class=\"about\">{}</p>\n", escaped(experiment),
                             escaped(first->question), escaped(first->source));
    for (const SceneReport& r : reports) {
      if (r.experiment == experiment) page.body += article(r);
    }
    page.body += "</section>\n";
  }
  return report_page(page, raw);
}

}  // namespace plumb::lab

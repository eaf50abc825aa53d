#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/degenerate/paste.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/fuzz/drawing.hpp"
#include "tool/fuzz/report.hpp"

namespace plumb::tool {
namespace {

std::string article(const FuzzReport& r, std::size_t number, const SortOfFailure& found) {
  const degenerate::Finding& f = *found.simplest;
  std::string generators;
  for (const std::string& g : found.generators) generators.append(generators.empty() ? "" : ", ").append(g);
  std::string html = fmt::format(
      "<article>\n<h3>{}. {}</h3>\n<p>{}{}{}</p>\n<p>given <span class=\"fails\">{}</span>, exact {}</p>\n"
      "{}{}"
      "<details><summary>The case</summary><div><pre>{}\n\n{}</pre></div></details>\n",
      number, escaped(printable(f.sort)), escaped(generators), f.degenerate ? "; found with a degenerate figure" : "",
      f.repeated ? "" : "; asked again by itself it did not fail", escaped(printable(words(r.kind, f.given))),
      escaped(words(r.kind, f.exact)), case_drawings(r.kind, f.smallest), near_coincidences(r.kind, f.smallest),
      escaped(decimal_text(r.kind, f.smallest)), escaped(replay_line(r.options, r.kind, f.smallest)));
  for (const PasteFormat& format : paste_formats) {
    html += fmt::format("<details><summary>{}</summary><div><pre>{}</pre></div></details>\n", format.title,
                        escaped(pasteable(format.name, r.kind, f.smallest, r.options)));
  }
  return html + "</article>\n";
}

std::string table(const FuzzReport& r) {
  std::string html =
      "<div class=\"counts\"><table>\n<tr><th scope=\"col\">generator</th><th scope=\"col\">asked</th>"
      "<th scope=\"col\">wrong</th><th scope=\"col\">failed</th><th scope=\"col\">degenerate</th>"
      "<th scope=\"col\">unsure</th></tr>\n";
  const auto cell = [](std::uint64_t count) {
    return fmt::format("<td{}>{}</td>", count == 0 ? "" : " class=\"fails\"", count);
  };
  for (const degenerate::Tally& t : r.run.findings.tallies) {
    html += fmt::format("<tr><td>{}</td><td>{}</td>{}{}<td>{}</td><td>{}</td></tr>\n", escaped(t.generator), t.asked,
                        cell(t.wrong), cell(t.failed), t.degenerate, t.unsure);
  }
  return html + "</table></div>\n";
}

}  // namespace

std::string fuzz_html(const FuzzReport& r, const nlohmann::json& raw) {
  ReportPage page{"plumb fuzz",
                  fmt::format("{} of {}", printable(r.options.symbol), printable(r.options.library)),
                  fmt::format("{} cases, seed {}{}", r.run.findings.asked(), r.options.seed, declared(r.options)),
                  fmt::format("{}: {} Right is: {}. Every answer was held against the exact one; each finding below "
                              "is the smallest case of its sort.",
                              r.kind.name, r.kind.question, r.kind.convention),
                  {},
                  {}};
  page.body = fmt::format("<section>\n<h2>How often</h2>\n<article>\n{}{}</article>\n</section>\n",
                          inline_picture(fuzz_chart(r)), table(r));
  if (!r.found.empty()) {
    page.body += "<section>\n<h2>What was found</h2>\n";
    for (std::size_t i = 0; i < r.found.size(); ++i) page.body += article(r, i + 1, r.found[i]);
    page.body += "</section>\n";
  }
  return report_page(page, raw);
}

}  // namespace plumb::tool

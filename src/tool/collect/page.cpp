#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tool/collect/command.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string count_table(std::string_view title, const std::map<std::string, std::size_t>& counts, std::size_t of) {
  std::string html = fmt::format("<table><thead><tr><th>{}</th><th>models</th><th>share</th></tr></thead>\n", title);
  for (const auto& [name, n] : counts)
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(name), grouped(n), percent(n, of));
  return html + "</table>\n";
}

std::string worst_row(const CollectedModel& m) {
  return fmt::format(
      "<tr data-verdict=\"{0}\"><td>{1}</td><td>{0}</td><td>{2}</td><td>{3}</td><td>{4}</td><td>{5}</td>"
      "<td>{6}</td></tr>\n",
      escaped(m.verdict), escaped(m.name), escaped(fmt::format("{}", fmt::join(m.defects, ", "))),
      escaped(m.why.empty() ? m.faults : m.why), m.triangles ? grouped(*m.triangles) : "", three_digits(m.milliseconds),
      three_digits(m.peak_mib));
}

}  // namespace

std::string collection_page(const Collection& all) {
  ReportPage page;
  page.title = fmt::format("plumb {}: {}", all.command, all.corpus);
  page.heading = fmt::format("{} of {}", plural(all.models.size(), "model", "models"), all.corpus);
  page.settings = fmt::format("plumb {} in {}", all.command, plural(all.shards, "shard", "shards"));
  page.introduction =
      fmt::format("Digest {:016x}: what was found of each model, whatever the number of shards.", all.digest);
  if (!all.unfinished.empty())
    page.opening = fmt::format("<p class=\"fails\">{} not at the end; their models may be missing.</p>\n",
                               plural(all.unfinished.size(), "shard is", "shards are"));
  page.opening += count_table("verdict", all.verdicts, all.models.size());
  if (!all.defects.empty()) page.opening += count_table("defect", all.defects, all.models.size());
  PageFilter verdicts{"verdict", "Verdicts", {}};
  const std::size_t shown = std::min(most_on_page, all.worst.size());
  page.body = fmt::format(
      "<section><h2>The worst{}</h2>\n<article class=\"counts\"><table><thead><tr><th>model</th>"
      "<th>verdict</th><th>defects</th><th>what</th><th>triangles</th><th>ms</th><th>MiB</th></tr>"
      "</thead>\n",
      shown < all.worst.size() ? fmt::format(" {} of {}", shown, grouped(all.worst.size())) : "");
  for (std::size_t i = 0; i < shown; ++i) {
    const CollectedModel& model = all.models[all.worst[i]];
    page.body += worst_row(model);
    if (std::ranges::count(verdicts.names, model.verdict) == 0) verdicts.names.push_back(model.verdict);
  }
  page.body += "</table></article></section>\n";
  if (verdicts.names.size() > 1) page.filters.push_back(std::move(verdicts));
  return report_page(page, collection_json(all, false));
}

}  // namespace plumb::tool

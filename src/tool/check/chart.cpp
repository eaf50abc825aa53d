#include "tool/drawing/chart.hpp"

#include <fmt/format.h>

#include <vector>

#include "tool/check/command.hpp"
#include "tool/check/report.hpp"

namespace plumb::tool {

std::string chart_svg(std::span<const MeshCheck> checks) {
  Comparison total;
  for (const MeshCheck& c : checks) total += c.total();
  std::vector<ChartPoint> points;
  for (std::size_t m = 0; m < method_count; ++m) {
    const Tally& t = total.method[m];
    if (t.taken == 0) continue;
    const double unsure = 100.0 * static_cast<double>(t.unsure) / static_cast<double>(t.taken);
    const std::string label =
        t.unsure == 0 ? std::string(method_names[m]) : fmt::format("{} ({:.2g}% unsure)", method_names[m], unsure);
    points.push_back({label, t.ns_per_decision(), t.wrong_share()});
  }
  const std::string meshes = checks.size() == 1 ? checks[0].name : fmt::format("{} meshes", checks.size());
  const std::string sample =
      total.sampled() == total.taken() ? "" : fmt::format(" (the inexact methods: {} of them)", total.sampled());
  return scatter_chart({"Wrong signs against time",
                        fmt::format("{} decisions on {}{}, one thread a core", total.taken(), meshes, sample),
                        "nanoseconds per decision", "share of wrong signs"},
                       points);
}

}  // namespace plumb::tool

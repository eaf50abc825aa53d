#include <fmt/format.h>

#include <algorithm>

#include "lab/stability/report.hpp"

namespace plumb::lab {
namespace {

using stability::Count;
using stability::MethodOutcome;

std::string row(const MethodOutcome& outcome, std::size_t width, const Style& style) {
  std::string line = fmt::format("  {:<{}}", outcome.method, width);
  bool failed = false;
  for (const Count& c : outcome.counts) {
    line += fmt::format("{:>18}", fmt::format("{} of {}", c.failures, c.of));
    failed = failed || c.failures != 0;
  }
  line += "\n";
  return failed ? style.red(line) : style.green(line);
}

}  // namespace

std::string scene_text(const SceneReport& r, const Style& style) {
  std::string text = style.bold(fmt::format("{}: {}", r.experiment, r.scene)) + fmt::format(": {}\n", r.about);
  if (r.findings.outcomes.empty()) return text;
  std::size_t width = 16;
  for (const MethodOutcome& o : r.findings.outcomes) width = std::max(width, o.method.size() + 1);
  std::string head = fmt::format("  {:<{}}", "method", width);
  char letter = 'A';
  for (const Count& c : r.findings.outcomes.front().counts) {
    text += fmt::format("  {}: {}\n", letter, c.failure);
    head += fmt::format("{:>18}", letter++);
  }
  text += style.bold(head) + "\n";
  for (const MethodOutcome& o : r.findings.outcomes) text += row(o, width, style);
  return text;
}

std::vector<std::string> failed_exactly(std::span<const SceneReport> reports) {
  const auto failed = [](const MethodOutcome& o) {
    return o.exact && std::ranges::any_of(o.counts, [](const Count& c) { return c.failures != 0; });
  };
  std::vector<std::string> names;
  for (const SceneReport& r : reports) {
    if (std::ranges::any_of(r.findings.outcomes, failed)) names.push_back(fmt::format("{}: {}", r.experiment, r.scene));
  }
  return names;
}

}  // namespace plumb::lab

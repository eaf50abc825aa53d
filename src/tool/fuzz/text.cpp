#include <fmt/format.h>

#include <algorithm>

#include "plumb/degenerate/paste.hpp"
#include "tool/fuzz/report.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

using degenerate::Finding;
using degenerate::Kind;
using degenerate::Numbers;
using degenerate::Tally;

constexpr std::size_t kNamed = 6;  // generators of a finding

/// A word as a shell takes it literally.
std::string quoted(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_./-+=:,").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string text = "'";
  for (const char c : word) c == '\'' ? text.append("'\\''") : text.append(1, c);
  return text.append("'");
}

/// Shares between 0 and 100 % are never rounded to either.
std::string percent(const Tally& t) {
  const std::uint64_t bad = t.wrong + t.failed;
  if (t.asked == 0) return "";
  if (bad == 0) return "0 %";
  if (bad == t.asked) return "100 %";
  const double share = 100 * t.share_wrong();
  if (share < 0.01) return "< 0.01 %";
  return share > 99.9 ? "> 99.9 %" : share < 10 ? fmt::format("{:.2f} %", share) : fmt::format("{:.1f} %", share);
}

std::string table(const FuzzReport& r, const Style& style) {
  std::size_t width = 9;
  for (const Tally& t : r.run.findings.tallies) width = std::max(width, t.generator.size());
  std::string text = style.dim(fmt::format("  {:{}} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10}", "generator", width,
                                           "asked", "wrong", "failed", "share", "degenerate", "unsure")) +
                     "\n";
  for (const Tally& t : r.run.findings.tallies) {
    const std::string share = fmt::format("{:>10}", percent(t));
    text += fmt::format("  {:{}} {:>10} {:>10} {:>10} {} {:>10} {:>10}\n", t.generator, width, t.asked, t.wrong,
                        t.failed, t.wrong + t.failed == 0 ? share : style.red(share), t.degenerate, t.unsure);
  }
  return text;
}

std::string one_finding(const FuzzReport& r, std::size_t number, const SortOfFailure& found, const Style& style) {
  const Finding& f = *found.simplest;
  std::string generators;
  for (std::size_t i = 0; i < std::min(found.generators.size(), kNamed); ++i)
    generators.append(i == 0 ? "" : ", ").append(found.generators[i]);
  if (found.generators.size() > kNamed) generators += fmt::format(" and {} more", found.generators.size() - kNamed);
  std::string text =
      fmt::format("\n{}  ({})\n", style.bold(fmt::format("{}. {}", number, printable(f.sort))), generators);
  if (!f.repeated) text += "asked again by itself it did not fail: it depends on what was asked before, or on chance\n";
  text += fmt::format("given {}, exact {}\n{}\n{}\n", style.red(printable(words(r.kind, f.given))),
                      style.green(words(r.kind, f.exact)), decimal_text(r.kind, f.smallest),
                      replay_line(r.options, r.kind, f.smallest));
  for (const std::string& format : r.options.formats)
    text += fmt::format("\n{}", pasteable(format, r.kind, f.smallest, r.options));
  return text;
}

std::string summary(const FuzzReport& r, const Style& style) {
  std::uint64_t bad = 0, unsure = 0;
  for (const Tally& t : r.run.findings.tallies) bad += t.wrong + t.failed, unsure += t.unsure;
  const std::uint64_t asked = r.run.findings.asked();
  std::string text = bad == 0 ? style.green("nothing found in " + plural(asked, "case", "cases"))
                              : style.red(fmt::format("{} of {} failed", bad, plural(asked, "case", "cases")));
  if (unsure > 0) text += fmt::format(", {} answered NaN, which is no finding", unsure);
  std::uint64_t passed_over = 0;
  for (const Tally& t : r.run.findings.tallies) passed_over += t.passed_over;
  if (passed_over > 0) text += fmt::format("; of {} more the generators have none in the domain", passed_over);
  switch (r.run.end) {
    case FuzzRun::End::budget:
      break;
    case FuzzRun::End::interrupted:
      text += "; interrupted before the budget was spent";
      break;
    case FuzzRun::End::exhausted:
      text += "; ended early, because too many calls crashed or hung";
      break;
  }
  return text + "\n";
}

}  // namespace

std::string declared(const FuzzOptions& o) {
  const FuzzOptions standard;
  const degenerate::Domain &d = o.domain, everything;
  std::string text;
  const auto add = [&](bool given, std::string_view option, const std::string& value) {
    if (given) text.append(" --").append(option).append(value.empty() ? "" : " ").append(value);
  };
  add(o.boundary != standard.boundary, "boundary", o.boundary);
  add(o.ends != standard.ends, "ends", o.ends);
  add(!d.degenerate, "no-degenerate", "");
  add(d.largest != everything.largest, "range", fmt::format("{}", d.largest));
  add(d.smallest != everything.smallest, "smallest", fmt::format("{}", d.smallest));
  add(d.grid != everything.grid, "grid", fmt::format("{}", d.grid));
  add(d.bits != everything.bits, "bits", fmt::format("{}", d.bits));
  return text;
}

std::string replay_line(const FuzzOptions& o, const Kind& kind, const Numbers& numbers) {
  std::string line = fmt::format("plumb fuzz --kind {} --library {} --symbol {}", kind.name,
                                 quoted(printable(o.library)), quoted(printable(o.symbol)));
  const FuzzOptions standard;
  if (o.judge) line += fmt::format(" --judge {}", quoted(printable(*o.judge)));
  for (const std::string& a : o.arguments) line += fmt::format(" --argument {}", quoted(a));
  if (o.answer != standard.answer) line += fmt::format(" --answer {}", o.answer);
  line += declared(o);
  if (o.ulps) line += fmt::format(" --ulps {}", *o.ulps);
  if (o.relative) line += fmt::format(" --relative {}", *o.relative);
  if (o.timeout != standard.timeout) line += fmt::format(" --timeout {}", o.timeout);
  if (o.memory_mib != standard.memory_mib) line += fmt::format(" --memory {}", o.memory_mib);
  return line + fmt::format(" --case {}", quoted(case_line(kind, numbers)));
}

std::optional<degenerate::Tolerance> tolerance_of(const FuzzOptions& o, const Kind& kind) {
  if (!o.ulps && !o.relative) return std::nullopt;
  degenerate::Tolerance tolerance = kind.tolerance;
  tolerance.ulps = o.ulps.value_or(tolerance.ulps);
  tolerance.relative = o.relative.value_or(tolerance.relative);
  return tolerance;
}

std::string pasteable(std::string_view format, const Kind& kind, const Numbers& numbers, const FuzzOptions& o) {
  if (format == "cpp") return cpp_text(kind, numbers, o.symbol);
  if (format == "python") return python_text(kind, numbers, o.symbol, {o.library, o.timeout, tolerance_of(o, kind)});
  return obj_text(kind, numbers);
}

std::string fuzz_text(const FuzzReport& r, const Style& style) {
  const std::string switches = declared(r.options);
  std::string text = fmt::format("{}: {}\n{} of {}, seed {}{}{}\n\n", style.bold(r.kind.name), r.kind.question,
                                 printable(r.options.symbol), printable(r.options.library), r.options.seed,
                                 switches.empty() ? "" : ";", switches);
  text += table(r, style);
  for (std::size_t i = 0; i < r.found.size(); ++i) text += one_finding(r, i + 1, r.found[i], style);
  return text + "\n" + summary(r, style);
}

}  // namespace plumb::tool

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "tool/collect/command.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

/// The most first.
std::vector<std::pair<std::string, std::size_t>> by_count(const std::map<std::string, std::size_t>& counts) {
  std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, {}, [](const auto& c) { return ~c.second; });
  return sorted;
}

std::string count_lines(const std::map<std::string, std::size_t>& counts, std::size_t of) {
  std::string text;
  for (const auto& [name, n] : by_count(counts))
    text += fmt::format("  {:<20}{:>12}  {}\n", printable(name), grouped(n), percent(n, of));
  return text;
}

std::string unfinished_text(const Collection& all) {
  constexpr std::size_t named = 10;
  std::string numbers;
  for (std::size_t i = 0; i < std::min(named, all.unfinished.size()); ++i)
    numbers += fmt::format("{}{}/{}", i == 0 ? "" : ", ", all.unfinished[i], all.shards);
  if (all.unfinished.size() > named) numbers += fmt::format(" and {} more", all.unfinished.size() - named);
  return fmt::format("not at their end: {}; run them again, with the same options\n", numbers);
}

/// "faulty (open, opposite): 3 open edges", "timeout: took more than 1 s"
std::string what_of(const CollectedModel& model) {
  std::string text = model.verdict;
  if (!model.defects.empty()) text += fmt::format(" ({})", fmt::join(model.defects, ", "));
  const std::string& more = model.why.empty() ? model.faults : model.why;
  return more.empty() ? text : text + ": " + more;
}

std::string csv_quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string collection_text(const Collection& all, std::size_t worst, const Style& style) {
  std::string text =
      style.bold(fmt::format("plumb {} of {}: {} in {}\n", printable(all.command), printable(all.corpus),
                             plural(all.models.size(), "model", "models"), plural(all.shards, "shard", "shards")));
  if (!all.unfinished.empty()) text += style.red(unfinished_text(all));
  text += count_lines(all.verdicts, all.models.size());
  if (!all.defects.empty()) text += "with defects, which are\n" + count_lines(all.defects, all.models.size());
  text += fmt::format("{} triangles, {} s of all processes, at most {} MiB\n", grouped(all.triangles),
                      three_digits(all.milliseconds / 1000), three_digits(all.peak_mib));
  const std::size_t shown = std::min(worst, all.worst.size());
  if (shown != 0) text += "the worst\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const CollectedModel& model = all.models[all.worst[i]];
    text += fmt::format("  {}: {}\n", printable(model.name), printable(what_of(model)));
  }
  if (shown != 0 && shown < all.worst.size()) text += fmt::format("  and {} more\n", grouped(all.worst.size() - shown));
  return text + fmt::format("digest {:016x} of {}\n", all.digest, plural(all.models.size(), "model", "models"));
}

std::string collection_csv(const Collection& all) {
  std::string text = "model,verdict,defects,faults,triangles,ms,peak_mib,why\n";
  for (const CollectedModel& m : all.models)
    text += fmt::format("{},{},{},{},{},{:.1f},{},{}\n", csv_quoted(m.name), csv_quoted(m.verdict),
                        csv_quoted(fmt::format("{}", fmt::join(m.defects, " "))), csv_quoted(m.faults),
                        m.triangles ? std::to_string(*m.triangles) : "", m.milliseconds, m.peak_mib, csv_quoted(m.why));
  return text;
}

json collection_json(const Collection& all, bool with_models) {
  json report = origin_json("plumb collect");
  const auto counts = [](const std::map<std::string, std::size_t>& of, const char* name) {
    json list = json::array();
    for (const auto& [word, n] : by_count(of)) list.push_back({{name, word}, {"model_count", n}});
    return list;
  };
  report["corpus"] = all.corpus;
  report["corpus_command"] = all.command;
  report["shard_count"] = all.shards;
  report["unfinished_shards"] = all.unfinished;
  report["model_count"] = all.models.size();
  report["findings_digest"] = fmt::format("{:016x}", all.digest);
  report["processes_ms"] = all.milliseconds;
  report["peak_mib"] = all.peak_mib;
  report["by_verdict"] = counts(all.verdicts, "model_verdict");
  report["by_defect"] = counts(all.defects, "model_defect");
  report["corpus_models"] = json::array();
  if (!with_models) return report;
  for (const CollectedModel& m : all.models) {
    json model{{"model", m.name},
               {"model_verdict", m.verdict},
               {"model_defects", m.defects},
               {"model_faults", m.faults},
               {"fault_count", m.fault_count},
               {"model_ms", m.milliseconds},
               {"peak_mib", m.peak_mib},
               {"model_why", m.why}};
    if (m.triangles) model["triangles"] = *m.triangles;
    report["corpus_models"].push_back(std::move(model));
  }
  return report;
}

}  // namespace plumb::tool

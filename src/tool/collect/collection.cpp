#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "plumb/arith/error.hpp"
#include "tool/collect/command.hpp"
#include "tool/corpus/shard_file.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What of a line every run finds alike.
std::string found_alike(json line) {
  line.erase("measured");
  line.erase("why");
  return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::uint64_t whole_number_of(const json& line, const char* name) {
  const auto at = line.find(name);
  return at != line.end() && at->is_number_unsigned() ? at->get<std::uint64_t>() : 0;
}

double measured_of(const json& line, const char* name) {
  const auto measured = line.find("measured");
  if (measured == line.end() || !measured->is_object()) return 0;
  const auto at = measured->find(name);
  return at != measured->end() && at->is_number() ? at->get<double>() : 0;
}

CollectedModel model_of(const json& line) {
  CollectedModel model{line.at("model").get<std::string>(), line.at("verdict").get<std::string>(), {}, {}, {}, 0, {}};
  if (const auto why = line.find("why"); why != line.end() && why->is_string()) model.why = why->get<std::string>();
  if (const auto defects = line.find("defects"); defects != line.end() && defects->is_array()) {
    for (const json& defect : *defects)
      if (defect.is_string()) model.defects.push_back(defect.get<std::string>());
  }
  if (const auto faults = line.find("faults"); faults != line.end() && faults->is_object()) {
    std::vector<std::pair<std::uint64_t, std::string>> counts;
    for (const auto& [name, count] : faults->items())
      if (count.is_number_unsigned()) counts.emplace_back(count.get<std::uint64_t>(), name);
    std::ranges::sort(
        counts, [](const auto& a, const auto& b) { return std::tie(b.first, a.second) < std::tie(a.first, b.second); });
    for (const auto& [count, name] : counts) {
      model.fault_count += count;
      model.faults += fmt::format("{}{} {}", model.faults.empty() ? "" : "; ", count, name);
    }
  }
  if (line.contains("triangles")) model.triangles = whole_number_of(line, "triangles");
  model.milliseconds = 1000 * measured_of(line, "seconds");
  model.peak_mib = measured_of(line, "peak_mib");
  return model;
}

constexpr std::array<std::string_view, 8> bad_verdicts{"crashed", "timeout", "out_of_memory", "unreadable",
                                                       "refused", "left",    "faulty",        "clashing"};

std::vector<std::size_t> worst_of(const std::vector<CollectedModel>& models) {
  const auto rank = [&](std::size_t i) {
    const auto at = std::ranges::find(bad_verdicts, models[i].verdict);
    return std::tuple(at - bad_verdicts.begin(), ~models[i].defects.size(), ~models[i].fault_count, i);
  };
  std::vector<std::size_t> worst;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (std::ranges::count(bad_verdicts, models[i].verdict) != 0) worst.push_back(i);
  std::ranges::sort(worst, {}, rank);
  return worst;
}

[[noreturn]] void refuse_mixture(const fs::path& path, std::string_view what) {
  throw Error(fmt::format("{}: it is of another {} than a shard beside it; give each its own folder",
                          printable(path.string()), what));
}

/// Every line, with what of it goes into the digest.
std::map<std::string, std::pair<CollectedModel, std::string>> lines_by_model(const std::vector<FoundShard>& files,
                                                                             Collection& all,
                                                                             std::set<std::uint32_t>& whole) {
  std::map<std::string, std::pair<CollectedModel, std::string>> models;
  json first;
  for (const FoundShard& file : files) {
    const ShardLines lines = read_shard(file.path);
    if (file.command != all.command) refuse_mixture(file.path, "command");
    if (file.shard.count != all.shards) refuse_mixture(file.path, "number of shards");
    if (lines.title.is_null()) continue;  // its run was stopped at once
    json title = lines.title;
    title.erase("shard");
    if (first.is_null()) first = title;
    if (title != first) refuse_mixture(file.path, "corpus, with other options or by another version");
    if (lines.whole) whole.insert(file.shard.number);
    for (const json& line : lines.models) {
      CollectedModel model = model_of(line);
      std::string name = model.name;
      if (!models.try_emplace(name, std::move(model), found_alike(line)).second)
        throw Error(fmt::format("{}: another line tells of {} as well; remove the folder, and start anew",
                                printable(file.path.string()), printable(name)));
    }
  }
  if (!first.is_null()) all.corpus = first.at("corpus").get<std::string>();
  return models;
}

}  // namespace

Collection collect(const fs::path& folder) {
  const std::vector<FoundShard> files = shard_files(folder);
  if (files.empty())
    throw Error(fmt::format("{}: this folder holds no shard; 'plumb check FOLDER --shard I/N --out DIR' makes them",
                            printable(folder.string())));
  Collection all;
  all.command = files[0].command;
  all.shards = files[0].shard.count;
  std::set<std::uint32_t> whole;
  auto models = lines_by_model(files, all, whole);
  for (std::uint32_t i = 1; i <= all.shards; ++i)
    if (!whole.contains(i)) all.unfinished.push_back(i);
  for (auto& [name, model] : models) {
    all.digest = hash_of_text(fmt::format("{:016x}{}", all.digest, model.second));
    CollectedModel& found = all.models.emplace_back(std::move(model.first));
    ++all.verdicts[found.verdict];
    for (const std::string& defect : found.defects) ++all.defects[defect];
    all.triangles += found.triangles.value_or(0);
    all.milliseconds += found.milliseconds;
    all.peak_mib = std::max(all.peak_mib, found.peak_mib);
  }
  all.worst = worst_of(all.models);
  return all;
}

}  // namespace plumb::tool

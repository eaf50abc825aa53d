#include "tool/clash/shard.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "plumb/certify/thread_limit.hpp"
#include "tool/clash/assembly.hpp"
#include "tool/clash/rules.hpp"

namespace plumb::tool {

nlohmann::json clashed_model(const std::string& file, const ClashArguments& options) {
  using nlohmann::json;
  const ThreadLimit limit(options.threads == 0 ? 1 : options.threads);
  LoadReport load;
  AssemblyParts parts = read_assembly(file, &load, options.meshes.reading());
  ClashReport report;
  std::vector<TriangleMesh> meshes;
  add_parts(file, parts, report, meshes);
  list_clashes(options, meshes, {.measure = false}, report);
  std::size_t triangles = 0;
  for (const AssemblyMember& part : report.parts) triangles += part.triangles;
  json words = json::array(), faults = json::object();
  for (std::size_t k = 0; k < clash_kinds; ++k) {
    if (report.counts[k] == 0) continue;
    const std::string word(name_of(static_cast<ClashKind>(k)));
    words.push_back(word);
    faults[word] = report.counts[k];
  }
  json line{{"verdict", !parts.unread.empty()    ? "unreadable"
                        : report.clashes.empty() ? "clear"
                                                 : "clashing"},
            {"parts", report.parts.size()},
            {"unread_parts", parts.unread.size()},
            {"triangles", triangles},
            {"pairs", report.asked},
            {"ignored", report.ignored},
            {"defects", std::move(words)},
            {"faults", std::move(faults)}};
  if (!parts.unread.empty()) line["why"] = parts.unread[0].name + ": " + parts.unread[0].why;
  return line;
}

int run_clash_shard(const ClashArguments& options) {
  require_none_with_shard({{"--json", options.json.has_value()},
                           {"--csv", options.csv.has_value()},
                           {"--bcf", options.bcf.has_value()},
                           {"--page", options.page.has_value()},
                           {"--overwrite", options.overwrite},
                           {"--all", options.all},
                           {"--fail-on-found", options.fail_on_found}});
  for (const std::string& text : options.rules) parse_clash_rule(text);  // what is wrong with them is told at once
  ShardWork work{"clash",
                 {{"clearance", nullptr}, {"rules", options.rules}, {"ignore", options.ignore}},
                 [&options](const std::string& file) { return clashed_model(file, options); }};
  if (options.clearance) work.settings["clearance"] = *options.clearance;
  return run_shard(options.meshes, options.shard, work);
}

}  // namespace plumb::tool

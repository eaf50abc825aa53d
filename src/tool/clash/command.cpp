#include "tool/clash/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/ray/parity.hpp"
#include "tool/clash/bcf.hpp"
#include "tool/clash/page.hpp"
#include "tool/clash/rules.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

/// bolt, bolt#2, bolt#3; a number that is part of another's name is passed over.
void number_names(std::vector<AssemblyMember>& parts) {
  std::map<std::string, std::size_t> used;
  for (const AssemblyMember& part : parts) used.try_emplace(part.name, 0);
  for (AssemblyMember& part : parts) {
    const std::string name = part.name;
    std::size_t& count = used[name];
    while (++count > 1) {
      part.name = fmt::format("{}#{}", name, count);
      if (!used.contains(part.name)) break;
    }
  }
}

double longest_edge_of_box(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  const Aabb3 box = fit_aabb(std::span<const Point3>(mesh.vertices));
  return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
}

/// What rules say of the pairs in reach: those that are asked, and of each what is ignored.
struct AskedByRules {
  std::vector<AskedPair> pairs;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<ClashKind>> ignored;
};

AskedByRules asked_by(const std::vector<ClashRule>& rules, const std::vector<std::string>& names,
                      std::span<const TriangleMesh> meshes, std::optional<double> clearance) {
  double reach = clearance.value_or(0);
  for (const ClashRule& rule : rules) reach = std::max(reach, rule.clearance.value_or(0));
  AskedByRules asked;
  for (AskedPair pair : pairs_in_reach(meshes, reach)) {
    ClashPolicy policy = policy_for(rules, names[pair.a], names[pair.b]);
    if (policy.skips) continue;
    pair.clearance = policy.clearance ? policy.clearance : clearance;
    if (!policy.ignored.empty()) asked.ignored[{pair.a, pair.b}] = std::move(policy.ignored);
    asked.pairs.push_back(pair);
  }
  return asked;
}

void list_clashes(const ClashArguments& options, const AskedByRules& asked, Clashes found, ClashReport& report) {
  std::vector<ClashKind> ignored;
  for (const std::string& word : options.ignore) ignored.push_back(clash_word(word));
  report.asked = found.asked;
  report.answered = found.answered;
  report.counts.assign(clash_kinds, 0);
  for (PartClash& pair : found.found) {
    const ClashKind kind = pair.clash.kind;
    const auto of_pair = asked.ignored.find({pair.a, pair.b});
    if (std::ranges::count(ignored, kind) != 0 ||
        (of_pair != asked.ignored.end() && std::ranges::count(of_pair->second, kind) != 0)) {
      ++report.ignored;
      continue;
    }
    ++report.counts[static_cast<std::size_t>(kind)];
    report.clashes.push_back(std::move(pair));
  }
}

}  // namespace

int run_clash(const ClashArguments& options) {
  if (options.meshes.words.empty()) throw Error("clash: no assembly is named; 'plumb clash --help' explains");
  std::vector<ClashRule> rules;
  for (const std::string& text : options.rules) rules.push_back(parse_clash_rule(text));
  const MeshInputs inputs = mesh_inputs(options.meshes);
  OutputFiles outputs(inputs.files);
  outputs.promise("--json", options.json);
  outputs.promise("--csv", options.csv);
  outputs.promise("--bcf", options.bcf);
  outputs.promise_unless_there("--page", options.page, options.overwrite);
  const ThreadLimit limit(options.threads);
  const bool says = !outputs.on_standard_output();
  if (says)
    for (const std::string& remark : inputs.remarks) say(remark);
  ClashReport report;
  report.passed_over = inputs.passed_over;
  report.clearance = options.clearance;
  std::vector<TriangleMesh> meshes;
  const bool all_good = each_assembly(
      inputs, options.meshes.reading(),
      [&](InputAssembly input) {
        outputs.require_not_read(input.load.files_beside);
        for (AssemblyPart& part : input.parts.parts) {
          const bool closed = !part.mesh.triangles.empty() && is_closed(part.mesh);
          report.parts.push_back({part.name, input.name, part.mesh.vertices.size(), part.mesh.triangles.size(), closed,
                                  longest_edge_of_box(part.mesh)});
          meshes.push_back(std::move(part.mesh));
        }
      },
      [&](UnreadMesh part) { report.unread.push_back(std::move(part)); });
  std::vector<std::string> names;
  for (const AssemblyMember& part : report.parts) names.push_back(part.name);
  number_names(report.parts);
  const AskedByRules asked = asked_by(rules, names, meshes, options.clearance);
  Clashes found;
  {
    constexpr std::uint64_t steps = 1000;
    Progress bar("clash", steps);
    ClashesOptions how{.measure = !options.unmeasured};
    if (bar.shown()) {
      how.progress = [&bar](double share) {
        bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
        return true;
      };
    }
    found = find_clashes(meshes, asked.pairs, how);
  }
  list_clashes(options, asked, std::move(found), report);
  if (says) say(clash_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(clash_json(report)));
  if (options.csv) outputs.write("--csv", clash_csv(report));
  if (options.bcf) outputs.write("--bcf", clash_bcf(report, origin_json("plumb clash").at("date").get<std::string>()));
  if (options.page) outputs.write("--page", clash_page(report, meshes));
  if (!is_any_named(options.meshes, report.unread)) outputs.keep();
  if (!all_good) return 2;
  return options.fail_on_found && !report.clashes.empty() ? 1 : 0;
}

}  // namespace plumb::tool

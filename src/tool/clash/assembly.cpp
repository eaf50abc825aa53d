#include "tool/clash/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/ray/parity.hpp"
#include "tool/clash/rules.hpp"

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

/// What is neither ignored by its word nor by a rule is listed.
void list_found(const ClashArguments& options, const AskedByRules& asked, Clashes found, ClashReport& report) {
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

void add_parts(const std::string& file, AssemblyParts& parts, ClashReport& to, std::vector<TriangleMesh>& meshes) {
  for (AssemblyPart& part : parts.parts) {
    const bool closed = !part.mesh.triangles.empty() && is_closed(part.mesh);
    to.parts.push_back({part.name, file, part.mesh.vertices.size(), part.mesh.triangles.size(), closed,
                        longest_edge_of_box(part.mesh)});
    meshes.push_back(std::move(part.mesh));
  }
}

void list_clashes(const ClashArguments& options, std::span<const TriangleMesh> meshes, const ClashesOptions& how,
                  ClashReport& report) {
  std::vector<ClashRule> rules;
  for (const std::string& text : options.rules) rules.push_back(parse_clash_rule(text));
  std::vector<std::string> names;
  for (const AssemblyMember& part : report.parts) names.push_back(part.name);
  number_names(report.parts);
  const AskedByRules asked = asked_by(rules, names, meshes, options.clearance);
  list_found(options, asked, find_clashes(meshes, asked.pairs, how), report);
}

}  // namespace plumb::tool

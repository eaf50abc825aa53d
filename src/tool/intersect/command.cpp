#include "tool/intersect/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "plumb/arith/error.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

constexpr std::size_t listed = 10;

void require_sound(const IntersectOptions& o) {
  if (o.meshes.words.empty() || o.meshes.words.size() > 2)
    throw Error("intersect: one mesh is needed, or two; 'plumb intersect --help' explains");
  const auto exclude = [](bool both, const char* a, const char* b, const char* why) {
    if (both) throw Error(fmt::format("intersect: {} and {} exclude each other: {}", a, b, why));
  };
  exclude(o.first && o.count, "--first", "--count", "the search ends at the first pair");
  exclude(o.count && o.all, "--count", "--all", "no pair is kept");
  exclude(o.count && o.common, "--count", "--common", "no pair is kept");
  exclude(o.count && o.obj.path, "--count", "--obj", "no pair is kept");
}

std::optional<TrianglePair> any_pair(const Bvh& a, const Bvh* b, const PairOptions& o) {
  return b != nullptr ? any_intersecting_pair(a, *b, o) : any_intersecting_pair(a, o);
}
PairCount count_pairs(const Bvh& a, const Bvh* b, const PairOptions& o) {
  return b != nullptr ? count_intersecting_pairs(a, *b, o) : count_intersecting_pairs(a, o);
}
std::vector<TrianglePair> all_pairs(const Bvh& a, const Bvh* b, const PairOptions& o) {
  return b != nullptr ? intersecting_pairs(a, *b, o) : intersecting_pairs(a, o);
}

}  // namespace

IntersectReport intersect_report(const IntersectOptions& options, std::vector<AskedMesh> meshes) {
  IntersectReport report;
  report.meshes = std::move(meshes);
  report.overlapping = options.overlapping;
  report.complete = !options.first;
  const Bvh a = build_bvh(report.meshes.front().mesh);
  const Bvh other = report.of_one() ? Bvh() : build_bvh(report.meshes.back().mesh);
  const Bvh* const b = report.of_one() ? nullptr : &other;
  constexpr std::uint64_t steps = 1000;
  Progress bar("intersect", steps);
  PairOptions asked{.touching = !options.overlapping};
  if (bar.shown()) {
    asked.progress = [&bar](double share) {
      bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
      return true;
    };
  }
  if (options.count) {
    report.found = count_pairs(a, b, asked);
    return report;
  }
  auto& pairs = report.pairs.emplace();
  if (!options.first) {
    pairs = all_pairs(a, b, asked);
  } else if (const auto pair = any_pair(a, b, {.touching = asked.touching})) {
    pairs.push_back(*pair);
  }
  for (const TrianglePair& p : pairs)
    ++(p.relation == Relation::touching ? report.found.touching : report.found.overlapping);
  if (options.common) {
    const std::size_t told = options.all || options.json ? pairs.size() : std::min(pairs.size(), listed);
    report.in_common = intersections(a, b != nullptr ? other : a, std::span(pairs).first(told));
  }
  return report;
}

int run_intersect(const IntersectOptions& options) {
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  require_sound(options);
  const IntersectReport report = intersect_report(options, read_asked_meshes(options.meshes, outputs));
  if (!outputs.on_standard_output())
    say(intersect_text(report, options.all ? std::numeric_limits<std::size_t>::max() : listed, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(intersect_json(report)));
  if (options.obj.path) outputs.write("--obj", intersect_obj(report));
  outputs.keep();
  return options.fail_on_found && report.many() != 0 ? 1 : 0;
}

}  // namespace plumb::tool

#include "tool/bounds/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tool/mesh/sample_part.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

MeshBounds rate(const std::string& name, std::span<const Point3> vertices, const BoundsOptions& options) {
  return {name, vertices.size(), rate_bounds(vertices, {.placements = options.placements, .measure_times = true}),
          options.refined_ns};
}

double median(std::vector<double> numbers) {
  if (numbers.empty()) return 0;
  std::ranges::sort(numbers);
  const std::size_t n = numbers.size();
  return n % 2 == 1 ? numbers[n / 2] : (numbers[n / 2 - 1] + numbers[n / 2]) / 2;
}

std::string header(std::string_view first, const Style& style) {
  return style.bold(
      fmt::format("  {:<10}{:>12}{:>16}{:>10}{:>12}\n", first, "tightness", "false overlaps", "test ns", "query ns"));
}

std::string row(BoundKind kind, const KindMedians& m, bool best, const Style& style) {
  const std::string line = fmt::format("  {:<10}{:>12.3g}{:>15.1f}%{:>10.1f}{:>12.1f}{}\n", name_of(kind), m.tightness,
                                       100 * m.false_share, m.test_ns, m.expected_ns, best ? "  <" : "");
  return best ? style.green(line) : line;
}

std::string table(std::span<const MeshBounds> meshes, const Style& style) {
  std::size_t best = 0;
  std::vector<KindMedians> rows;
  for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
    rows.push_back(medians(meshes, k));
    if (rows[k].expected_ns < rows[best].expected_ns) best = k;
  }
  std::string text = header("bound", style);
  for (std::size_t k = 0; k < rows.size(); ++k) text += row(bound_kinds[k], rows[k], k == best, style);
  return text;
}

nlohmann::json json_of(std::span<const MeshBounds> meshes, std::size_t k) {
  const KindMedians m = medians(meshes, k);
  return {{"kind", name_of(bound_kinds[k])},
          {"tightness", m.tightness},
          {"false_share", m.false_share},
          {"test_ns", m.test_ns},
          {"expected_ns", m.expected_ns}};
}

}  // namespace

double MeshBounds::false_share(std::size_t kind) const {
  const std::uint32_t apart = ratings.hulls_apart();
  return apart == 0 ? 0 : static_cast<double>(ratings.kinds[kind].false_overlaps) / apart;
}

double MeshBounds::expected_ns(std::size_t kind) const {
  const BoundRating& r = ratings.kinds[kind];
  const auto placements = static_cast<double>(ratings.placements.size());
  return r.test_ns + (placements == 0 ? 0 : r.overlapping / placements * refined_ns);
}

KindMedians medians(std::span<const MeshBounds> meshes, std::size_t kind) {
  const auto of = [&](const auto& number) {
    std::vector<double> numbers;
    for (const MeshBounds& m : meshes) numbers.push_back(number(m));
    return median(std::move(numbers));
  };
  return {of([&](const MeshBounds& m) { return m.ratings.kinds[kind].tightness; }),
          of([&](const MeshBounds& m) { return m.false_share(kind); }),
          of([&](const MeshBounds& m) { return m.ratings.kinds[kind].test_ns; }),
          of([&](const MeshBounds& m) { return m.expected_ns(kind); })};
}

std::string bounds_text(const MeshBounds& mesh, const Style& style) {
  const std::string about = fmt::format(
      "  {} vertices, {} on the hull, which fills {:.0f}% of the axis-aligned box; hulls apart in {} of {} "
      "placements\n",
      mesh.vertices, mesh.ratings.lattice.size(), 100 * mesh.ratings.hull_share, mesh.ratings.hulls_apart(),
      mesh.ratings.placements.size());
  return style.bold(printable(mesh.name)) + "\n" + about + table({&mesh, 1}, style);
}

std::string bounds_total(std::span<const MeshBounds> meshes, const Style& style) {
  return style.bold(fmt::format("medians over {} meshes\n", meshes.size())) + table(meshes, style);
}

nlohmann::json bounds_json(std::span<const MeshBounds> meshes) {
  nlohmann::json all = origin_json("plumb bounds");
  all["meshes"] = all["medians"] = nlohmann::json::array();
  for (const MeshBounds& m : meshes) {
    nlohmann::json j{{"mesh", m.name},
                     {"vertices", m.vertices},
                     {"hull_vertices", m.ratings.lattice.size()},
                     {"hull_share", m.ratings.hull_share},
                     {"placements", m.ratings.placements.size()},
                     {"hulls_apart", m.ratings.hulls_apart()},
                     {"refined_ns", m.refined_ns},
                     {"kinds", nlohmann::json::array()}};
    for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
      nlohmann::json kind = json_of({&m, 1}, k);
      kind["overlapping"] = m.ratings.kinds[k].overlapping;
      kind["false_overlaps"] = m.ratings.kinds[k].false_overlaps;
      j["kinds"].push_back(std::move(kind));
    }
    all["meshes"].push_back(std::move(j));
  }
  for (std::size_t k = 0; k < bound_kinds.size() && !meshes.empty(); ++k) all["medians"].push_back(json_of(meshes, k));
  return all;
}

int run_bounds(const BoundsOptions& options) {
  const MeshInputs inputs = mesh_inputs(options.meshes);
  OutputFiles outputs(inputs.files);
  outputs.promise("--json", options.json);
  outputs.promise("--chart", options.chart);
  const Style style(stdout);
  const bool text_wanted = !outputs.on_standard_output();  // standard output is for one of them alone
  if (text_wanted)
    for (const std::string& remark : inputs.remarks) say(remark);
  std::optional<Progress> progress;  // where text is wanted, that tells how far the work is
  if (!text_wanted) progress.emplace("bounds", inputs.files.size());
  std::vector<MeshBounds> all;
  const auto add = [&](const std::string& name, std::span<const Point3> vertices) {
    MeshBounds mesh = rate(name, vertices, options);
    if (text_wanted) {
      if (!all.empty()) say("\n");
      say(bounds_text(mesh, style));
      flush_output();
    }
    all.push_back(std::move(mesh));
    if (progress) progress->advance();
  };
  if (options.meshes.words.empty()) add("embedded flange", sample_part().vertices);
  const bool all_good = each_mesh(inputs, options.meshes.reading(), [&](const InputMesh& input) {
    outputs.require_not_read(input.load.files_beside);
    add(input.name, input.mesh.vertices);
  });
  if (text_wanted && all.size() > 1) {
    say("\n");
    say(bounds_total(all, style));
  }
  if (options.json) {
    nlohmann::json report = bounds_json(all);
    report["passed_over"] = inputs.passed_over;
    // A file's name may be any bytes; JSON is UTF-8.
    outputs.write("--json", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
  if (options.chart) outputs.write("--chart", bounds_chart(all));
  if (!all_good) return 2;
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool

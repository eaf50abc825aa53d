#include "tool/bvh/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/tree_file.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

constexpr double item_cost = BvhOptions().item_cost;
constexpr std::size_t most_for_pairs = 20'000;  // triangles that `all` hands to the quadratic builder

BuiltTree built_by(const BvhOptions& options, const TriangleMesh& mesh) {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  BuiltTree built{options.method, {}, {}, 0, 0, std::numeric_limits<double>::infinity()};
  double all = 0;
  for (int i = 0; i < 3 && all < 1000; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Bvh bvh = build_bvh(mesh, options);
    const double took = Milliseconds(std::chrono::steady_clock::now() - start).count();
    all += took;
    built.build_ms = std::min(built.build_ms, took);
    if (i != 0) continue;
    built.cost = cost_of(bvh.tree);
    built.levels = levels_of(bvh.tree);
    built.bytes = memory_of(bvh);
    built.slots = bvh.slots();
  }
  return built;
}

double bytes_per_triangle(const BvhReport& r, const BuiltTree& t) {
  return static_cast<double>(t.bytes) / static_cast<double>(std::max<std::size_t>(r.mesh.mesh.triangles.size(), 1));
}

BvhMethod method_of(const std::string& word) { return *std::ranges::find(bvh_methods, word, word_of); }

}  // namespace

std::string word_of(BvhMethod method) {
  std::string word(name_of(method));
  std::ranges::replace(word, ' ', '-');
  return word;
}

BvhReport bvh_report(const BvhArguments& arguments, AskedMesh mesh) {
  BvhReport report{std::move(mesh), arguments.split_share, {}, {}};
  for (const BvhMethod method : bvh_methods) {
    if (!arguments.all() && method_of(arguments.method) != method) continue;
    const TriangleMesh& triangles = report.mesh.mesh;
    if (arguments.all() && method == BvhMethod::nearest_pairs && triangles.triangles.size() > most_for_pairs) {
      report.left_out.push_back(method);
    } else {
      report.trees.push_back(built_by({.method = method, .split_share = arguments.split_share}, triangles));
    }
  }
  return report;
}

std::string bvh_text(const BvhReport& r, const Style& style) {
  std::string text = mesh_line(r.mesh, style) + "\n";
  text += style.dim(fmt::format("{:<15}{:>10}{:>10}{:>7}{:>9}{:>10}{:>9}\n", "method", "nodes", "leaves", "depth",
                                "cost", "bytes", "ms"));
  for (const BuiltTree& t : r.trees) {
    text += fmt::format("{:<15}{:>10}{:>10}{:>7}{:>9.2f}{:>10.1f}{:>9}\n", word_of(t.method), grouped(t.cost.nodes),
                        grouped(t.cost.leaves), t.cost.depth, t.cost.total(1, item_cost), bytes_per_triangle(r, t),
                        three_digits(t.build_ms));
  }
  if (r.split_share > 0) {
    for (const BuiltTree& t : r.trees) {
      text += fmt::format("{}: {} parts of {}\n", word_of(t.method), grouped(t.slots),
                          plural(r.mesh.mesh.triangles.size(), "triangle", "triangles"));
    }
  }
  for (const BvhMethod method : r.left_out)
    text +=
        fmt::format("{0} is quadratic and left out of so many triangles; --method {0} builds it\n", word_of(method));
  return text + style.dim(
                    "cost: nodes that a line through the box meets on the average, and half the triangles in "
                    "their leaves;\nbytes a triangle, vertices included\n");
}

nlohmann::json bvh_json(const BvhReport& r) {
  using nlohmann::json;
  json said = report_on("plumb bvh", {&r.mesh, 1});
  said["split_share"] = r.split_share;
  json& trees = said["trees"] = json::array();
  for (const BuiltTree& t : r.trees) {
    json levels = json::array();
    for (const TreeLevel& l : t.levels)
      levels.push_back(
          {{"nodes", l.nodes}, {"leaves", l.leaves}, {"nodes_met", l.nodes_met}, {"triangles_met", l.items_met}});
    trees.push_back({{"method", word_of(t.method)},
                     {"slots", t.slots},
                     {"nodes", t.cost.nodes},
                     {"leaves", t.cost.leaves},
                     {"depth", t.cost.depth},
                     {"mean_depth", t.cost.mean_depth},
                     {"most_in_leaf", t.cost.most_in_leaf},
                     {"nodes_met", t.cost.nodes_met},
                     {"triangles_met", t.cost.items_met},
                     {"cost", t.cost.total(1, item_cost)},
                     {"bytes", t.bytes},
                     {"bytes_per_triangle", bytes_per_triangle(r, t)},
                     {"build_ms", t.build_ms},
                     {"levels", std::move(levels)}});
  }
  json& left_out = said["left_out"] = json::array();
  for (const BvhMethod method : r.left_out) left_out.push_back(word_of(method));
  return said;
}

int run_bvh(const BvhArguments& arguments) {
  OutputFiles outputs(arguments.meshes.words);
  outputs.promise("--json", arguments.json);
  outputs.promise_unless_there("--svg", arguments.svg, arguments.overwrite);
  outputs.promise_unless_there("--out", arguments.out, arguments.overwrite);
  if (arguments.meshes.words.size() != 1) throw Error("bvh: one MESH is needed; 'plumb bvh --help' explains");
  if (arguments.all() && arguments.svg) throw Error("bvh: --svg draws one tree; name one --method");
  if (arguments.all() && arguments.out) throw Error("bvh: --out keeps one tree; name one --method");
  const BvhReport report = bvh_report(arguments, std::move(read_asked_meshes(arguments.meshes, outputs).front()));
  if (!outputs.on_standard_output()) say(bvh_text(report, Style(stdout)));
  if (arguments.json) outputs.write("--json", json_text(bvh_json(report)));
  if (arguments.svg || arguments.out) {
    const BvhMethod method = method_of(arguments.method);
    const Bvh bvh = build_bvh(report.mesh.mesh, {.method = method, .split_share = arguments.split_share});
    if (arguments.svg) outputs.write("--svg", tree_svg(report.mesh.name, bvh.tree, method));
    if (arguments.out) outputs.write("--out", bvh_bytes(bvh));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool

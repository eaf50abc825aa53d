#include "tool/bsp/command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "plumb/arith/error.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

BspCommandReport built_bsp(const BspArguments& arguments, AskedMesh mesh) {
  BspCommandReport report{std::move(mesh), arguments.leaves, arguments.planes, arguments.options, {}, 0};
  BspOptions& options = report.options;
  options.kind = arguments.leaves == "solid"    ? BspKind::solid_leaf
                 : arguments.leaves == "pieces" ? BspKind::leaf_storing
                                                : BspKind::node_storing;
  options.planes = arguments.planes == "faces" ? BspPlanes::faces : BspPlanes::faces_and_axes;
  const auto start = std::chrono::steady_clock::now();
  try {
    report.tree = build_bsp(report.mesh.mesh, options).report;
  } catch (const InvalidShape& e) {
    throw Error(fmt::format("{}: {}; 'plumb repair' mends meshes, '--leaves pieces' takes any", report.mesh.name,
                            std::string(e.what())));
  }
  report.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace

std::string bsp_text(const BspCommandReport& report, const Style& style) {
  const BspReport& t = report.tree;
  std::string text = mesh_line(report.mesh, style) + "\n";
  text += style.bold(fmt::format("{}, {} of them across axes; {} deep", plural(t.nodes, "plane", "planes"),
                                 grouped(t.axis_nodes), grouped(t.depth))) +
          "\n";
  text += plural(t.leaves, "leaf", "leaves");
  if (report.options.kind == BspKind::solid_leaf) text += fmt::format(", {} of them solid", grouped(t.solid_leaves));
  text += fmt::format("; {} of faces, after {}\n", plural(t.pieces, "piece", "pieces"),
                      plural(t.splits, "split", "splits"));
  text += fmt::format("longest chain of planes with a leaf beside each: {}\n", grouped(t.longest_chain));
  if (t.faces_left_out != 0) text += plural(t.faces_left_out, "face", "faces") + " without area left out\n";
  if (t.leaves_by_rationals != 0)
    text += plural(t.leaves_by_rationals, "leaf is", "leaves are") + " too thin for a double\n";
  text += fmt::format("{} bytes\n", grouped(t.bytes));
  return text;
}

nlohmann::json bsp_json(const BspCommandReport& report) {
  const BspReport& t = report.tree;
  nlohmann::json said = report_on("plumb bsp", {&report.mesh, 1});
  said.update({{"leaves_tell", report.leaves},
               {"planes_of", report.planes},
               {"split_weight", report.options.split_weight},
               {"candidates", report.options.candidates},
               {"leaf_size", report.options.leaf_size},
               {"nodes", t.nodes},
               {"axis_nodes", t.axis_nodes},
               {"leaves", t.leaves},
               {"solid_leaves", t.solid_leaves},
               {"deepest", t.depth},
               {"longest_chain", t.longest_chain},
               {"pieces_of_faces", t.pieces},
               {"splits", t.splits},
               {"faces_left_out", t.faces_left_out},
               {"leaves_by_rationals", t.leaves_by_rationals},
               {"bytes", t.bytes},
               {"build_ms", report.build_ms}});
  return said;
}

int run_bsp(const BspArguments& arguments) {
  OutputFiles outputs(arguments.meshes.words);
  outputs.promise("--json", arguments.json);
  if (arguments.meshes.words.size() != 1) throw Error("bsp: one MESH is needed; 'plumb bsp --help' explains");
  const BspCommandReport report = built_bsp(arguments, std::move(read_asked_meshes(arguments.meshes, outputs).front()));
  if (!outputs.on_standard_output()) say(bsp_text(report, Style(stdout)));
  if (arguments.json) outputs.write("--json", json_text(bsp_json(report)));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool

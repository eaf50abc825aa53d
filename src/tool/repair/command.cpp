#include "tool/repair/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "plumb/surface/planar/planarity.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/mesh/writing_to.hpp"
#include "tool/repair/shard.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::array in_order{RepairKind::weld,
                              RepairKind::degenerate,
                              RepairKind::slivers,
                              RepairKind::t_junctions,
                              RepairKind::zip,
                              RepairKind::duplicates,
                              RepairKind::walls,
                              RepairKind::small_components,
                              RepairKind::orientation,
                              RepairKind::holes,
                              RepairKind::outward,
                              RepairKind::split,
                              RepairKind::merge_coplanar,
                              RepairKind::unused};
static_assert(in_order.size() == repair_kinds);

bool is_asked(const RepairSettings& settings, RepairKind kind) {
  if (!settings.only.empty()) return std::ranges::count(settings.only, name_of(kind)) != 0;
  if (kind == RepairKind::zip) return settings.tolerance != 0;
  if (kind == RepairKind::small_components) return settings.size != 0;
  return kind != RepairKind::slivers && kind != RepairKind::merge_coplanar;
}

/// The name of the file that a mesh becomes in a folder: its own, but for formats that are not written.
std::string name_in_folder(const std::string& input) {
  fs::path name = input == "-" ? fs::path("mesh.obj") : fs::path(input).filename();
  if (name.extension() == ".gz") name.replace_extension();
  const auto format = format_by_extension(name.string());
  if (!format || *format == MeshFormat::three_mf || *format == MeshFormat::gltf) name.replace_extension(".obj");
  return name.string();
}

/// Where each input's mesh goes.
struct Destinations {
  std::vector<std::string> paths;  // one an input; none where nothing is written
  std::vector<fs::path> folders;   // to be made

  Destinations(const RepairSettings& settings, const MeshInputs& inputs) {
    if (!settings.output) return;
    const std::string& out = *settings.output;
    std::error_code error;
    const bool one =
        inputs.files.size() == 1 && settings.meshes.words.size() == 1 && inputs.files[0] == settings.meshes.words[0];
    if (out == "-" && !one) throw Error("--output -: standard output takes one mesh; name a folder for several");
    if (one && !out.ends_with('/') && !fs::is_directory(out, error)) {
      paths.push_back(out);
      return;
    }
    if (!fs::exists(out, error)) folders.emplace_back(out);
    for (const std::string& file : inputs.files) paths.push_back((fs::path(out) / name_in_folder(file)).string());
  }
};

std::string option_of(const Destinations& to, std::size_t i) {
  return to.paths.size() == 1 ? "--output" : "--output " + to.paths[i];
}

/// Texts that are kept in a folder that is not there yet.
struct LaterFile {
  std::string path, text;
};

void promise_meshes(const RepairSettings& settings, const Destinations& to, OutputFiles& outputs) {
  for (std::size_t i = 0; i < to.paths.size(); ++i) {
    format_mesh(PolygonMesh{}, to.paths[i],
                writing_to(to.paths[i]));  // a format that cannot be written is refused before anything is read
    if (std::find(to.paths.begin(), to.paths.begin() + static_cast<std::ptrdiff_t>(i), to.paths[i]) !=
        to.paths.begin() + static_cast<std::ptrdiff_t>(i))
      throw Error(fmt::format("two meshes would become {}; mend them one by one", printable(to.paths[i])));
    if (!to.folders.empty()) continue;
    outputs.promise_mesh(option_of(to, i), to.paths[i],
                         settings.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                         "give another name, or --overwrite to replace it");
  }
  for (const fs::path& folder : to.folders) {
    try {
      probe_folder(folder);
    } catch (const std::system_error& e) {
      throw Error(fmt::format("cannot write {}: {}", printable(folder.string()), e.code().message()));
    }
  }
}

Repaired mended(const std::string& name, const TriangleMesh& mesh, const std::vector<RepairStep>& steps) {
  Progress bar(name, steps.size() + 1);
  RepairOptions options;
  if (bar.shown()) {
    options.progress = [&bar](double) {
      bar.advance();
      return true;
    };
  }
  return repair(mesh, steps, options);
}

}  // namespace

std::vector<std::string> step_names() {
  std::vector<std::string> names;
  for (const RepairKind kind : in_order) names.emplace_back(name_of(kind));
  return names;
}

std::vector<RepairStep> steps_of(const RepairSettings& settings) {
  if (!std::isfinite(settings.tolerance)) throw Error("--tolerance: it is not a real number; give a finite length");
  std::vector<RepairStep> steps;
  for (const RepairKind kind : in_order) {
    if (!is_asked(settings, kind)) continue;
    if (settings.tolerance == 0 && !settings.only.empty() && (kind == RepairKind::slivers || kind == RepairKind::zip))
      throw Error(fmt::format("--only {} needs a length; give it by '--tolerance LENGTH'", name_of(kind)));
    if (settings.size == 0 && kind == RepairKind::small_components)
      throw Error("--only small-components needs a number; give it by '--smallest N'");
    steps.push_back({kind, settings.tolerance, settings.size, settings.chains ? WeldRule::chains : WeldRule::clusters,
                     settings.keep_turned ? TurnedOver::kept : TurnedOver::refused});
    if (kind == RepairKind::t_junctions && is_asked(settings, RepairKind::zip))
      steps.back().tolerance = 0;  // what is open is left to zip, and what is then near an edge comes behind it
    if (kind == RepairKind::zip && is_asked(settings, RepairKind::t_junctions))
      steps.push_back({RepairKind::t_junctions, settings.tolerance});
    if (kind == RepairKind::holes && is_asked(settings, RepairKind::walls))
      steps.push_back({RepairKind::walls});  // what is within a solid whose holes are filled
  }
  return steps;
}

std::optional<std::string> why_not_planar(const InputMesh& input, const std::optional<double>& length) {
  if (!length) return {};
  const std::vector<BentFace> bent = plumb::bent_faces(input.mesh, *length);
  if (bent.empty()) return {};
  const std::string more = bent.size() == 1 ? "" : fmt::format(", as are {} more", bent.size() - 1);
  return fmt::format(
      "{}: polygon {}, counted from 0, is {} thick, which is more than '--planar {}' allows{}; allow more, or "
      "leave the option out to have such polygons triangulated",
      printable(input.name), bent[0].face, bent[0].width.width, *length, more);
}

int run_repair(const RepairSettings& settings) {
  if (settings.shard.asked()) return run_repair_shard(settings);
  if (settings.meshes.words.empty()) throw Error("repair: no mesh is named; 'plumb repair --help' explains");
  if (!settings.output && !settings.dry_run)
    throw Error(
        "repair: where the mended mesh goes is not said; add '-o FILE', or --dry-run to see what would be changed");
  if (settings.planar && !std::isfinite(*settings.planar))
    throw Error("--planar: it is not a real number; give a finite length");
  if (settings.output && settings.dry_run) throw Error("--output and --dry-run exclude one another; leave one out");
  const std::vector<RepairStep> steps = steps_of(settings);
  const MeshInputs inputs = mesh_inputs(settings.meshes);
  OutputFiles outputs(inputs.files);
  const Destinations to(settings, inputs);
  promise_meshes(settings, to, outputs);
  outputs.promise("--json", settings.json);
  outputs.promise_unless_there("--page", settings.page, settings.overwrite);
  const ThreadLimit limit(settings.threads);
  const bool says = !outputs.on_standard_output();
  const Style style(stdout);
  nlohmann::json report = origin_json("plumb repair");
  report["meshes"] = nlohmann::json::array();
  report["passed_over"] = inputs.passed_over;
  report["not_read"] = nlohmann::json::array();
  if (says)
    for (const std::string& remark : inputs.remarks) say(remark);
  RepairPage page;
  std::vector<LaterFile> later;
  later.reserve(to.paths.size());
  bool any_left = false;
  std::vector<UnreadMesh> refused;
  const auto refuse = [&](UnreadMesh m) {
    report["not_read"].push_back({{"mesh", m.name}, {"error", m.why}});
    refused.push_back(std::move(m));
  };
  const bool all_read = each_mesh(
      inputs, settings.meshes.reading(),
      [&](InputMesh input) {
        outputs.require_not_read(input.load.files_beside);
        if (const auto why = why_not_planar(input, settings.planar)) {
          complain(*why);
          refuse({input.name, *why});
          return;
        }
        const TriangleMesh mesh = triangulate(input.mesh, &input.load.fans);
        MendedMesh m{input.name, input.load, mesh.vertices.size(), mesh.triangles.size(), find_faults(mesh), {}, {}};
        m.done = mended(m.name, mesh, steps);
        any_left = any_left || m.done.faults.any();
        const auto is_this = [&](const std::string& file) { return name_of_input(file) == input.name; };
        const auto i = static_cast<std::size_t>(std::ranges::find_if(inputs.files, is_this) - inputs.files.begin());
        if (!to.paths.empty()) {
          m.written = to.paths[i];
          std::string text = format_mesh(to_polygons(m.done.mesh), to.paths[i], writing_to(to.paths[i]));
          if (to.folders.empty()) {
            outputs.write(option_of(to, i), std::move(text));
          } else {
            later.push_back({to.paths[i], std::move(text)});
          }
        }
        if (says) say(repair_text(m, style)), flush_output();
        report["meshes"].push_back(repair_json(m));
        if (settings.page) page.add(mesh, m);
      },
      refuse);
  if (outputs.wants("--json")) outputs.write("--json", json_text(report));
  if (settings.page) outputs.write("--page", page.text());
  if (is_any_named(settings.meshes, refused)) return 2;
  std::vector<PathAndText> files = outputs.keep_streams();
  for (const LaterFile& file : later) files.push_back({file.path, file.text, surface::Replacing::no});
  keep_files(files, to.folders);
  if (!all_read || !refused.empty()) return 2;
  return settings.fail_on_left && any_left ? 1 : 0;
}

}  // namespace plumb::tool

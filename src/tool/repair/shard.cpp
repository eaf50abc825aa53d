#include "tool/repair/shard.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/whole_file.hpp"
#include "surface/topology/fault_words.hpp"
#include "tool/mesh/writing_to.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Its own path; behind a format that is not written, or is packed, stands another.
fs::path place_of_mended(const std::string& file, const RepairSettings& settings) {
  const fs::path below = fs::path(file).lexically_relative(settings.meshes.words[0]);
  const auto format = format_by_extension(below.string());
  const bool is_written = format && *format != MeshFormat::three_mf && *format != MeshFormat::gltf;
  fs::path place = fs::path(*settings.shard.folder) / "mended" / below;
  if (!is_written) place += ".obj";
  return place;
}

bool holds_already(const fs::path& place, const std::string& bytes) {
  std::ifstream in(place, std::ios::binary);
  return in && std::string(std::istreambuf_iterator<char>(in), {}) == bytes;
}

/// Why it is not there.
std::string not_written(const fs::path& place, const std::string& bytes) {
  if (holds_already(place, bytes)) return "";
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  try {
    surface::StagedFile staged(place, bytes, surface::Replacing::no);
    staged.keep();
  } catch (const std::system_error& e) {
    return place.string() + " is not written: " + e.code().message();
  }
  return "";
}

bool lies_within_corpus(const fs::path& inner, const fs::path& outer) {
  std::error_code error;
  const fs::path from = fs::weakly_canonical(outer, error), to = fs::weakly_canonical(inner, error);
  const fs::path way = to.lexically_relative(from);
  return !way.empty() && *way.begin() != "..";
}

}  // namespace

json mended_model(const std::string& file, const RepairSettings& settings) {
  const ThreadLimit limit(settings.threads == 0 ? 1 : settings.threads);
  InputMesh input{file, {}, {}};
  input.mesh = read_input(file, &input.load, settings.meshes.reading());
  if (const auto why = why_not_planar(input, settings.planar)) return {{"verdict", "refused"}, {"why", *why}};
  const TriangleMesh mesh = triangulate(input.mesh, &input.load.fans);
  const SurfaceFaults before = find_faults(mesh);
  const Repaired done = repair(mesh, steps_of(settings), {});
  json left = json::array(), defects = json::array(), faults = json::object(), changes = json::object();
  for (const std::string_view defect : surface_defects) {
    if (before.has(defect)) defects.push_back(defect);
    if (done.faults.has(defect)) left.push_back(defect);
  }
  json line{{"verdict", !left.empty()                             ? "left"
                        : defects.empty() && done.changes.empty() ? "sound"
                                                                  : "mended"},
            {"vertices", mesh.vertices.size()},
            {"triangles", mesh.triangles.size()},
            {"mended_triangles", done.mesh.triangles.size()},
            {"changes", done.changes.size()},
            {"defects_before", std::move(defects)},
            {"defects", std::move(left)}};
  if (settings.dry_run) return line;
  const fs::path place = place_of_mended(file, settings);
  const std::string why =
      not_written(place, format_mesh(to_polygons(done.mesh), place.string(), writing_to(place.string())));
  if (!why.empty()) return {{"verdict", "refused"}, {"why", why}};
  return line;
}

int run_repair_shard(const RepairSettings& settings) {
  require_none_with_shard({{"--json", settings.json.has_value()},
                           {"--page", settings.page.has_value()},
                           {"--output", settings.output.has_value()},
                           {"--overwrite", settings.overwrite},
                           {"--fail-on-left", settings.fail_on_left}});
  if (settings.meshes.words.size() == 1 && lies_within_corpus(*settings.shard.folder, settings.meshes.words[0]))
    throw Error("--out: it lies in the folder of models, and what is mended would be one of them; name another");
  ShardWork work{"repair",
                 {{"only", settings.only},
                  {"tolerance", settings.tolerance},
                  {"planar", nullptr},
                  {"smallest", settings.size},
                  {"chains", settings.chains},
                  {"keep_turned", settings.keep_turned},
                  {"dry_run", settings.dry_run}},
                 [&settings](const std::string& file) { return mended_model(file, settings); }};
  if (settings.planar) work.settings["planar"] = *settings.planar;
  steps_of(settings);  // what is wrong with them is told at once
  return run_shard(settings.meshes, settings.shard, work);
}

}  // namespace plumb::tool

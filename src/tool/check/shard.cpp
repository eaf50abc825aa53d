#include "tool/check/shard.hpp"

#include <nlohmann/json.hpp>

#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "surface/topology/fault_words.hpp"
#include "tool/check/mesh.hpp"
#include "tool/mesh/bent_faces.hpp"

namespace plumb::tool {

nlohmann::json checked_model(const std::string& file, const CheckOptions& options) {
  using nlohmann::json;
  const ThreadLimit limit(options.threads == 0 ? 1 : options.threads);
  LoadReport load;
  const PolygonMesh read = read_input(file, &load, options.meshes.reading());
  MeshCheck check;
  check.bent_faces = bent_faces(read);
  CheckSettings settings;
  settings.nearer_than = options.nearer_than;
  settings.decisions = false;
  check_mesh(triangulate(read, &load.fans), settings, check);
  json defects = json::array(), faults = json::object();
  for (const std::string_view defect : surface_defects)
    if (check.surface.has(defect)) defects.push_back(defect);
  for (const surface::CountedFault& fault : surface::counted_faults(check.surface, check.statistics))
    if (fault.count != 0) faults[fault.many] = fault.count;
  if (check.bent_faces != 0) faults["polygons whose corners lie in no one plane"] = check.bent_faces;
  return {{"verdict", defects.empty() ? "sound" : "faulty"},
          {"vertices", check.statistics.vertices},
          {"triangles", check.statistics.faces},
          {"shells", check.surface.shells.size()},
          {"bytes", load.bytes},
          {"defects", std::move(defects)},
          {"faults", std::move(faults)}};
}

int run_check_shard(const CheckOptions& options) {
  require_none_with_shard({{"--json", options.json.has_value()},
                           {"--chart", options.chart.has_value()},
                           {"--write-sample", options.write_sample.has_value()},
                           {"--verify", options.verify},
                           {"--all", options.all},
                           {"--brief", options.brief},
                           {"--fail-on-wrong", !options.fail_on_wrong.empty()},
                           {"--fail-on-defect", !options.fail_on_defect.empty()}});
  ShardWork work{"check", {{"nearer_than", nullptr}}, [&options](const std::string& file) {
                   return checked_model(file, options);
                 }};
  if (options.nearer_than) work.settings["nearer_than"] = *options.nearer_than;
  return run_shard(options.meshes, options.shard, work);
}

}  // namespace plumb::tool

#include "tool/plan/command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/surface/read_mesh.hpp"
#include "tool/mesh/sample_part.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {

int run_plan(const PlanOptions& options) {
  OutputFiles outputs(options.meshes);
  outputs.promise("--json", options.json);
  outputs.promise("--chart", options.chart);
  std::vector<NamedMesh> meshes;
  for (const std::string& path : options.meshes) {
    meshes.push_back({path, read_mesh(path)});
    if (meshes.back().mesh.vertices.empty()) throw Error(path + ": the mesh has no vertices");
  }
  if (meshes.empty()) meshes.push_back({"embedded flange", sample_part()});
  ScenePlan scene;
  {
    Progress progress("plan", steps_of(meshes));
    scene = plan_scene(meshes, options, [&] { progress.advance(); });
  }
  if (!outputs.on_standard_output()) say(plan_text(scene, options.all, Style(stdout)));
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    const std::string text = plan_json(scene).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    outputs.write("--json", text + "\n");
  }
  if (options.chart) outputs.write("--chart", plan_chart(scene));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool

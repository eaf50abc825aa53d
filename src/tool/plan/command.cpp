#include "tool/plan/command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/surface/planar/triangulate.hpp"
#include "tool/mesh/sample_part.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {

int run_plan(const PlanOptions& options) {
  const MeshInputs inputs = mesh_inputs(options.meshes);
  OutputFiles outputs(inputs.files);
  outputs.promise("--json", options.json);
  outputs.promise("--chart", options.chart);
  if (!inputs.faults.empty()) throw inputs.faults.front();
  std::vector<NamedMesh> meshes;
  for (const std::string& file : inputs.files) {
    LoadReport load;
    meshes.push_back({name_of_input(file), triangulate(read_input(file, &load, options.meshes.reading()))});
    outputs.require_not_read(load.files_beside);
  }
  if (meshes.empty()) meshes.push_back({"embedded flange", sample_part()});
  ScenePlan scene;
  {
    Progress progress("plan", steps_of(meshes));
    scene = plan_scene(meshes, options, [&] { progress.advance(); });
  }
  if (!outputs.on_standard_output()) {
    for (const std::string& remark : inputs.remarks) say(remark);
    say(plan_text(scene, options.all, Style(stdout)));
  }
  if (options.json) {
    nlohmann::json report = plan_json(scene);
    report["passed_over"] = inputs.passed_over;
    // A file's name may be any bytes; JSON is UTF-8.
    outputs.write("--json", report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
  if (options.chart) outputs.write("--chart", plan_chart(scene));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool

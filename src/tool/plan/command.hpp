// `plumb plan`: what do these meshes need, as one scene and each alone, and no more?
//
// Laws: text and JSON hold the same numbers, and the chart those of lattices and bounding volumes.  Exit code 0 when
// done; a mesh that cannot be read or an output that cannot be written throws Error: a scene without one of its meshes is
// another scene.
// Source: scene_plan.hpp.
// Cost: that of plan_scene.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tool/mesh/inputs.hpp"
#include "tool/plan/scene_plan.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct PlanOptions : ScenePlanOptions {
  MeshArguments meshes;                    // none: the embedded part
  std::optional<std::string> json, chart;  // "-" is standard output
  bool all = false;                        // list every predicate of the manifest
};

int run_plan(const PlanOptions& options);

std::string plan_text(const ScenePlan& scene, bool all, const Style& style);

/// Lists at most so many of the points that merge, and of the triangles that collapse or turn over, for each lattice.
inline constexpr std::size_t most_listed = 100;
nlohmann::json plan_json(const ScenePlan& scene);

/// A row a lattice: what a decision costs by decide and by the plan for each classic, and what snapping to it does;
/// below, what a query costs behind each bounding volume.
std::string plan_chart(const ScenePlan& scene);

}  // namespace plumb::tool

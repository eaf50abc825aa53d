// `plumb distance`: how far are these two meshes apart, and between which of their triangles?
//
// Laws: text, JSON and OBJ name the same two triangles.  Exit code 0 when done, also where the meshes meet; a mesh that
// cannot be read, an output that cannot be written throw Error.
// Source: plumb/space/closest/closest_triangles.hpp.
// Cost: that of the trees; where the meshes meet, that of all pairs that may or are equally near.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/space/closest/closest_triangles.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct DistanceOptions {
  MeshArguments meshes;             // two files
  std::optional<std::string> json;  // "-" is standard output
  ObjOutput obj;                    // the two triangles
};

int run_distance(const DistanceOptions& options);

struct DistanceReport {
  std::vector<AskedMesh> meshes;            // a, b
  std::optional<ClosestTriangles> nearest;  // nothing where a mesh has no triangles
  bool meet = false;                        // which a distance that rounds to 0 does not say
};

std::string distance_text(const DistanceReport& report, const Style& style);
nlohmann::json distance_json(const DistanceReport& report);

}  // namespace plumb::tool

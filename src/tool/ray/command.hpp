// `plumb ray`: which triangles of this mesh do these rays hit, in exact order?
//
// Laws: text and JSON hold the same hits, of --ray, --segment, --rays, then --segments, each in their order; OBJ the
// triangles that text names.  Exit code 0 when done, also where nothing is hit; a mesh or words that cannot be read, an output that cannot be written throw Error.
// Source: plumb/space/ray/mesh_ray.hpp.
// Cost: that of the tree, and of all hits of each ray.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/space/ray/mesh_ray.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct RayOptions {
  MeshArguments meshes;                               // one file
  std::vector<std::string> rays, segments;            // six numbers each
  std::optional<std::string> ray_file, segment_file;  // of more; "-" is standard input
  std::optional<std::string> tree;                    // of the mesh, kept from before
  bool all = false;                                   // say every hit, not the first alone
  std::optional<std::string> json;                    // "-" is standard output
  ObjOutput obj;                                      // the triangles that are said
};

int run_ray(const RayOptions& options);

struct NamedRay {
  std::string name;  // as given
  AnyRay ray;
  bool exact;  // no decimal of it was moved
};

struct RayReport {
  AskedMesh mesh;
  std::vector<NamedRay> rays;
  std::vector<std::vector<NumberedHit>> hits;  // of each ray, in order
};

std::string ray_text(const RayReport& report, bool all, const Style& style);
nlohmann::json ray_json(const RayReport& report);

}  // namespace plumb::tool

// `plumb bsp`: what BSP tree do the planes of a mesh make, how deep is it, and how many faces do they cut?
//
// Laws: (1) everything but the time depends on the mesh and the options alone.  (2) Text and JSON hold the same figures;
// the time is in JSON alone.  Exit code 0 when done; a mesh that is not closed where solid leaves are asked for, or that
// cannot be read, throws Error.
// Source: RTCD 8.3.6; plumb/space/bsp/build_bsp.hpp.
// Cost: one build.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "plumb/space/bsp/build_bsp.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct BspArguments {
  MeshArguments meshes;  // one file
  std::string leaves = "solid", planes = "faces-and-axes";
  BspOptions options;
  std::optional<std::string> json;  // "-" is standard output
};

int run_bsp(const BspArguments& arguments);

struct BspCommandReport {
  AskedMesh mesh;
  std::string leaves, planes;
  BspOptions options;
  BspReport tree;
  double build_ms = 0;
};

std::string bsp_text(const BspCommandReport& report, const Style& style);
nlohmann::json bsp_json(const BspCommandReport& report);

}  // namespace plumb::tool

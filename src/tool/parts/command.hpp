// `plumb parts`: of which convex parts does this solid consist, or which few hulls cover it?
//
// Laws: text, JSON and OBJ tell the same parts in the same order, which the order of the file's triangles does not
// change.  Exit code 0 when done; a mesh that bounds no solid or cannot be read, a length that is none and outputs that
// cannot be written throw Error.
// Source: RTCD 12.5.3; plumb/surface/parts/convex_parts.hpp, plumb/surface/parts/covering_parts.hpp.
// Cost: that of the decomposition.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct PartsOptions {
  MeshArguments meshes;                  // one file
  std::optional<std::string> concavity;  // a decimal
  std::optional<std::uint32_t> most;     // parts
  bool all = false;                      // list every part
  std::optional<std::string> json;       // "-" is standard output
  ObjOutput obj;                         // an object a part
};

int run_parts(const PartsOptions& options);

struct SolidPart {
  TriangleMesh mesh;  // its corners rounded to doubles
  std::size_t faces = 0;
  double volume = 0;                 // rounded once
  bool is_exact = true;              // its corners are doubles
  std::vector<std::uint32_t> share;  // of a hull that covers: the exact parts that it holds
  double concavity = 0;              // and how far it may reach beyond them
};

struct PartsReport {
  AskedMesh mesh;
  bool covers = false;  // with hulls
  std::uint64_t notches = 0, cuts = 0;
  std::size_t exact_parts = 0;
  std::vector<SolidPart> parts;
  static constexpr std::size_t listed = 10;  // of the parts, unless all are asked for
};

std::string parts_text(const PartsReport& report, bool all, const Style& style);
nlohmann::json parts_json(const PartsReport& report);

}  // namespace plumb::tool

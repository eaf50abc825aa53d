// `plumb inside`: which of these points are in the solid that this mesh bounds, and how often does it wind about them?
//
// Laws: text and JSON hold the same answers, in the order of the points as given.  Exit code 0 when done, whatever the
// answers; a mesh or words that cannot be read, an output that cannot be written throw Error.
// Source: plumb/space/ray/inside.hpp.
// Cost: that of the tree, and some microseconds a point.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/figure/basic/relation.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/rows/named_rows.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct InsideOptions {
  MeshArguments meshes;             // one file
  std::vector<std::string> points;  // three numbers each
  std::optional<std::string> file;  // of more points; "-" is standard input
  std::optional<std::string> tree;  // of the mesh, kept from before
  std::optional<std::string> json;  // "-" is standard output
};

int run_inside(const InsideOptions& options);

struct InsideReport {
  AskedMesh mesh;
  bool oriented = false;  // closed, and every edge is passed as often in either direction
  std::vector<NamedRow> points;
  std::vector<Location> locations;                    // of each point
  std::vector<std::optional<std::int64_t>> windings;  // nothing for a point on the surface
};

std::string inside_text(const InsideReport& report, const Style& style);
nlohmann::json inside_json(const InsideReport& report);

}  // namespace plumb::tool

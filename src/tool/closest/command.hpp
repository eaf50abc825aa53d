// `plumb closest`: how far are these points from this mesh, and which of its triangles and points is nearest?
//
// Laws: text, JSON and OBJ hold the same answers, those of --point first, then the table's, each in their order.  Exit
// code 0 when done, also where nothing is within the radius; a mesh, a table or words that cannot be read, an output that cannot be written throw Error.
// Source: plumb/space/closest/closest_on_mesh.hpp.
// Cost: that of the tree, and some microseconds a point.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/space/closest/closest_on_mesh.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/rows/named_rows.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct ClosestCommandOptions {
  MeshArguments files;                // a mesh, and where there is a second, a table of points
  std::vector<std::string> points;    // three numbers each
  std::optional<std::string> within;  // a decimal
  std::optional<std::string> tree;    // of the mesh, kept from before
  bool all = false;                   // list every answer
  unsigned threads = 0;
  std::optional<std::string> json;  // "-" is standard output
  ObjOutput obj;                    // the triangles that are nearest
};

int run_closest(const ClosestCommandOptions& options);

struct ClosestReport {
  AskedMesh mesh;
  std::optional<double> radius;  // farther than this is nothing
  std::vector<NamedRow> points;
  std::vector<std::optional<ClosestOnMesh>> found;  // of each point
  static constexpr std::size_t listed = 10;         // of the answers, unless all are asked for
};

std::string closest_text(const ClosestReport& report, bool all, const Style& style);
nlohmann::json closest_json(const ClosestReport& report);

}  // namespace plumb::tool

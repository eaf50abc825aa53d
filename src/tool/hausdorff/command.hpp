// `plumb hausdorff`: how far do these two surfaces deviate from one another, and where most?
//
// Laws: text, JSON and OBJ tell the same interval, which holds the distance for certain, and the same place.  Exit code
// 0 when done, also where the interval is wider than asked; meshes without triangles or that cannot be read, tolerances
// that are none and outputs that cannot be written throw Error.
// Source: RTCD 6.3.2; plumb/space/closest/hausdorff.hpp.
// Cost: that of the trees, and of a nearest triangle for every vertex and for each piece that is cut.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/space/closest/hausdorff.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct HausdorffCommandOptions {
  MeshArguments meshes;                           // two files
  bool one_way = false;                           // the points of A from B alone
  std::optional<std::string> absolute, relative;  // decimals: how wide the interval may be
  unsigned threads = 0;
  std::optional<std::string> json;  // "-" is standard output
  ObjOutput obj;                    // the two triangles
};

int run_hausdorff(const HausdorffCommandOptions& options);

struct HausdorffReport {
  std::vector<AskedMesh> meshes;  // a, b
  bool one_way = false;
  HausdorffDistance distance{};
  /// The meshes that the farthest point is one of, and that it is far from.
  [[nodiscard]] const AskedMesh& far() const { return meshes[distance.of_b ? 1 : 0]; }
  [[nodiscard]] const AskedMesh& from() const { return meshes[distance.of_b ? 0 : 1]; }
};

std::string hausdorff_text(const HausdorffReport& report, const Style& style);
nlohmann::json hausdorff_json(const HausdorffReport& report);

}  // namespace plumb::tool

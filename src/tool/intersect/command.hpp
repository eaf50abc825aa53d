// `plumb intersect`: which triangles of this mesh meet, or of these two?
//
// Laws: (1) text, JSON and OBJ hold the same pairs, ascending; text the first of them alone, unless all are asked for.
// (2) Exit code 0 when done, 1 where pairs are found and --fail-on-found asks for it; a mesh that cannot be read, an
// output that cannot be written throw Error.
// Source: plumb/space/pairs/mesh_pairs.hpp.
// Cost: that of the trees, and of the pairs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct IntersectOptions {
  MeshArguments meshes;             // one file, or two
  bool overlapping = false;         // only pairs that overlap
  bool first = false;               // any pair alone
  bool count = false;               // how many, and no pairs
  bool common = false;              // say what they have in common
  bool all = false;                 // list every pair
  bool fail_on_found = false;       // exit with 1 where there are any
  std::optional<std::string> json;  // "-" is standard output
  ObjOutput obj;                    // the triangles of the pairs
};

int run_intersect(const IntersectOptions& options);

struct IntersectReport {
  std::vector<AskedMesh> meshes;  // one, asked against itself, or two
  bool overlapping = false, complete = true;
  PairCount found;
  std::optional<std::vector<TrianglePair>> pairs;       // all of them, or any one
  std::optional<std::vector<Intersection3>> in_common;  // of each pair that is told

  [[nodiscard]] std::size_t many() const { return found.touching + found.overlapping; }
  [[nodiscard]] bool of_one() const { return meshes.size() == 1; }
};

IntersectReport intersect_report(const IntersectOptions& options, std::vector<AskedMesh> meshes);

/// "point", "segment" or "polygon": what two triangles can have in common.
std::string_view word_of(IntersectionKind common);

/// `most` pairs are listed.
std::string intersect_text(const IntersectReport& report, std::size_t most, const Style& style);
nlohmann::json intersect_json(const IntersectReport& report);
/// Objects `overlapping` and `touching`, of two meshes `a-overlapping` and so on; a triangle that does both overlaps.
std::string intersect_obj(const IntersectReport& report);

}  // namespace plumb::tool

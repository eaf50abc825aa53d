// `plumb repair`: what is wrong with these meshes that can be mended, mended, and each change told.
//
// Laws: (1) one mesh becomes one file, several and folders become a folder of files with their names.  (2) No file that
// is there is replaced, unless that is asked for, and never one that is read.  (3) Text and JSON tell the same.  (4)
// What is left of faults is told by what judges any mesh (`plumb check`).  (5) A mesh that is refused is told, and the
// others go on: if it was named, no mesh is written; if a folder holds it, theirs are.
// Exit code 0 when done, 1 where --fail-on-left is given and a fault is left, 2 where a mesh is refused: it cannot be read,
// or has a polygon thicker than is allowed; words that cannot be read, a step that there is not, an output that cannot be
// written throw Error.
// Source: plumb/surface/repair/repair.hpp.
// Cost: that of repair, and of find_faults before it.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/surface/repair/repair.hpp"
#include "tool/corpus/run_shard.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct RepairSettings {
  MeshArguments meshes;
  ShardOptions shard;                             // else all of the meshes, by this process
  std::optional<std::string> output, json, page;  // "-" is standard output
  std::vector<std::string> only;                  // names of steps
  double tolerance = 0;
  std::optional<double> planar;  // no polygon may be thicker
  std::uint64_t size = 0;        // components of fewer triangles are left out
  bool chains = false, keep_turned = false, dry_run = false, overwrite = false, fail_on_left = false;
  unsigned threads = 0;
};

int run_repair(const RepairSettings& settings);

/// The steps that are asked for; throws Error where one lacks its length or number.
std::vector<RepairStep> steps_of(const RepairSettings& settings);

/// Why a mesh is refused that has a polygon thicker than is allowed; its number is that of the file, from 0, as everywhere.
std::optional<std::string> why_not_planar(const InputMesh& input, const std::optional<double>& length);

/// The names of all steps, in the order in which they run.
std::vector<std::string> step_names();

struct MendedMesh {
  std::string name;
  LoadReport load;
  std::uint64_t vertices = 0, triangles = 0;  // as they were
  SurfaceFaults before;
  Repaired done;
  std::optional<std::string> written;  // the file
};

/// Of so many changes the place is told, in JSON and on the page.
inline constexpr std::size_t most_places = 1000;

/// One page that opens offline: the meshes before and after, the places of the changes, and a list that leads to them.
class RepairPage {
 public:
  void add(const TriangleMesh& before, const MendedMesh& mended);
  [[nodiscard]] std::string text() const;

 private:
  std::string body_;
  std::vector<nlohmann::json> scenes_;
  std::array<bool, change_kinds> kinds_{};
};

std::string repair_text(const MendedMesh& mesh, const Style& style);
nlohmann::json repair_json(const MendedMesh& mesh);

}  // namespace plumb::tool

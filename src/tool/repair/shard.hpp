// What does `plumb repair --shard` do of one model?  It is mended, and written below DIR/mended under its own path.
//
// Laws: (1) "verdict" is sound where nothing was wrong and nothing was changed, mended where nothing is left, left where
// something is, refused where --planar refuses it or another file is in its place.  (2) A file that is there is not
// replaced; one that a run which was killed wrote holds the same bytes, and stands.  (3) A sound model is written too.
// Source: plumb/surface/repair/repair.hpp.
// Cost: that of repair, and of find_faults before it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tool/repair/command.hpp"

namespace plumb::tool {

/// Throws MeshFileError, and Error where it is no mesh.
nlohmann::json mended_model(const std::string& file, const RepairSettings& settings);

int run_repair_shard(const RepairSettings& settings);

}  // namespace plumb::tool

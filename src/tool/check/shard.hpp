// What does `plumb check --shard` say of one model?  Its surface, and what is wrong with it, without what floats err on.
//
// Laws: (1) "verdict" is sound where the surface has none of the defects that --fail-on-defect takes, else faulty.  (2)
// What is told depends on the model and the settings alone.
// Source: RTCD 12.3, 12.4.
// Cost: that of find_faults.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tool/check/command.hpp"

namespace plumb::tool {

/// Throws MeshFileError, and Error where it is no mesh.
nlohmann::json checked_model(const std::string& file, const CheckOptions& options);

int run_check_shard(const CheckOptions& options);

}  // namespace plumb::tool

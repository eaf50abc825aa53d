// What does `plumb clash --shard` say of one assembly, which is a file of a folder?  How many pairs of its parts have which
// word.
//
// Laws: (1) "verdict" is clear where every part is read and no clash is listed, clashing where one is, unreadable where a
// part is not read.  (2) What is told depends on the file and the settings alone; nothing is measured.
// Source: plumb/world/clashes.hpp.
// Cost: that of find_clashes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tool/clash/command.hpp"

namespace plumb::tool {

/// Throws MeshFileError.
nlohmann::json clashed_model(const std::string& file, const ClashArguments& options);

int run_clash_shard(const ClashArguments& options);

}  // namespace plumb::tool

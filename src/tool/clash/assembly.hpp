// Which parts of an assembly are held against each other, and which of the clashes are listed?  For one assembly of many
// files, and for each of a shard.
//
// Laws: (1) parts of one name are told apart by numbers (bolt, bolt#2), in their order.  (2) Rules see the names without
// numbers.
// Source: plumb/world/clashes.hpp.
// Cost: that of find_clashes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumb/surface/file/read_assembly.hpp"
#include "tool/clash/command.hpp"

namespace plumb::tool {

/// The parts of a file go behind those that are there; their meshes are moved.
void add_parts(const std::string& file, AssemblyParts& parts, ClashReport& to, std::vector<TriangleMesh>& meshes);

/// Fills all of the report but `unread` and what was passed over; one mesh for each of its parts.
void list_clashes(const ClashArguments& options, std::span<const TriangleMesh> meshes, const ClashesOptions& how,
                  ClashReport& report);

}  // namespace plumb::tool

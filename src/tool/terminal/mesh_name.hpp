// Is a file somebody's mesh?  Asked of what an output would replace.
//
// Law: a mesh by its ending, read here or not, packed or not, whether it is there or not; or by its first bytes.
// Source: the formats as their authors published them.
// Cost: one page of the file is read.
#pragma once

#include <string>

namespace plumb::tool {

/// By its ending alone.
bool is_mesh_name(const std::string& path);

/// "is the name of a mesh", "is a mesh by its content"; nothing where it is none.
std::string why_mesh(const std::string& path);

}  // namespace plumb::tool

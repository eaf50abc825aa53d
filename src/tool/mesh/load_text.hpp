// What did reading this file find?  The load report in words, for every command that says it.
//
// Source: plumb/surface/read_mesh.hpp.
// Cost: none.
#pragma once

#include <string>

#include "plumb/surface/read_mesh.hpp"

namespace plumb::tool {

/// A line for the file, and one for each finding: what is not so has none.  `triangulated`: polygons were, after that.
std::string load_text(const LoadReport& report, bool triangulated = true);

}  // namespace plumb::tool

// What did reading this file find?  The load report in words, for every command that says it.
//
// Source: plumb/surface/file/read_mesh.hpp.
// Cost: none.
#pragma once

#include <string>

#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::tool {

/// A line for the file, and one for each finding: what is not so has none.  `triangulated`: polygons were, after that.
std::string load_text(const LoadReport& report, bool triangulated = true);

/// "lines that are no statement of OBJ: 2, the first in line 5: "f1 2 3"".
std::string passed_over_text(const PassedOver& passed);

}  // namespace plumb::tool

// `plumb split`: what of a solid lies on each side of a plane, or outside and inside of another solid?
//
// Laws: (1) both parts are exact until they are rounded, once, and what is called sound is certified; together they are
// the solid.  (2) Files are replaced and written as by `plumb boolean`.  (3) A mesh that bounds nothing is refused by its
// name, with an edge and what mends it, and nothing is written.
// Exit code 0 when done, 1 where a rounded part is not sound, 2 where a mesh bounds nothing; what else is refused throws
// Error.
// Source: plumb/surface/solid/split.hpp, plumb/surface/solid/boolean.hpp.
// Cost: theirs, and that of round.
#pragma once

#include "tool/boolean/command.hpp"

namespace plumb::tool {

struct SplitOptions : SolidOptions {  // output: what is above, or outside
  MeshArguments meshes;               // one
  std::optional<std::string> plane;   // as `plumb section` takes it
  std::optional<std::string> by;      // a closed mesh
  std::optional<std::string> other;   // where the other part goes
};

int run_split(const SplitOptions& options);

}  // namespace plumb::tool

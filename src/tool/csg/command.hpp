// `plumb csg`: which mesh is the solid that a text says, of cubes, polyhedra and meshes, united, intersected, subtracted?
//
// Laws: (1) all operations are one, exact until the result is rounded, once; what is called sound is certified.  (2) What
// files are replaced, what is written and what it is told of is as of `plumb boolean`.  (3) A text that cannot be read, or
// has what is not known or bounds nothing, is refused by its name, the line and the call, and nothing is written.
// Exit code 0 when done, 1 where the rounded result is not sound; what is refused throws Error.
// Source: plumb/surface/solid/evaluate.hpp; OpenSCAD's manual.
// Cost: that of evaluate and round.
#pragma once

#include "tool/boolean/command.hpp"

namespace plumb::tool {

struct CsgOptions : SolidOptions {
  std::string text;      // a file; "-" is standard input
  MeshArguments meshes;  // how those that it names are read
};

int run_csg(const CsgOptions& options);

}  // namespace plumb::tool

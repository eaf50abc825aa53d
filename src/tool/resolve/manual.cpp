#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual resolve_manual() {
  return {"plumb resolve",
          "make of a mesh that crosses itself one that does not",
          {"plumb resolve [OPTION]... MESH -o OUT"},
          {{"DESCRIPTION", R"(
Reads a closed MESH as `plumb check` does, which may touch and cross
itself, hold shells in one another and triangles twice, and writes the
mesh of the solid that it means: by --rule, the points around which it
winds a positive, a nonzero or an odd number of times. By `positive`,
parts that overlap become one, and what is inside out is outside.

It is cut along itself exactly, then rounded and judged as `plumb
boolean` does it.)"}},
          {{"EXIT STATUS", exit_status_of_solids("The rounded result is not sound.")},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb resolve scan.stl -o plain.stl
       A scan whose shells run into one another, as one solid.

plumb resolve knot.obj --rule nonzero -o knot.stl
       Whatever the mesh winds around, either way.)"}}};
}

}  // namespace plumb::tool

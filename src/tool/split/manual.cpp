#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual split_manual() {
  return {"plumb split",
          "cut a solid by a plane or by another solid",
          {"plumb split [OPTION]... MESH --plane PLANE -o ABOVE [--other BELOW]",
           "plumb split [OPTION]... MESH --by MESH -o OUTSIDE [--other INSIDE]"},
          {{"DESCRIPTION", R"(
Reads a closed MESH as `plumb check` does and writes what of its solid
lies above a plane, on the side of its normal, or outside of another
solid, and with --other the rest. Both parts are closed; where they are
cut, they have the same corners.

A mesh may touch and cross itself: it is resolved first. All is cut
exactly; then each part is rounded and judged as by `plumb boolean`.)"}},
          {{"EXIT STATUS", exit_status_of_solids("A rounded part is not sound.")},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb split part.stl --plane z=12.5 -o lid.stl --other box.stl
       A part in two that can be printed.

plumb split part.stl --by ball.obj -o rest.stl
       What is outside of another mesh.)"}}};
}

}  // namespace plumb::tool

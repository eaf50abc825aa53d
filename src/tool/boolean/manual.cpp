#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual boolean_manual() {
  return {"plumb boolean",
          "unite, intersect or subtract solids, exactly",
          {"plumb boolean [OPTION]... union MESH MESH... -o OUT",
           "plumb boolean [OPTION]... intersection MESH MESH... -o OUT",
           "plumb boolean [OPTION]... difference MESH MESH... -o OUT",
           "plumb boolean [OPTION]... symmetric MESH MESH... -o OUT"},
          {{"DESCRIPTION", R"(
Reads two or more MESHes as `plumb check` does, takes each for the solid
that it bounds, and writes the mesh of what is inside any of them
(union), all of them (intersection), the first and none of the others
(difference), or an odd number of them (symmetric). A mesh may touch and
cross itself and the others, lie in their planes, or be one of them.

Where faces were cut, their pieces stay, unless --merge makes polygons
of all that lies in one plane, exactly, and triangles of these anew.

All is combined at once and exactly; then each vertex is rounded to its
nearest double, and the result is judged: closed, wound outward, and no
two triangles with anything in common but vertices and edges of both.
What this breaks is resolved and rounded again, on a coarser grid. It is
told whether the result is sound, and how far any point of it is from
the exact one at most. What is not sound is not written, unless
--unsound asks for it; pairs of triangles that meet are named by their
numbers in it, from 0.

A mesh that is open or whose triangles run against each other bounds
nothing and is refused, with an edge; `plumb repair` mends many such.)"}},
          {{"EXIT STATUS", exit_status_of_solids("The rounded result is not sound.")},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb boolean union hull.stl keel.stl fin.stl -o boat.stl
       One solid of three.

plumb boolean difference block.obj drill.obj -o drilled.obj
       A block without what the drill takes away.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual inside_manual() {
  return {"plumb inside",
          "which points are inside of a mesh?",
          {"plumb inside [OPTION]... --point X,Y,Z MESH", "plumb inside [OPTION]... --points FILE MESH"},
          {{"DESCRIPTION", R"(
Says of each point whether it is inside of MESH, a file as `plumb check`
reads it, outside or on its surface, and the winding number: how often
the surface goes around the point, 1 in a solid whose triangles turn
counterclockwise seen from outside, -1 where they turn clockwise. It is
decided exactly, and there are no unlucky points: not beside edges,
corners or in planes of triangles.

Inside is where a ray from the point crosses the surface an odd number
of times: a solid within a solid is a hollow, whichever way it is
turned, and what two solids have in common is outside, with a winding
number of 2. Where the mesh is not closed the answer depends on the ray,
which goes along x; the report says so.

The file of --points holds three numbers on a line, with commas or
blanks between them; empty lines, what follows '#' and a first line of
words (a header) are passed over; one that names x, y or z, and not
these three in their order, is refused. It may be packed by gzip. A
number stands for its nearest double, and it is said how many are
none.)"}},
          {{"EXIT STATUS", R"(
0      Done, whatever the answers are.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb inside --point 0,0,10 --point 0,0,12.5 part.stl
       Two points.

plumb inside --points probes.txt --json where.json part.obj
       Many, for another program.)"}}};
}

}  // namespace plumb::tool

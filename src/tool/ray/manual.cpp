#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual ray_manual() {
  return {"plumb ray",
          "which triangles of a mesh do rays hit?",
          {"plumb ray [OPTION]... --ray OX,OY,OZ,DX,DY,DZ MESH", "plumb ray [OPTION]... --rays FILE MESH"},
          {{"DESCRIPTION", R"(
Shoots rays at MESH, a file as `plumb check` reads it, and says of each
how many triangles it hits and which one first: its number in the file,
from 0, the parameter t (multiples of the direction from the origin; of
a segment, 0 at its first end and 1 at its second), whether the place is
at a vertex, on an edge or within the face, and where it is.

Which triangles are hit, and in which order, is decided exactly; of
equal parameters the lowest number comes first. Triangles are closed: a
ray at a vertex hits all triangles about it, and none slips through
between two triangles that share an edge. Numbers are the exact ones
rounded once.

--rays and --segments name tables: a ray or a segment a line, six
decimals with blanks or commas between them, packed or not. A table
whose header names the ends of segments is none of rays, and the other
way round.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where nothing is hit.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb ray --ray 0,0,100,0,0,-1 part.stl
       The first triangle straight below a point.

plumb ray --all --segment 0,0,0,10,5,2 part.obj
       All that is hit between two points.

plumb ray --rays probes.csv --json - part.stl
       A table of rays, for another program.

plumb ray --obj hit.obj --ray 0,0,100,0,0,-1 part.stl
       The triangle that is hit, as a mesh to be looked at.)"}}};
}

}  // namespace plumb::tool

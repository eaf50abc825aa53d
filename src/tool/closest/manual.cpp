#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual closest_manual() {
  return {"plumb closest",
          "how far are points from a mesh?",
          {"plumb closest [OPTION]... MESH POINTS", "plumb closest [OPTION]... --point X,Y,Z MESH"},
          {{"DESCRIPTION", R"(
Says of each point how far the surface of MESH is away, a file as `plumb
check` reads it; which of its triangles is nearest, by its number in the
file, from 0; whether the nearest place is at a vertex, on an edge or
within the face, and where it is. A polygon counts as the triangles that
it is cut into.

POINTS is a table as `plumb inside --points` reads it: a point a line,
three decimals with blanks or commas between them, packed or not.

Which triangle is nearest is decided exactly; of equally near ones the
lowest number is told. Distances and coordinates are the exact ones
rounded once, written with all of their digits. What is exactly as far
away as --within is within.

The surface is asked, not what it encloses: of a point inside of a closed
mesh the distance from the wall is told. `plumb inside` says which those
are.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where nothing is within the radius.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb closest part.stl probes.csv
       How far measured points are from the model.

plumb closest --within 0.05 --json - part.stl probes.csv
       Those within a tolerance, for another program.

plumb closest --point 0,0,10 --obj near.obj part.stl
       The triangle that is nearest to a point, as a mesh to look at.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual csg_manual() {
  return {"plumb csg",
          "make the solid that a text of unions and differences says",
          {"plumb csg [OPTION]... FILE -o OUT"},
          {{"DESCRIPTION", R"(
Reads a text of solids and operations, and writes the mesh of what it
says. The text is what OpenSCAD exports as .csg; the language itself,
with variables and loops, is not run.

All solids are cut along one another once, exactly; the result is
rounded and judged as `plumb boolean` does it.)"},
           {"THE TEXT", R"(
cube, polyhedron
       As OpenSCAD has them; faces of a polyhedron turn clockwise.
cylinder, sphere
       With the flat facets that OpenSCAD gives them, by $fn, $fa, $fs.
import("part.stl")
       A closed mesh, of any format that is read; its name is taken from
       the folder of FILE.
union, group, color, render; intersection; difference
       Of what stands in their braces.
symmetric_difference
       What is in an odd number of them; OpenSCAD has none.
hull
       Of solids that are united and placed, no more.
multmatrix; translate, scale
       Matrices are multiplied exactly, then each coordinate is rounded
       once; the report counts those.

What is marked * or % is left out. Refused by name are minkowski,
rotate, resize, what is extruded, flat shapes and all else.)"}},
          {{"EXIT STATUS", R"(
0      Done.
1      The rounded result is not sound.
2      Bad input: wrong usage, a text or mesh that cannot be read, holds
       what is not known or bounds nothing, a file that is there already,
       an output that cannot be written. What was wrong stands on
       standard error, with the line, and nothing is written.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
openscad -o bracket.csg bracket.scad && plumb csg bracket.csg -o b.stl
       A model of OpenSCAD, exactly.

echo 'difference() { cube(4); translate([1,1,1]) cube(4); }' |
  plumb csg - -o corner.obj
       A cube without a corner.)"}}};
}

}  // namespace plumb::tool

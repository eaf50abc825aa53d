#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual section_manual() {
  return {"plumb section",
          "where do planes cut a mesh?",
          {"plumb section [OPTION]... --plane PLANE MESH"},
          {{"DESCRIPTION", R"(
Cuts MESH, a file as `plumb check` reads it, by planes into contours:
closed lines, outer ones counterclockwise and holes clockwise seen from
the side of the plane's normal, and which lies in which. How they are
connected, turned and nested is decided exactly; a corner is the exact
point where an edge meets the plane, rounded once when it is written.

PLANE is one of
z=1.5  The points of that height; x and y likewise.
z=0:10:0.2
       Heights from 0 by 0.2 up to 10: sums of decimals, each at its
       nearest double.
NX,NY,NZ,OFFSET
       The points p with normal . p = offset.
AX,AY,AZ,BX,BY,BZ,CX,CY,CZ
       The plane of three points, seen from where they turn
       counterclockwise.

A vertex in a plane counts as above it, on the side of the normal: the
section is that of a plane an infinitesimal step below, so that the top
of a box is a contour at its height and its bottom is none, and layers
of a stack of boxes neither miss nor repeat. --below turns that around.
Triangles that lie in a plane are counted, and listed in the JSON.

Walls that two solids share cancel. Where contours touch, each passes
the corner once, and none crosses another. Holes in the mesh, and
triangles wound against each other, leave open chains.

The SVG shows planes as seen from their normal's side, z upward where
it can be, in the mesh's unit: of z=1.5 it holds x and y, of x=1.5 y and
z, of y=1.5 -x and z. Its lines are 1/900 of the drawing's larger side
wide. DXF and JSON hold corners in space; the JSON also names the two
vertices of each corner's edge, which are one where the corner is a
vertex. Areas and lengths are those of the rounded corners.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where nothing is cut or contours are open.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       a plane without a normal, an output that cannot be written. What
       was wrong stands on standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb section --plane z=1.5 --svg cut.svg part.stl
       One section, drawn.

plumb section --plane z=0.1:20:0.2 --out layers part.stl
       Layers of a print, a file each.

plumb section --plane 1,1,0,0 --plane x=0 --dxf cuts.dxf part.obj
       Two upright sections for a CAD program.)"}}};
}

}  // namespace plumb::tool

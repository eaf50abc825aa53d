#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual bounds_manual() {
  return {"plumb bounds",
          "how tight and how dear is each bounding volume on a mesh?",
          {"plumb bounds [OPTION]... [MESH]..."},
          {{"DESCRIPTION", R"(
Reads each MESH, files and folders as `plumb check` reads them, and
bounds its vertices by every kind of volume that the library fits: the
smallest sphere, the axis-aligned box, capsule, lozenge, the oriented
box of least volume, and k-DOPs of 14, 18 and 26 faces. Of each it says:

tightness
       Its volume over that of the mesh's convex hull.
false overlaps
       Two copies of the mesh are turned at random and placed where
       their spheres meet. Of the placements whose hulls are apart, the
       share in which the bounds overlap. Placements are exact, and
       whether hulls meet is decided exactly.
test ns
       The time of one overlap test, measured on these placements.
query ns
       What a query is expected to cost: the test, and where the bounds
       overlap, a refined test behind it. The least is marked; it is
       what choose_bound would choose.

Axis-aligned boxes and k-DOPs are fitted anew to the turned mesh; the
other volumes are turned with it. Without a MESH it takes the one that
the program brings along.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error, and no output was touched.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb bounds part.stl --refined 20000
       Which volume should stand before a test of 20 microseconds?

plumb bounds *.obj --chart bounds.svg --json bounds.json
       The spectrum of volumes on these meshes, as a picture and as
       numbers.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual repair_manual() {
  return {"plumb repair",
          "mend meshes, and tell each change",
          {"plumb repair [OPTION]... MESH -o FILE", "plumb repair [OPTION]... MESH... -o FOLDER",
           "plumb repair [OPTION]... --dry-run MESH...", "plumb repair --shard I/N --out DIR [OPTION]... FOLDER"},
          {{"DESCRIPTION", R"(
Reads each MESH as `plumb check` does, takes the steps below in turn,
and writes the mesh that comes of them. Polygons are triangulated, also
where they are not planar, unless --planar refuses those that are
thicker than a length: none at all for 0.
Whatever no step names stays as it was, bit for bit; no vertex gets a
new coordinate. All is decided exactly; a tolerance is a wish, and is
compared exactly. What cannot be mended stays, and is told: surfaces
that cross, holes whose filling would meet the surface or that two
fillings fit equally well, one-sided components. At last the mesh is
judged as `plumb check` does.)"},
           {"SHARDS", R"(
With --shard it mends one of N parts of the meshes in a folder, each by
a process of its own, as `plumb check --shard` checks them, and writes
each below DIR/mended under its own path, .obj behind it where its
format is not written. The verdicts are sound (nothing was wrong, and
nothing is changed), mended (nothing is left), left (something is),
refused (by --planar, or because another file is in its place) and those
that `plumb check` has of models that cannot be looked at. With
--dry-run no mesh is written. `plumb collect DIR` tells of all.)"},
           {"STEPS", R"(
Without --only all are taken but slivers, merge-coplanar, zip where
there is no tolerance, and small-components where --smallest does not
ask for it.

weld   Vertices that are equal, or within --tolerance, become one:
       clusters no wider than the tolerance, or --chains.
degenerate
       Triangles of exactly no area are left out; the neighbor at the
       longest edge is divided.
slivers
       So are triangles of which a corner is within --tolerance of the
       opposite edge.
t-junctions
       Edges are divided where a vertex is exactly on them; behind zip,
       also where it is within --tolerance of them.
zip    Open edges within --tolerance of each other are joined.
duplicates
       Of triangles on the same three points one is left at most.
walls  Open shells inside of a solid are left out, but for those that
       all but close: cavities with holes.
small-components
       Components of fewer triangles than --smallest are left out.
orientation
       Neighbors are wound alike; the fewer triangles are turned.
holes  Loops of open edges are filled.
outward
       Closed shells that are inside out are turned.
split  A vertex of several fans becomes one vertex a fan.
merge-coplanar
       Neighbors in one plane, exactly or within --tolerance, become as
       few triangles as their outline allows.
unused Vertices that no triangle names are left out.)"}},
          {{"EXIT STATUS", R"(
0      Done.
1      A fault is left, and --fail-on-left asked.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       a polygon thicker than --planar allows, a file that is there
       already, an output that cannot be written.
       What was wrong stands on standard error.)"},
           {"EXAMPLES", R"(
plumb repair part.stl -o mended.stl
       What makes a printable solid of it.

plumb repair --dry-run --tolerance 0.01 parts/
       What would be changed in each mesh of a folder.

plumb repair --dry-run part.stl --page changes.html
       The same for one mesh, to look at: open changes.html.

plumb repair --only weld,unused part.obj -o welded.obj
       These steps alone.)"}}};
}

}  // namespace plumb::tool

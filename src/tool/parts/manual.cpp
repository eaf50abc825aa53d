#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual parts_manual() {
  return {"plumb parts",
          "of which convex parts does a solid consist?",
          {"plumb parts [OPTION]... MESH"},
          {{"DESCRIPTION", R"(
Parts the solid that MESH bounds, a file as `plumb check` reads it, into
convex polyhedra: none overlap, none is missing, and their volumes add up
to the mesh's, exactly. It is cut along planes of its own triangles; a
corner that is no double is written as the nearest one, and it is said
of how many parts that is so. Parts are counted from 0, in the table, in
JSON and in the names of objects.

With --concavity, --most or both, hulls are told instead, each of which
holds the parts that it stands for, for certain: as collision geometry.
How far a hull reaches beyond what it covers is told as a length that it
is proved not to exceed. As few hulls as are found, not as few as there
could be.

A mesh that bounds no solid is refused, with the place: an open edge,
triangles that cross, a shell that is inside out. `plumb repair` mends
such.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or bounds no
       solid, an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb parts --obj parts.obj part.stl
       The convex parts, an object each.

plumb parts --concavity 0.5 --most 32 --obj hulls.obj part.stl
       At most 32 hulls for a physics engine.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual bsp_manual() {
  return {"plumb bsp",
          "what BSP tree do the planes of a mesh make?",
          {"plumb bsp [OPTION]... MESH"},
          {{"DESCRIPTION", R"(
Divides space by the planes of the faces of MESH, a file as `plumb check`
reads it, and by planes across the axes, until no face is left that is
not in one of them, and says how large that tree is: how many planes, how
deep, how many leaves, and into how many pieces the faces were cut. The
pieces are exact: their corners are not rounded.

With --leaves solid, as it is without the option, each leaf is told to be
inside the solid or outside; MESH has to be closed then, but may cross
itself. With --leaves pieces the faces are handed down to the leaves,
with --leaves none they stay with the planes; both take any mesh.

With --planes faces the planes across the axes are left out. The tree of
a convex mesh is then as deep as it has faces, and takes a time that
grows with the square of their number.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       a mesh that is not closed where solid leaves are asked for, an
       output that cannot be written. What was wrong stands on standard
       error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb bsp part.stl
       How large the tree of a part is.

plumb bsp --leaves none --split-weight 0.9 --json - part.stl
       The figures of one with fewer splits, for another program.)"}}};
}

}  // namespace plumb::tool

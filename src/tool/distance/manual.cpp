#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual distance_manual() {
  return {"plumb distance",
          "how far are two meshes apart?",
          {"plumb distance [OPTION]... A B"},
          {{"DESCRIPTION", R"(
Says how far the surfaces of A and B are apart, files as `plumb check`
reads them: 0 where they meet. With it the two triangles that are
nearest to one another, by their numbers in the files, from 0; whether
the nearest points are at a vertex, on an edge or within the face, and
where. A polygon counts as the triangles that it is cut into.

Which triangles and features are nearest is decided exactly; of pairs
that are equally near, that of the lowest numbers, those of A first.
Distance and coordinates are the exact ones rounded once, written with
all of their digits.

Surfaces are asked, not what they enclose: a mesh that lies within a
closed one is as far from it as from its walls. `plumb inside` says
whether points of it are within.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where the meshes meet.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb distance a.stl b.stl
       The gap between two parts, and where it is.

plumb distance --json - a.obj b.obj
       The same for another program, with the vertices of the features.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual hausdorff_manual() {
  return {"plumb hausdorff",
          "how far do two surfaces deviate?",
          {"plumb hausdorff [OPTION]... A B"},
          {{"DESCRIPTION", R"(
Says how far the farthest point of either mesh is from the other: the
Hausdorff distance of the surfaces of A and B, files as `plumb check`
reads them. With --from, how far the farthest point of A is from B: how
far A sticks out of B. All points of the triangles count, not the
vertices alone.

Told are two numbers between which the distance lies for certain, the
point where the lower one is reached, on which triangle it lies, by its
number in the file, from 0, and which triangle of the other mesh is
nearest to it. The two numbers are as near to one another as --absolute
or --relative ask, whichever asks less, or as 2^-40 of the extent of the
larger mesh, below which there is rounding alone; or it is said that they
are not.

Of one surface in two triangulations the distance is 0, and the bounds
are as small as the rounding of points.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where the bounds are farther apart than was asked.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       a mesh without triangles, an output that cannot be written. What
       was wrong stands on standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb hausdorff part.stl simplified.stl
       What the simplification cost.

plumb hausdorff --from --absolute 0.001 --json - scan.ply part.stl
       How far a scan is from the model, for another program.)"}}};
}

}  // namespace plumb::tool

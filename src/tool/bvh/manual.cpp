#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual bvh_manual() {
  return {"plumb bvh",
          "what tree of boxes has a mesh, and what does it cost?",
          {"plumb bvh [OPTION]... MESH", "plumb bvh --method all [OPTION]... MESH"},
          {{"DESCRIPTION", R"(
Builds the tree that rays, distances and other questions of MESH, a file
as `plumb check` reads it, descend, and says how many nodes and leaves
it has, how deep it is, what it costs to be asked, how many bytes it
takes for each triangle, vertices included, and how long its build took,
the shortest of up to three.

The cost is the estimate of the surface-area heuristic: how many nodes a
line meets that goes through the mesh's box somewhere, on the average,
and half of how many triangles lie in the leaves among them. Every tree
gives the same answers; they differ in cost and in the time of a build.

--split-share lets the tree have at most so many parts more than
triangles, as a share of these: those whose boxes are emptiest are
divided first, and lie in several leaves. 0.2 helps where triangles are
long and lie across the axes; elsewhere it costs memory.

--svg draws the tree: for some depths the boxes that hold the mesh
there, seen along its shortest axis, and a bar for the cost of each
depth. Boxes that overlap cost both.

--out keeps the tree in a file. `plumb ray`, `plumb closest` and
`plumb inside` take it by --tree, beside the mesh that it is of, and
build none. What is no whole tree, or that of another mesh, they
refuse.)"},
           {"METHODS", R"(
binned
       From the top, the surface-area heuristic over bins.
sweep
       The same over all cuts.
object-median, object-mean, spatial-median
       Cuts across the longest axis.
linear
       By Morton codes of the boxes' middles: the fastest to build.
agglomerative
       From the triangles up, pairs that are each other's nearest.
nearest-pairs
       Always the pair of the least box: quadratic, so that 'all' leaves
       it out of meshes of more than 20,000 triangles.
insertion
       One triangle after the other, where it costs least.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb bvh --method all part.stl
       All builders, in a table.

plumb bvh --split-share 0.2 needles.stl
       What dividing long triangles gains.

plumb bvh --method linear --svg tree.svg part.stl
       One tree, drawn.

plumb bvh --out part.bvh part.stl
       A tree that is kept, for plumb ray --tree part.bvh.)"}}};
}

}  // namespace plumb::tool

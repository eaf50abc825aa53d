#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual convex_manual() {
  return {"plumb convex",
          "how do the convex hulls of two meshes lie?",
          {"plumb convex [OPTION]... A B"},
          {{"DESCRIPTION", R"(
Takes the convex hull of all vertices of A, and that of B, files as
`plumb check` reads them, and says exactly whether the two are disjoint,
touch or overlap. Of hulls that are disjoint it says how far they are
apart, where they come closest, and between which vertices; of others
how deep they are in one another: the least way that one must be moved
until they no more than touch. Of each mesh it says whether it is convex
itself, and if not, where.

Faces are not needed: clouds of points will do, in any of the formats.
Hulls may be flat, a segment or a point. Vertices have the numbers of
the file, from 0. Distance, depth and coordinates are the exact ones
rounded once, written with all of their digits.

The answer comes with a proof, which is verified before it is told: a
direction along which all of A lies before all of B, or pairs of
vertices whose differences have the origin among them. --certificate
writes it down for docs/verify_certificate.py, which needs nothing of
this program.

--history writes bodies.obj, step-001.obj and so on, one simplex of the
set of differences a file, and index.html: all steps on one page, with a
slider, for a browser without a network.)"}},
          {{"EXIT STATUS", R"(
0      Done, however they lie.
2      Bad input: wrong usage, a file that cannot be read or has no
       vertices, an output that cannot be written. What was wrong stands
       on standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb convex a.stl b.stl
       Do their hulls collide, and how deep?

plumb convex --certificate proof.json a.obj b.obj
python3 docs/verify_certificate.py proof.json
       The same, proved once more without this program.

plumb convex --history steps a.obj b.obj
       How the search went: open steps/index.html.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual intersect_manual() {
  return {"plumb intersect",
          "which triangles of a mesh meet, or of two meshes?",
          {"plumb intersect [OPTION]... A [B]"},
          {{"DESCRIPTION", R"(
Finds all pairs of triangles that meet: one of A and one of B, or, where
A stands alone, two of A. Both are files as `plumb check` reads them. A
pair overlaps where the insides of its triangles have a point in common,
and touches where only their borders do; that is decided exactly.

Of one mesh, neighbors are asked for what they have in common beyond the
vertices that they share: an edge or a corner is no contact, a fold onto
one another is. Vertices are shared that have the same number, not those
that merely lie in the same place: where a mesh repeats its vertices,
its triangles touch there, and it is said how many there are. (A file
without numbers, as STL, is read with one vertex for each point.)

Pairs are listed by the numbers of their triangles in the files, from
0, the first ten or, with --all, every one. A polygon counts as the
triangles that it is cut into. The OBJ has an object for triangles that
overlap and one for those that only touch, of two meshes two for each,
and before a triangle its number as a comment.)"}},
          {{"EXIT STATUS", exit_status("A pair was found, and --fail-on-found was given.")},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb intersect --obj bad.obj part.stl
       Where the part runs through itself, as a mesh to be looked at.

plumb intersect --overlapping --common a.obj b.obj
       Where two parts run into one another, and along which segments.

plumb intersect --first --quiet --fail-on-found a.stl b.stl
       Whether two parts meet, for a script.)"}}};
}

}  // namespace plumb::tool

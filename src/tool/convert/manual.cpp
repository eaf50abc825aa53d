#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual convert_manual() {
  return {"plumb convert",
          "write a mesh file in another format",
          {"plumb convert [OPTION]... FROM TO"},
          {{"DESCRIPTION", R"(
Reads FROM, a mesh file as `plumb check` reads it, and writes TO, in the
format of its extension (OBJ, OFF, STL, PLY) or of --format. Faces are
kept as they are, polygons too, and every coordinate is the same double:
text has the shortest decimal that names it, binary PLY holds it whole.
What was found in FROM is said: decimals that are no doubles, faces left
out.

STL knows no polygons and no indices: polygons are triangulated, and
vertices come in the order of use. It is written as text, for binary
STL holds 32-bit coordinates only; with --encoding binary a mesh that
needs more is refused. Nothing is welded or repaired.

A file that is there is not replaced, unless --overwrite asks for it;
FROM itself never is.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       a file that is there already, an output that cannot be written.
       What was wrong stands on standard error.)"},
           {"EXAMPLES", R"(
plumb convert part.obj part.ply
       As binary PLY, every coordinate the same double.

plumb convert --encoding binary part.ply part.stl
       As binary STL, if 32 bits hold every coordinate.)"}}};
}

}  // namespace plumb::tool

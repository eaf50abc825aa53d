#include "tool/manual/help_text.hpp"

#include <fmt/format.h>

namespace plumb::tool {

std::string exit_status(std::string_view one) {
  return fmt::format(R"(
0      Done.
1      {}
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error, and no output was touched.)",
                     one);
}

std::string exit_status_of_solids(std::string_view one) {
  return fmt::format(R"(
0      Done.
1      {}
2      Bad input: wrong usage, a file that cannot be read, is no mesh or
       bounds nothing, a file that is there already, an output that
       cannot be written. What was wrong stands on standard error, and
       nothing is written.)",
                     one);
}

std::string environment() {
  return R"(
NO_COLOR
       When set to anything, no colors. Without it, colors are used only
       where the output is a terminal.)";
}

std::string environment_of_batches() {
  return R"(
PLUMB_INSTRUCTION_SET
       Which vectors batches of signs take: one of those that plumb
       doctor lists. The best of them when not set. It changes how fast
       signs are decided, never what they are.
)";
}

Manual program_manual() {
  return {"plumb",
          "exact signs for geometry, and a check of the inexact ones",
          {"plumb COMMAND [OPTION]...", "plumb help [COMMAND]"},
          {{"DESCRIPTION", R"(
Geometric programs decide by signs: on which side of a line, in or out
of a circle. Computed in floating point such a sign can be wrong, and
one wrong sign is enough to break a mesh. plumb decides them exactly,
for every finite double, and shows what the inexact ways get wrong.)"},
           {"COMMANDS", R"(
bounds [MESH]...
       Says of each kind of bounding volume how tight it is on these
       meshes, how often it overlaps falsely and what its test costs.

bvh MESH
       Builds the tree of boxes of a mesh in one way or in all, says what
       it costs to be asked, and draws it.

check [MESH]...
       Says whether these meshes are closed, oriented and free of
       self-intersections and degenerate triangles, of which shells they
       consist, and what is wrong with them. Then takes the
       decisions that mesh software takes on them, in floating point and
       exactly, and says where floating point errs.

collect DIR
       Tells what was found of a folder of models by several runs of
       check, the worst first.

convert FROM TO
       Writes a mesh file in another format, every coordinate the same
       double.

distance A B
       Says how far two meshes are apart, and between which triangles.

fuzz
       Finds inputs on which a function of another library is wrong, and
       makes them small.

inside --point X,Y,Z MESH
       Says which points are inside of a closed mesh, and how often its
       surface goes around them.

intersect A [B]
       Finds all pairs of triangles of a mesh that meet, or of two.

nearest POINTS QUERIES
       Finds the points that are nearest to queries, or within a radius.

pairs A [B]
       Finds all pairs of boxes that overlap, in a file or between two.

plan [MESH]...
       Says what exact decisions on a scene of these meshes need, what a
       coarser lattice would save and do to them, and which bounding
       volumes are the cheapest.

ray --ray OX,OY,OZ,DX,DY,DZ MESH
       Says which triangles of a mesh rays hit, first and in order.

section --plane PLANE MESH
       Cuts a mesh by planes into exact contours, and draws them.

sign PREDICATE COORDINATE...
       Decides one sign exactly and says which stage decided it.

proof PREDICATE
       Writes the error bound behind a predicate's filter as a claim that
       a machine can check.

doctor
       Looks whether this machine and build are as the proofs assume.

help [COMMAND]
       Shows the page of a command, or writes all as manual pages.

completion SHELL
       Prints what lets bash, zsh or fish complete a command line.)"}},
          {{"EXIT STATUS", exit_status("No: a wrong sign, a machine that is not as the proofs assume.\n       `plumb "
                                       "COMMAND --help` says which.")},
           {"OUTPUTS", R"(
A file that an option names for output (--json, --chart, --out) appears
whole at the end of a run that ended with 0 or 1; until then, and after
any other end, what was there before is there still. A file of that name
is replaced, with its permissions; not so a file that the run reads, nor
one that is a mesh by its name or content, nor anything by a sample or,
unless --overwrite is given, by a mesh that is written.
'-', or an option without a name, is standard output, which then has
that output alone.)"},
           {"ENVIRONMENT", environment() + "\n" + environment_of_batches()},
           {"EXAMPLES", R"(
plumb check
       The check on the mesh that the program brings along.

plumb sign orient2d 0 0 1 0 0 1
       Prints "+ filter": the points turn counterclockwise.)"}}};
}

}  // namespace plumb::tool

#include "lab/stability/command.hpp"
#include "tool/manual/help_text.hpp"

namespace plumb::lab {

Manual stability_manual() {
  return {"plumb-lab stability",
          "where do methods fail, and what does one see of it?",
          {"plumb-lab stability [OPTION]..."},
          {{"DESCRIPTION", R"(
Runs geometric algorithms as they are commonly written on inputs that are
hard for them, and the exact ones beside them. Says of each how often it
failed, in the terms of who uses it: a hull lost an extreme point, a
loop did not end.

With --out DIR the tables are written into that folder as stability.txt
and stability.json (with machine, compiler, flags and date), each picture
as an SVG, and all of it as stability.html, a page to be filtered, which
needs no network.

With --models DIR rays are also aimed at the meshes in that folder, its
files .obj, .off, .ply and .stl. With --ccd DIR the queries in the files
.csv below that folder are asked as well: eight rows are the points of a
vertex and a triangle, or of two edges in a folder edge-edge, before and
after; a row is x, y, z as numerator and denominator, and the answer.)"},
           {"METHODS", R"(
float32        Single precision, of coordinates rounded to it.
double         The algorithm as it is commonly written, no epsilon.
absolute       As double, with an epsilon of 1e-9.
relative       As double, with an epsilon of 1e-9 of the terms' size or,
               where code branches, of the largest coordinate.
long-double    The same in the compiler's long double.
exact          With exact decisions. It fails nothing.
convex_hull    The library's own hull, beside the algorithms on trial.
grid, hashing, sorted, first-come
               Of welding: cells as wide as the tolerance; equal bits;
               along x in floats; the first of the file that is near.
coarse         Of cubics of motion, with an epsilon of 1e-6.
advancement    Steps of the distance over the speed, until that is within
               1e-9 of the largest coordinate; coarse-advancement, 1e-6.

What is called `in one's space' moves one figure into the coordinates of
the other. `exact, rounded points' decides exactly about coordinates that
were rounded when they were turned, and loses what the rounding lost;
`exact, posed' decides about the turned points, which nothing rounds.)"}},
          {{"EXIT STATUS", R"(
0      Done.
1      The exact method failed something, which is a bug. It says where.
2      Bad input: wrong usage, an experiment that does not exist, a
       folder that cannot be used. What was wrong stands on standard
       error, and nothing is left half written.)"},
           {"ENVIRONMENT", R"(
NO_COLOR
       When set to anything, no colors. Without it, colors are used only
       where the output is a terminal.)"},
           {"EXAMPLES", R"(
plumb-lab stability --quick
       Everything, a little of it.

plumb-lab stability --experiment grid --out report
       Pictures of what each method sees around a line.)"}}};
}

}  // namespace plumb::lab

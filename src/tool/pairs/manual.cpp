#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual pairs_manual() {
  return {"plumb pairs",
          "which of many boxes overlap?",
          {"plumb pairs [OPTION]... FILE", "plumb pairs [OPTION]... A B"},
          {{"DESCRIPTION", R"(
Finds all pairs of axis-aligned boxes of FILE that overlap (the broad
phase of collision detection), or of a box of A and one of B, and says
how many there are, and how many of them only touch.

Boxes are closed, so those that touch meet; --no-touching passes over
them. It is decided exactly: boxes that miss one another by the last bit
of a double do not meet. Boxes may be flat, and may be points. They are
numbered from 0 in the order of the file; a pair of one set comes once,
the lower number first.)"},
           {"FILES", R"(
CSV
       A box on a line, as four numbers in the plane (min x, min y,
       max x, max y) or six in space (min x, min y, min z, max x, max y,
       max z), with commas, semicolons or blanks between them. Empty
       lines, what follows '#' and a header are passed over; a header
       that has some of these names and others, or another order, is
       refused. A number stands for its nearest double, and it is said
       how many are none.
.npy
       An array of NumPy of the shape (n, 4) or (n, 6), of float64 or
       float32, in either byte order. The shape (0, 4) is an empty set.
A mesh, as `plumb check` reads it
       The boxes of its triangles.
Each of them packed by gzip
       As boxes.csv.gz; what other packers make is refused.)"},
           {"OUTPUTS", R"(
--all lists the pairs, --json has them as well. --out writes them as an
array of int64 of the shape (m, 2): the numbers of a and of b. Where
none of these is asked for, or --count is given, pairs are counted as
they are found and none is kept, so there may be any number; for these
outputs more than 100,000,000 are refused, which --most changes. (The
methods automatic, swept-columns, sort-and-sweep and brute-force find
them so; others keep all until they are found, so for them pairs are
counted first, and more than --most are refused in any case.)

--svg draws the boxes, in colors that say which of them meet others, and
over them what the method makes of them (of two sets, grids and trees
are made of the first): columns, cells of grids and of octrees, boxes of
trees, planes, heavier lines for larger ones; of what is sorted along an
axis how the boxes lie along it, beside the plan. The picture says in
words what its lines are. Boxes in space are seen along the shortest
axis, those in columns along the axis of the sweep. Of more than 20,000
boxes, or lines, some are drawn, and the picture says which.)"},
           {"METHODS", R"(
automatic
       The fastest, as measured.
swept-columns
       In the columns of a grid, swept along these.
sort-and-sweep
       Sorted along one axis and swept.
brute-force
       Each pair: quadratic.
static-grid, linked-grid, hashed-grid, implicit-grid
       Cells of one size, chosen from the boxes: slices of one array,
       lists, lists in a table, bits of rows and columns.
hierarchical-grid, row-column-grid
       Cells of all sizes, hashed or by rows and columns.
octree, octree-of-leaves, loose-octree
       Boxes in the smallest cell that holds them, in all leaves, or in
       cells that reach over their borders.
box-tree
       A bounding volume hierarchy, descended with itself.
lists-along-one, lists-along-two, lists-along-three
       Sorted lists of starts and ends along so many axes.
kd-tree
       Space divided by planes, boxes in all leaves that they meet.)"}},
          {{"EXIT STATUS", R"(
0      Done, also where no two boxes meet.
2      Bad input: wrong usage, a file that cannot be read or holds no
       boxes, an output that cannot be written. What was wrong stands on
       standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb pairs boxes.csv
       How many pairs there are.

plumb pairs --no-touching --out pairs.npy boxes.npy
       Those that overlap, for numpy.load.

plumb pairs --svg boxes.svg walls.csv part.stl
       The triangles' boxes against others, drawn.)"}}};
}

}  // namespace plumb::tool

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual plan_manual() {
  return {"plumb plan",
          "what do exact decisions on a scene need, and no more?",
          {"plumb plan [OPTION]... [MESH]..."},
          {{"DESCRIPTION", R"(
Reads all MESHes, files and folders as `plumb check` reads them, as one
scene and says what exact decisions on it need, and no more:

its lattice
       The largest power of two that divides every coordinate, and how
       many bits the coordinates then take; of each mesh alone as well,
       and what it alone would need less.
arithmetic
       For orient2d, orient3d, incircle and insphere the least
       arithmetic that holds every value on this lattice, the stages
       that then are never needed, and the arithmetic that a plan takes
       (class Kernel). With --all the plan of every predicate.
times
       Of a decision, in nanoseconds: by the bare formula, which may be
       wrong, by decide, by batches, and by the plan; "take" says which
       of decide and the plan took less. Decisions are some 8000 of
       those that `plumb check` takes.
coarser lattices
       Each one on which a predicate gets by with less. Every coordinate
       is snapped to the nearest multiple of the step. The greatest move
       of a coordinate is exact, and it is decided exactly which
       distinct points merge, which triangles collapse to zero area, and
       which are turned over, that is, by more than a right angle.
bounding volume
       For each mesh the kind that choose_bound takes with the times of
       overlap tests measured here; how often it overlaps where two
       copies of the mesh are placed at random, their spheres meeting;
       what a query is expected to take with the volume and without;
       "none" where that is no less.
tree of boxes
       For each mesh what three trees take to be built, and what a ray
       and a nearest triangle then take, by one thread; without a tree a
       ray looks at all triangles. "take" says from how many rays on
       which of them costs least, its build included.
volumes of a tree
       For each mesh how long it takes to find all triangles that meet
       those of a copy of it that is turned, by its tree of boxes and by
       trees of spheres, oriented boxes and 18-DOPs; how many tests of
       volumes and pairs of triangles that is.

The JSON also lists the plan of every predicate, the first hundred
points and triangles that each lattice damages, and all kinds of
volumes. Without a MESH it plans the one that the program brings along.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read, or is no
       mesh, an output that cannot be written. What was wrong
       stands on standard error.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb plan part.stl
       Would the part do with plain doubles, were it rounded to a grid?

plumb plan *.obj --chart plan.svg --json plan.json
       The plan of a scene of several parts, as a picture and as
       numbers.)"}}};
}

}  // namespace plumb::tool

#include "lab/chart/command.hpp"
#include "tool/manual/help_text.hpp"

namespace plumb::lab {

Manual chart_manual() {
  return {"plumb-lab chart",
          "what does exactness cost, and what does it buy?",
          {"plumb-lab chart [OPTION]..."},
          {{"DESCRIPTION", R"(
Puts the same questions to every method that software answers them by,
and says of each how often it is wrong and how long it takes.

A task is a question. Each is asked of several classes of inputs, from
harmless to exactly degenerate, and judged in GMP's rationals:

       orient2d, orient3d: on which side of a line, a plane is a point?
       incircle, insphere: is a point inside a circle, a sphere?
       ray-triangle, segment-triangle, triangle-triangle: do they meet?
       box-box, obb-obb: do boxes meet, along the axes, turned?
       point-in-polygon, point-in-polyhedron: is it in, or on the border?
       segment-segment: do segments of the plane meet?
       convex-convex: do the hulls of 8 and 8 points meet?
       hull-2d, hull-3d: which of 16, 12 points are corners of the hull?
       smallest-ball: how large is the smallest ball around 5 points?
       point-segment-distance, point-box-distance,
       point-triangle-distance, segment-segment-distance,
       convex-distance: how far apart? (hulls of 4 points each)
       vertex-face-motion, edge-edge-motion: do they meet while their
       vertices move linearly?
       closest-hit: which triangle of a mesh does a ray hit first?
       mesh-pairs, mesh-distance: which triangles of two meshes meet,
       how far are the meshes apart?
       closest-point-on-mesh: which triangle is nearest to a point?
       box-pairs: which boxes of a set overlap?
       nearest-point: which of many points is nearest to a place?
       grid-walk: which cells of a grid does a segment visit?
       triangulation: into which triangles does a polygon fall?
       welding: which vertices are one, joined by short steps?

wrong  The share of wrong answers; of numbers, of those that are not the
       nearest double.
unsure The share of questions to which the method knows that it has no
       answer. Those are not wrong.
inconsistent
       The share of questions that the method answers otherwise when
       the arguments are given in another order.
ulps   Of numbers, how many doubles lie between the answer and the
       nearest one: in the mean, and at most.
missed, wrong pairs, far off, false and missed pairs and cells, lost,
other area, overlapping
       Of meshes, many things and polygons, counts of what is worse than
       wrong: rays that hit nothing where there is something, pairs and
       cells too many or too few, distances off by more than 1e-4,
       triangles that lack a vertex, cover another area than the
       polygon's or overlap. Of triangles and points that are equally
       first or near each is right.
ns     Nanoseconds a question, on one thread: the least of a few rounds.
allocations
       How often memory is asked for, a question.

With --out DIR the same is written into that folder: chart.txt,
chart.json (with machine, compiler, flags and date), a picture for each
task and class, TASK-CLASS.svg, of the wrong share (of numbers, the mean
error in ulps, with a thin line up to the largest) against time, whose
dashed line joins the methods that no other beats in both; and
chart.html, a page that needs no network: a summary of tasks by methods,
then all charts, to be filtered, folded where no
answer is wrong.)"},
           {"METHODS", R"(
float32        Single precision, of coordinates rounded to it.
double         The formula, or the code, as it is commonly written.
absolute       As double, with an epsilon: at most 1e-9 counts as zero.
relative       As double, with an epsilon of 1e-9 of the terms' size or,
               where code branches, of the largest coordinate.
long-double    The same in the compiler's long double.
float128       Quadruple precision, in software.
compensated    Pairs of doubles that keep each rounding's error.
interval       Interval arithmetic alone.
static-filter  Double against one bound for all inputs.
adaptive       Adaptive expansions of doubles, as in the literature;
               where code branches, intervals, then expansions.
integers       Integers of any length, always; where code divides, their
               fractions.
rationals      GMP's rationals, always.
advancement    Conservative advancement, of what moves.
recomputed     As double, with each parameter divided for anew.
grid, hashing, first-come
               Vertices rounded to multiples of the tolerance, by their
               bits, each to the first that is near.
plan           Ours, in the arithmetic that the inputs' lattice needs.
exact          Ours, one question at a time.
batch          Ours, over spans, on one thread.
columns, sweep, brute-force
               Ours, by that method of the broad phase.

Not every task has every method: docs/charts.md says why.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a task or class that does not exist, a
       folder that cannot be written to. What was wrong stands on
       standard error, and nothing is left half written.)"},
           {"ENVIRONMENT", R"(
NO_COLOR
       When set to anything, no colors. Without it, colors are used only
       where the output is a terminal.)"},
           {"EXAMPLES", R"(
plumb-lab chart --quick --task orient2d --class near_half
       One table, in a moment.

plumb-lab chart --out report
       Everything, in minutes.)"}}};
}

}  // namespace plumb::lab

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual nearest_manual() {
  return {
      "plumb nearest",
      "which points are nearest to queries?",
      {"plumb nearest [OPTION]... [-k N] POINTS QUERIES", "plumb nearest [OPTION]... --within RADIUS POINTS QUERIES"},
      {{"DESCRIPTION", R"(
Finds for each point of QUERIES the N points of POINTS that are nearest
to it, nearest first, or all that are within a radius, in the order of
their numbers, and how far away they are.

Nearer means nearer in real arithmetic: no two distances are taken for
equal that differ, and none is rounded before it is compared. Of points
that are exactly as near the one with the lower number comes first;
--ties tells all that are as near as the last one asked for. The ball
of --within is closed: what is exactly so far away is in it. A distance
is the double nearest to the exact one (inf, in JSON null, where that is
beyond all doubles). Points are numbered from 0 in the order of the
file.)"},
       {"FILES", R"(
CSV
       A point on a line, as two numbers in the plane or three in space,
       with commas, semicolons or blanks between them. Empty lines, what
       follows '#' and a header are passed over; a header that names x,
       y or z has no other names and the order x, y, z, or it is
       refused. A number stands for its nearest double, and it is said
       how many are none.
.npy
       An array of NumPy of the shape (n, 2) or (n, 3), of float64 or
       float32, in either byte order.
.xyz
       Text as above, in space; what follows the first three numbers of
       a line, a normal or a color, is passed over.
A mesh or a cloud of points (PLY, OBJ, OFF), as `plumb check` reads it
       Its vertices; no face is needed.
Each of them packed by gzip
       As points.csv.gz; what other packers make is refused.)"},
       {"OUTPUTS", R"(
--out writes the points' numbers as an array of int64, --distances the
distances as one of float64, both of the shape (queries, N). With --ties
and --within queries have different numbers of answers: then --out has
the shape (m, 2), a query and a point in each row, and --distances the
shape (m,). --json has both, as a list for each query. More than
100,000,000 answers are refused for these, for --svg and for --all,
which --most changes; without them the first ten are kept and the
others are counted, and so there may be any number.

--svg draws the planes of the k-d tree that is searched, the points and
the queries, with lines to what is nearest; points in space are seen
along their shortest axis. It is a picture of a small tree: the planes
of 8 levels, 20,000 points, 200 queries and 5,000 lines to what is near
to them at the most, and it says what is left out.)"}},
      {{"EXIT STATUS", R"(
0      Done.
2      Bad input: wrong usage, a file that cannot be read or holds no
       points, fewer points than are asked for, an output that cannot be
       written. What was wrong stands on standard error.)"},
       {"ENVIRONMENT", environment()},
       {"EXAMPLES", R"(
plumb nearest stations.csv places.csv
       The nearest station to each place.

plumb nearest -k 8 --out near.npy --distances far.npy a.npy a.npy
       Eight neighbors of each point, itself among them, for numpy.load.

plumb nearest --within 0.5 --all part.stl probes.csv
       The vertices of a mesh that are near to probes.)"}}};
}

}  // namespace plumb::tool

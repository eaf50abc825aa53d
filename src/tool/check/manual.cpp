#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual check_manual() {
  return {"plumb check",
          "is a mesh sound, and where do floats err on it?",
          {"plumb check [OPTION]... [MESH]...", "plumb check --shard I/N --out DIR [OPTION]... FOLDER",
           "plumb check --write-sample FILE"},
          {{"DESCRIPTION", R"(
Reads each MESH (OBJ, OFF, STL, PLY, 3MF, glTF; text or binary; also
packed by gzip), every mesh in a folder and the folders in it, or
standard input where MESH is '-'. Text that has no meaning in a mesh's
format is passed over and told; --strict refuses it, and --lenient
reads files that break their format a little.

Of each it opens with a verdict in four lines: what surface the mesh is,
what is wrong with it, which methods then take which signs wrong, and
what to do about both. Each line is printed as soon as it is known. The
tables follow: the mesh's size, its shells, its lattice (the largest
power of two that divides every coordinate, and how many bits the
coordinates then take), repeated vertices, triangles of exactly zero
area and non-manifold edges, then the decisions.

Of the surface is said, and decided exactly, whether it is

       closed: every edge is in an even number of triangles;

       oriented: at every edge as many triangles run along it one way as
       the other, but for one where their number is odd. Where every
       shell is inside out (see DEFECTS) it is oriented inward;

       free of self-intersections: no two triangles have a point in
       common beyond the vertices that they share. `plumb intersect`
       lists those that do. Vertices are shared that have the same
       number: where a mesh repeats its vertices, that is said, for
       triangles that meet there share none, and touch;

       free of degenerate triangles: none has exactly zero area.

A shell is a connected component of the triangles over edges of exactly
two. Where there are several, the report says how many; it lists each
with its volume (exact, rounded once), the closed shell that it lies in,
and whether it touches or crosses another. All of it is decided exactly.
--brief says of each mesh what it is and what is wrong with it in one
line, and leaves out what floats get wrong.

Then it takes the decisions that mesh software takes:

       orient3d, for every edge of two faces: is it convex, flat or
       reflex, and are the vertices opposite to it coplanar with it?
       For every face: on which side of it are sixteen fixed points
       (the corners of the mesh's box, and eight vertices)?

       insphere, for every flat edge: is it locally Delaunay in its
       plane, that is, is one opposite vertex outside the circle of the
       other face? For every other edge: is a neighboring vertex in the
       sphere through its two faces?

       orient2d and incircle, on the projections along the three axes:
       how does each face turn, and is each edge locally Delaunay?

Which edges are flat is decided exactly. The decisions are then taken
by every method; the exact one is the judge. Of more than 100,000
decisions of a kind, the methods that may be wrong or unsure are asked
that many, drawn over the whole mesh and the same in every run; plan and
exact always take all. --all asks every method everything.

Without a MESH it checks the one that it brings along: a bolted flange,
turned by an angle that no lattice likes, with the defects of real
files.)"},
           {"DEFECTS", R"(
What --fail-on-defect takes, and the report counts:

open
       An edge is in an odd number of triangles.
unoriented
       Of the triangles at an edge more run along it one way than the
       other, by two at least.
inside-out
       A closed shell has negative volume, and lies in no other or in an
       even number of others; or positive volume, and lies in an odd
       number: a cavity is wound inward. The report says which shells
       are to be turned.
self-intersecting
       Two triangles have a point in common beyond the vertices that
       they share.
degenerate
       A triangle has exactly zero area.
non-manifold-edge
       An edge is in more than two triangles.
non-manifold-vertex
       The triangles at a vertex are several fans, which share no edge
       there: two cones that meet at their tips.
vertex-on-edge
       A vertex is on an edge, between its ends: a T-junction.
duplicate
       A triangle has the same three points as another, and turns the
       same way.
opposite
       A triangle has the same three points as another, and turns the
       other way.
internal-wall
       A shell that is not closed lies inside of a solid, or divides one.
crossing-shells
       A shell passes through another.
close-vertices
       A vertex is nearer to another than the LENGTH of --nearer-than,
       and not equal to it. The distance is compared exactly.)"},
           {"SHARDS", R"(
plumb check FOLDER --shard I/N --out DIR
       Checks the I-th of N parts of the meshes in a folder, each by a
       process of its own, and writes a line of JSON for each into
       DIR/check.I-of-N.jsonl: its name below the folder, a verdict,
       its defects and how many there are of each fault. Floats are not
       asked. In which part a mesh is follows from its name alone.

A run that was stopped, in whatever way, goes on when it is started
again: no mesh is left out or twice there. Two runs of one part wait for
one another. A file that is there and was begun for another folder, with
other options or by another version is refused. The verdicts are

       sound: it has none of the DEFECTS;

       faulty: it has one;

       unreadable: it cannot be read, and 'why' says why;

       timeout: it took longer than --time-limit allows;

       out_of_memory: its process needed more than --memory-limit has,
       in address space beyond that of the program, or all there is;

       crashed: its process ended in another way; 'why' says how.

Each process has one thread, unless --threads says otherwise. The exit
status is 0 where every mesh has its line, whatever is in it.)"},
           {"METHODS", R"(
float32
       The formula in single precision, on coordinates rounded to it.
double
       The same formula in double precision.
absolute
       As double, but a value of at most 1e-9 in magnitude is zero.
relative
       As double, but a value is zero when its magnitude is at most 1e-9
       times the largest difference of a coordinate to that of the last
       point, to the power of the formula's degree (2 for orient2d, 3
       for orient3d, 4 for incircle, 5 for insphere).
long-double
       The same formula in the compiler's long double.
interval
       Interval arithmetic alone: never wrong, at times unsure.
plan
       The signs of this library with the plan of the mesh's lattice:
       the cheapest arithmetic that is exact for all of its
       coordinates.
exact
       The signs of this library: never wrong, never unsure.

For each method and predicate the report counts the decisions, the
wrong ones and their share, and of the wrong ones those of opposite
sign, zeros missed (a zero taken for a sign) and zeros invented (a sign
taken for zero); then unsure answers, and the nanoseconds a decision
takes; for the exact method also the share that each stage decided. The
worst case of each method is printed as a line that `plumb sign` takes.)"}},
          {{"EXIT STATUS", exit_status("A sign was wrong: one of a METHOD that --fail-on-wrong names, or\n       an "
                                       "exact one that --verify refuted. Or a mesh has a DEFECT that\n       "
                                       "--fail-on-defect names.") +
                               R"(
       `plumb check` of a folder still writes its reports where meshes in
       the folder could not be read, and names these in them.)"},
           {"ENVIRONMENT", environment()},
           {"EXAMPLES", R"(
plumb check --quiet --fail-on-defect open part.stl
       Whether a part is closed, for a script.

plumb check --brief parts
       One line for each mesh in a folder.

plumb check part.stl --json report.json --chart chart.svg
       The report on the terminal, as JSON and as a picture.

plumb check --verify --fail-on-wrong exact part.ply
       Exits with 1 should the exact signs ever differ from those of
       rational arithmetic.

curl --silent https://example.org/part.stl.gz | plumb check -
       The report on what another program hands over.

plumb check parts --json=report.json
       The report on every mesh in a folder.

plumb check parts --shard 3/10 --out found --time-limit 60
       The third of ten parts of a folder, a line for each mesh.

plumb check --write-sample flange.obj
       Writes the mesh that the program brings along.)"}}};
}

}  // namespace plumb::tool

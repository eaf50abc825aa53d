#include "tool/manual/help_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "plumb/certify/catalog.hpp"
#include "tool/manual/meanings.hpp"

namespace plumb::tool {
namespace {

const std::string kBadInput = R"(
2      Bad input: wrong usage, a file that cannot be read or is no mesh,
       an output that cannot be written. What was wrong stands on
       standard error, and no output was touched.)";

/// What the status 1 means differs; its text comes without the number.
std::string exit_status(std::string_view one) { return fmt::format("0      Done.\n1      {}{}", one, kBadInput); }

const std::string kEnvironment = R"(
NO_COLOR
       When set to anything, no colors. Without it, colors are used only
       where the output is a terminal.)";

/// The words in lines of at most `width` columns, the later ones with blanks in front.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string lines, word;
  std::size_t column = 0;
  std::istringstream words{std::string(text)};
  while (words >> word) {
    if (column + word.size() + 1 > width) {
      lines.append("\n").append(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

/// " ax ay az", " a" for a number by itself, " a1 a2 a3 a4" where there are more than letters.
std::string words_of(const CatalogEntry& entry, std::size_t argument) {
  const auto letter = static_cast<char>('a' + argument);
  const auto count = static_cast<std::size_t>(entry.arguments[argument]);
  if (count == 1) return fmt::format(" {}", letter);
  std::string words;
  for (std::size_t i = 0; i < count; ++i) {
    words +=
        count <= entry.axes.size() ? fmt::format(" {}{}", letter, entry.axes[i]) : fmt::format(" {}{}", letter, i + 1);
  }
  return words;
}

/// "orient2d ax ay bx by cx cy", and what it means.
std::string predicates() {
  std::string text;
  for (const CatalogEntry& entry : catalog()) {
    std::string call(entry.name);
    for (std::size_t argument = 0; argument < entry.arguments.size(); ++argument) call += words_of(entry, argument);
    text += text.empty() ? "" : "\n";
    text += wrapped(call, 72, 4);
    if (const auto meaning = meaning_of(entry.name); !meaning.empty()) {
      text += "\n       " + wrapped(meaning, 64, 7);
    }
  }
  return text;
}

}  // namespace

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

chart
       Holds the ways of answering geometric questions against each
       other: how often each is wrong, and how long it takes.

check [MESH]...
       Takes the decisions that mesh software takes on these meshes, in
       floating point and exactly, and says where floating point errs.

convert FROM TO
       Writes a mesh file in another format, every coordinate the same
       double.

fuzz
       Finds inputs on which a function of another library is wrong, and
       makes them small.

plan [MESH]...
       Says what exact decisions on a scene of these meshes need, what a
       coarser lattice would save and do to them, and which bounding
       volumes are the cheapest.

section --plane PLANE MESH
       Cuts a mesh by planes into exact contours, and draws them.

sign PREDICATE COORDINATE...
       Decides one sign exactly and says which stage decided it.

proof PREDICATE
       Writes the error bound behind a predicate's filter as a claim that
       a machine can check.

stability
       Runs geometric algorithms on inputs that break them, and says what
       one sees of it: a hull lost a corner, a loop did not end.

vectors
       Writes test vectors for other programs: inputs with their exact
       answers, in text files.

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
one that is a mesh by its name or content, nor anything by a sample.
'-' is standard output, which then has that output alone.)"},
           {"ENVIRONMENT", kEnvironment},
           {"EXAMPLES", R"(
plumb check
       The check on the mesh that the program brings along.

plumb sign orient2d 0 0 1 0 0 1
       Prints "+ filter": the points turn counterclockwise.)"}}};
}

Manual check_manual() {
  return {"plumb check",
          "how often is floating point wrong on a mesh, and where?",
          {"plumb check [OPTION]... [MESH]...", "plumb check --write-sample FILE"},
          {{"DESCRIPTION", R"(
Reads each MESH (OBJ, OFF, STL, PLY, 3MF, glTF; text or binary; also
packed by gzip), every mesh in a folder and the folders in it, or
standard input where MESH is '-'. Of each it opens with a verdict in
three lines: what is wrong with the mesh, which methods then take which
signs wrong, and what to do about both. Each line is printed as soon as
it is known. The tables follow: the mesh's size, its lattice (the
largest power of two that divides every coordinate, and how many bits
the coordinates then take), repeated vertices, triangles of exactly zero
area and non-manifold edges, then the decisions.

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
                                       "exact one that --verify refuted.")},
           {"ENVIRONMENT", kEnvironment},
           {"EXAMPLES", R"(
plumb check part.stl --json report.json --chart chart.svg
       The report on the terminal, as JSON and as a picture.

plumb check --verify --fail-on-wrong exact part.ply
       Exits with 1 should the exact signs ever differ from those of
       rational arithmetic.

curl --silent https://example.org/part.stl.gz | plumb check -
       The report on what another program hands over.

plumb check parts --json=report.json
       The report on every mesh in a folder.

plumb check --write-sample flange.obj
       Writes the mesh that the program brings along.)"}}};
}

Manual sign_manual() {
  return {"plumb sign",
          "decide signs exactly",
          {"plumb sign PREDICATE COORDINATE...", "plumb sign < CASES"},
          {{"DESCRIPTION", R"(
Prints the sign of PREDICATE at the points whose coordinates follow,
point after point: '+', '0' or '-', then the stage that decided.
Coordinates are decimal (0.1, -3e-7) or hexadecimal (0x1.8p-3), and
stand for their nearest double; NaN and infinities are refused.

Without arguments, cases are read from standard input, one a line:

       PREDICATE COORDINATE... [= SIGN] [# remark]

Where the expected SIGN is given and is not the true one, the answer
says so and the exit status is 1. Blank lines and remarks are passed
over; after a bad line nothing more is read.)"},
           {"PREDICATES", predicates()},
           {"STAGES",
            fmt::format("In the order of their cost, each sure where it answers:\n{}.", fmt::join(stage_names, ", "))}},
          {{"EXIT STATUS", exit_status("A sign was not the one that its case expected.")}, {"EXAMPLES", R"(
plumb sign orient2d 0 0 1 0 0 1
       Prints "+ filter".

plumb sign orient2d -0.1 -0.2 0x1p-1 0.3 1e300 -1e-300
       Prints "- filter": signs are signs, not options.

echo 'incircle 0 0 1 0 1 1 0 1 = 0' | plumb sign
       Four corners of a square lie on one circle.)"}}};
}

Manual doctor_manual() {
  return {"plumb doctor",
          "is this machine as the proofs assume?",
          {"plumb doctor"},
          {{"DESCRIPTION", R"(
Exact signs rest on IEEE-754 doubles, rounded to nearest, with
subnormals, without fused or reordered operations. This command looks
whether that holds here, and prints the version, the build and the
instruction sets at hand: what a bug report should contain.)"}},
          {{"EXIT STATUS", R"(
0      Everything is as the proofs assume.
1      Something is not; the report names it and its mend.
2      Wrong usage, or the report could not be written.)"},
           {"ENVIRONMENT", kEnvironment}}};
}

}  // namespace plumb::tool

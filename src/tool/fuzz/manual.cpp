#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual fuzz_manual() {
  return {"plumb fuzz",
          "on which inputs is a geometric function wrong?",
          {"plumb fuzz --kind KIND --library FILE --symbol NAME [OPTION]...", "plumb fuzz --list [--kind KIND]"},
          {{"DESCRIPTION", R"(
Loads a C function from a shared library and asks it what geometric
programs ask: harmless cases, exactly degenerate ones, such that are so
but for an ulp, huge and tiny ones, and changed ones. Each answer is
held against the exact one. Of each sort of failure a case of every
generator is made as simple as it can be while the failure stays. The
simplest is printed with a line that asks it again.

Without a budget each generator gives 1000 cases. --cases gives another
number, --time asks until the time is up; of both, whichever ends first.

The function runs in a process of its own. That it crashes, takes longer
than --timeout, exits, or throws an exception, is a finding like a wrong
answer: the process is replaced, and the run goes on. What the function
prints goes nowhere, writing to files fails, and each argument ends
where readable memory ends, so that reading too far is a crash. After
1000 crashes or 10 hangs the run ends and reports.

asked  How many cases the generator has given.
wrong  Answers that are not the exact one; of numbers, more than --ulps
       doubles and --relative away from it.
failed Calls that did not end in an answer: crashed, hung, exited or
       threw.
share  Of wrong and failed among asked.
degenerate
       How many of wrong and failed had a degenerate figure: a triangle
       without area, a segment without length.
unsure Answers that are no number (NaN). Those are no findings.

Ctrl-C ends the asking; what was found so far is made simple and
reported. The second time it ends the simplifying, the third time the
program. With --time simplifying takes as long again at the most, or
ten seconds.

A predicate of 'plumb sign' is a kind by its name. For any other
question another function knows the answer, of the same signature:
--judge FILE:SYMBOL, which runs in a process of its own. With a kind that
there is, its answers are the right ones; a kind of your own has
--argument NAME:WHAT for each argument in turn, such as a:point2,
t:point3x3 (three points), poly:points2+3 (any number, three at least,
whose count follows), d:vector3, b:box3, r:length, ray:point3,vector3,
and --answer sign, yes-no or number. Where a judge answers NaN, nothing
is wrong; where it crashes, hangs or exits, the run ends. Its points are
hard ones, and degenerate together; frames of boxes and meshes are made
for the kinds alone that are listed.

With --corpus DIR the cases in that folder are asked first, also as
starting points of changed ones, and the simplest case of each finding
is added to it, in a file of its own.

What functions promise differs. --boundary out: figures without their
boundaries, so that touching is not meeting, and a point on an edge is
outside. --ends open: segments without their ends, a ray without its
origin. With any, neither is promised, and both answers are right.
--no-degenerate leaves out cases with degenerate figures, signs that are
zero, polygons that cross themselves, points of one plane.

What numbers a function is made for differs as well. --range X: none is
larger in magnitude. --smallest X: none but 0 is smaller. --grid X: all
are multiples of X, a power of two, such as 1 for integers. --bits N:
mantissas of N bits. Cases are scaled into the range as a whole, and
stay exactly degenerate where it has room for it. A finding's smallest
case is within the range too. Axes of boxes are not bound.

With --out DIR the report is written into that folder: fuzz.txt,
fuzz.json, a picture, fuzz.svg, a page, fuzz.html, which needs no
network and draws each finding, and each finding as a file: case-N.cpp
(a GoogleTest), case-N.py (a script that asks again and exits with 1
while the answer is wrong), case-N.obj. An older report there is
replaced.)"}},
          {{"EXIT STATUS", R"(
0      Nothing was found. With --case: the answer is right.
1      Something was found.
2      Bad input: wrong usage, a library that cannot be loaded, a symbol
       that is missing or no function, a folder that cannot be written
       to, a corpus file that holds no cases. What was wrong stands on
       standard error, and nothing is left half written.)"},
           {"ENVIRONMENT", R"(
NO_COLOR
       When set to anything, no colors. Without it, colors are used only
       where the output is a terminal. The progress has none, and stays.
TERM
       Where it is not set, or is "dumb": neither colors nor progress,
       which is otherwise shown while standard error is a terminal.)"},
           {"EXAMPLES", R"(
plumb fuzz --list
       Which kinds of functions there are, and their signatures in C.

plumb fuzz --kind orient3d --library ./libmine.so --symbol my_orient3d
       Where is it wrong?

plumb fuzz --kind triangle-triangle --library ./libmine.so \
           --symbol meet --time 60 --corpus cases --out report
       For a minute, beginning with what failed before.

plumb fuzz --kind point-in-polygon --library ./libmine.so \
           --symbol inside --boundary any --range 1e6 --grid 0x1p-10
       Only where nobody can say that it was not meant for that.)"}}};
}

}  // namespace plumb::tool

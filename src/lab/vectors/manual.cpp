#include "lab/vectors/command.hpp"
#include "tool/manual/help_text.hpp"

namespace plumb::lab {

Manual vectors_manual() {
  return {"plumb-lab vectors",
          "write test vectors: inputs with their exact answers",
          {"plumb-lab vectors --out DIR [--seed N]"},
          {{"DESCRIPTION", R"(
Writes one text file for each task into DIR. A line is a case: the
task's name, its numbers as hexadecimal doubles, '=' and the exact
answer, then after '#' the class of inputs that the case is from, and
which of the usual floating-point ways answer it wrongly: float32,
double, absolute and relative, as `plumb-lab chart --help` explains them.

Lines that begin with '#' are no cases; the first ones say what is
asked, what the numbers are, and how many cases each way gets wrong.

Files named of-any-size hold questions of any number of points or
triangles, each behind its count, and mark no ways.

Answers are computed in rational numbers. Of each class there are its
first cases, the first of each answer, and the first that each way gets
wrong, as far as there are any. The files depend on the seed alone.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Wrong usage, or a folder that cannot be written; then nothing in
       it has changed.)"},
           {"EXAMPLES", R"(
plumb-lab vectors --out vectors
       The files of docs/vectors.

plumb-lab vectors --out more --seed 7
       Others of the same classes.)"}}};
}

}  // namespace plumb::lab

#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual proof_manual() {
  return {"plumb proof",
          "have a machine check the bound of a predicate's filter",
          {"plumb proof PREDICATE [OPTION]...", "plumb proof --list"},
          {{"DESCRIPTION", R"(
The filter of a predicate takes the sign of a floating-point value when
it is beyond a constant times the magnitude of its terms. The constant
is derived from the predicate's formula when this program is compiled.
This command writes, from the same formula, what has to be true of the
very same constant, as a script for Gappa (Debian's package gappa),
which looks for a proof by itself.

The claim is, for differences of coordinates up to 1 in magnitude and
every operation rounded as IEEE doubles are: the computed value is
within the constant times the number of terms of the exact one, and
has the sign of the exact one when it is beyond that.)"},
           {"PROOF", R"(
gappa exits with 0 when it found the proof. With -Bcoq it writes the
proof for Coq, which needs Debian's packages coq and libcoq-gappa to
read it.)"}},
          {{"EXIT STATUS", R"(
0      Done.
2      Wrong usage, an unknown predicate, or an output that cannot be
       written. What was wrong stands on standard error.)"},
           {"EXAMPLES", R"(
plumb proof insphere | gappa && echo proved
       Has Gappa prove the bound of insphere.

plumb proof orient3d --every-scale --out orient3d.gappa
       Writes the claim that holds at every scale.)"}}};
}

}  // namespace plumb::tool
